#include "scene/simulation.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/parameter_entries.hpp"
#include "model/half_space_term.hpp"
#include "scene/parameters.hpp"
#include "scene/scene_mesh.hpp"
#include "scene/validation.hpp"
#include "solve/linear_solver_defaults.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// The names of a list's sublists, in order.
std::vector<std::string> sublists(const List& list) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(list))
    if (entry.isList()) names.push_back(name);
  return names;
}

/// An array of `count` numbers, or `fallback` where the user gave none.
std::vector<double> numbers(const List& list, const std::string& path, const char* name, std::size_t count,
                            std::vector<double> fallback) {
  const auto& values = list.get<Teuchos::Array<double>>(name);
  if (values.empty()) return fallback;
  if (static_cast<std::size_t>(values.size()) != count)
    throw InputError(fmt::format("{}/{} has {} elements, not {}; is the mesh of the dimension that the scene is of?",
                                 path, name, values.size(), count));
  return {values.begin(), values.end()};
}

/// Puts the list path before a message of the layers below.
template <class Function>
auto at(const std::string& path, const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

Material material(const List& list) {
  Material m;
  m.block = list.get<std::string>("Block");
  m.law = list.get<std::string>("Model") == "Neo-Hooke" ? ElasticLaw::NeoHooke : ElasticLaw::Linear;
  m.lame = lame_constants(list.get<double>("Young's Modulus"), list.get<double>("Poisson's Ratio"));
  m.density = list.get<double>("Density");
  m.mass_damping = list.get<double>("Mass Damping");
  m.stiffness_damping = list.get<double>("Stiffness Damping");
  return m;
}

HalfSpace half_space(const List& list, const std::string& path, std::size_t dimension) {
  HalfSpace wall;
  wall.normal = {};
  const auto point = numbers(list, path, "Point", dimension, std::vector<double>(dimension, 0.0));
  std::vector<double> up(dimension, 0.0);
  up.back() = 1;
  const auto normal = numbers(list, path, "Normal", dimension, up);
  double largest = 0;
  for (double n : normal) largest = std::max(largest, std::abs(n));
  if (!(largest > 0)) throw InputError(path + "/Normal is zero: it must point out of the wall");
  double square = 0;
  for (double n : normal) square += n / largest * (n / largest);
  for (std::size_t d = 0; d < dimension; ++d) {
    wall.point[d] = point[d];
    wall.normal[d] = normal[d] / largest / std::sqrt(square);
  }
  return wall;
}

void set_predictor(const std::string& name, Table& table) {
  if (name == "Last Displacement") table.predictor = Predictor::LastDisplacement;
  if (name == "Constant Velocity") table.predictor = Predictor::ConstantVelocity;
  if (name == "Constant Acceleration") table.predictor = Predictor::ConstantAcceleration;
}

void add_interaction(const List& list, const std::string& path, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(path + "/Side Set", [&] { return mesh.side_set(list.get<std::string>("Side Set")); });
  const VanDerWaals law(list.get<double>("Gamma L"), list.get<double>("Gamma W"));
  if (!std::isfinite(law.c1()) || !(law.c1() > 0) || !std::isfinite(law.c2()) || !(law.c2() > 0))
    throw InputError(
        fmt::format("{}: Gamma L and Gamma W are too extreme: c1 = {}, c2 = {}", path, law.c1(), law.c2()));
  const HalfSpace wall = half_space(list, path, static_cast<std::size_t>(mesh.dimension));
  auto term = make_half_space_term(mesh, mesh.side_sets[set], model.pattern(), law, wall,
                                   {list.get<int>("Surface Points"), list.get<double>("Step Margin")});
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  InteractionReport report;
  term->report(rest.data(), report);
  const double gap = model.space().minimum(report.least_gap);
  if (!(gap > 0))
    throw InputError(
        fmt::format("{}: the surface \"{}\" starts in or below the wall, least gap {:.6g}; it must be "
                    "positive",
                    path, list.get<std::string>("Side Set"), gap));
  model.add_interaction(std::move(term));
}

void add_boundary_condition(const List& list, const std::string& path, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(path + "/Node Set", [&] { return mesh.node_set(list.get<std::string>("Node Set")); });
  std::string components = list.get<std::string>("Components");
  if (components == "all") components = mesh.dimension == 2 ? "xy" : "xyz";
  for (char component : components) {
    const int d = component - 'x';
    if (d >= mesh.dimension)
      throw InputError(fmt::format("{}/Components: \"{}\" names z, but the scene has {} dimensions", path, components,
                                   mesh.dimension));
    for (int node : mesh.node_sets[set]) model.add_constraint({node * mesh.dimension + d, 0.0, 0.0});
  }
}

}  // namespace

Simulation::Simulation(const List& scene, const Comm& comm, const std::string& folder)
    : parameters_(validated(scene, scene_parameters())) {
  Teuchos::Time timer("setup", true);
  const List& control = parameters_.sublist("Time Integrator").sublist("Time Step Control");
  if (!(final_time() > control.get<double>("Initial Time")))
    throw InputError(fmt::format("Time Integrator/Time Step Control/Final Time: {} must be later than Initial Time, {}",
                                 final_time(), control.get<double>("Initial Time")));
  const double initial = control.get<double>("Initial Time");
  if (!(initial + time_step() > initial && final_time() - time_step() < final_time()))
    throw InputError(
        fmt::format("Time Integrator/Time Step Control/Time Step: {} is lost in rounding against the times {} "
                    "to {}",
                    time_step(), initial, final_time()));
  build_model(comm, folder);
  build_integrator();
  set_initial_state();
  setup_seconds_ = timer.stop();
}

double Simulation::final_time() const {
  return parameters_.sublist("Time Integrator").sublist("Time Step Control").get<double>("Final Time");
}

double Simulation::time_step() const {
  return parameters_.sublist("Time Integrator").sublist("Time Step Control").get<double>("Time Step");
}

void Simulation::build_model(const Comm& comm, const std::string& folder) {
  Mesh mesh;
  together<InputError>(comm, [&] { mesh = scene_mesh(parameters_.sublist("Mesh"), folder); });
  const int ranks = comm->getSize();
  std::vector<Material> materials;
  const List& list = parameters_.sublist("Materials");
  for (const std::string& name : sublists(list)) materials.push_back(material(list.sublist(name)));
  model_ = at("Materials", [&] {
    return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm,
                                   materials);
  });
  for (const std::string& name : sublists(parameters_.sublist("Interactions")))
    add_interaction(parameters_.sublist("Interactions").sublist(name), "Interactions/" + name, *model_);
  for (const std::string& name : sublists(parameters_.sublist("Boundary Conditions")))
    add_boundary_condition(parameters_.sublist("Boundary Conditions").sublist(name), "Boundary Conditions/" + name,
                           *model_);
}

void Simulation::build_integrator() {
  const List& list = parameters_.sublist("Time Integrator");
  const Scheme& chosen = scheme(list.get<std::string>("Type"));
  const List& newton = parameters_.sublist("Nonlinear Solver");
  const NewtonOptions options{newton.get<double>("Tolerance"), newton.get<int>("Maximum Iterations"),
                              newton.sublist("NOX")};
  const ProblemSize size{model_->mesh().dimension, model_->space().global(), model_->space().comm()->getSize()};
  List& linear = parameters_.sublist("Linear Solver");
  linear = completed_linear_solver(linear, size);
  Table table = chosen.table(list.sublist(chosen.name));
  set_predictor(list.get<std::string>("Predictor"), table);
  try {
    check(table);
  } catch (const std::invalid_argument& error) {
    throw InputError("Time Integrator/" + chosen.name + ": " + error.what());
  }
  integrator_ = std::make_unique<Integrator>(*model_, std::move(table),
                                             std::make_shared<LinearSolverFactory>(linear, model_.get()), options);
}

void Simulation::set_initial_state() {
  const LocalMesh& mesh = model_->mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const List& list = parameters_.sublist("Initial Conditions");
  const std::string path = "Initial Conditions";
  const std::vector<double> zero(d, 0.0);
  const auto uniform = numbers(list, path, "Velocity", d, zero);
  const auto gradient = numbers(list, path, "Velocity Gradient", d * d, std::vector<double>(d * d, 0.0));
  const auto origin = numbers(list, path, "Origin", d, zero);
  std::vector<double> u(static_cast<std::size_t>(model_->space().local()), 0.0);
  std::vector<double> v(u.size());
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
    for (std::size_t i = 0; i < d; ++i) {
      double sum = uniform[i];
      for (std::size_t j = 0; j < d; ++j) sum += gradient[i * d + j] * (mesh.coordinates[node * d + j] - origin[j]);
      v[node * d + i] = sum;
    }
  const double time = parameters_.sublist("Time Integrator").sublist("Time Step Control").get<double>("Initial Time");
  at("Initial Conditions", [&] {
    integrator_->initialize(std::move(u), std::move(v), time);
    return 0;
  });
}

}  // namespace ixos

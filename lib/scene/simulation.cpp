#include "scene/simulation.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "checkpoint/fingerprint.hpp"
#include "mesh/level_width.hpp"
#include "model/half_space_term.hpp"
#include "scene/conditions.hpp"
#include "scene/histories.hpp"
#include "scene/list_access.hpp"
#include "scene/parameters.hpp"
#include "scene/scene_mesh.hpp"
#include "scene/validation.hpp"
#include "solve/linear_solver_defaults.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

Formulation formulation(const List& material) {
  const auto& name = material.get<std::string>("Element Formulation");
  if (name == "Mean Dilatation") return Formulation::MeanDilatation;
  return name == "Enhanced" ? Formulation::Enhanced : Formulation::Standard;
}

bool all_standard(const List& materials) {
  const std::vector<std::string> names = sublists(materials);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return formulation(materials.sublist(name)) == Formulation::Standard;
  });
}

Material material(const List& list) {
  Material m;
  m.block = list.get<std::string>("Block");
  m.law = list.get<std::string>("Model") == "Neo-Hooke" ? ElasticLaw::NeoHooke : ElasticLaw::Linear;
  m.lame = lame_constants(list.get<double>("Young's Modulus"), list.get<double>("Poisson's Ratio"));
  m.density = list.get<double>("Density");
  m.mass_damping = list.get<double>("Mass Damping");
  m.stiffness_damping = list.get<double>("Stiffness Damping");
  m.points = list.get<int>("Quadrature Points");
  m.formulation = formulation(list);
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
  if (name == "Newmark") table.predictor = Predictor::Newmark;
  if (name == "Extrapolation") table.predictor = Predictor::Extrapolation;
}

void add_interaction(const List& list, const std::string& path, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(path + "/Side Set", [&] { return mesh.side_set(list.get<std::string>("Side Set")); });
  const VanDerWaals law(list.get<double>("Gamma L"), list.get<double>("Gamma W"));
  if (!std::isfinite(law.c1()) || !(law.c1() > 0) || !std::isfinite(law.c2()) || !(law.c2() > 0))
    throw InputError(
        fmt::format("{}: Gamma L and Gamma W are too extreme: c1 = {}, c2 = {}", path, law.c1(), law.c2()));
  const auto cutoff = list.get<double>("Cutoff");
  if (cutoff > 0 && !(cutoff > law.adhesion_gap()))
    throw InputError(
        fmt::format("{}/Cutoff: {} cuts the attraction off; it must be greater than the gap of largest "
                    "attraction, {:.6g}, or 0",
                    path, cutoff, law.adhesion_gap()));
  const HalfSpace wall = half_space(list, path, static_cast<std::size_t>(mesh.dimension));
  auto terms = make_half_space_terms(mesh, mesh.side_sets[set], model.pattern(), law, wall,
                                     {list.get<int>("Surface Points"), cutoff, list.get<double>("Step Margin")});
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  InteractionReport report;
  for (const auto& term : terms) term->report(rest.data(), report);
  const double gap = model.space().minimum(report.least_gap);
  if (!(gap > 0))
    throw InputError(
        fmt::format("{}: the surface \"{}\" starts in or below the wall, least gap {:.6g}; it must be "
                    "positive",
                    path, list.get<std::string>("Side Set"), gap));
  for (auto& term : terms) model.add_interaction(std::move(term));
}

}  // namespace

Simulation::Simulation(const List& scene, const Comm& comm, const std::string& folder)
    : parameters_(validated(scene, scene_parameters())) {
  Teuchos::Time timer("setup", true);
  const StepControlOptions control = step_control();
  if (!(control.final_time > control.initial_time))
    throw InputError(fmt::format("Time Integrator/Time Step Control/Final Time: {} must be later than Initial Time, {}",
                                 control.final_time, control.initial_time));
  if (!(control.initial_time + control.time_step > control.initial_time &&
        control.final_time - control.time_step < control.final_time))
    throw InputError(
        fmt::format("Time Integrator/Time Step Control/Time Step: {} is lost in rounding against the times {} "
                    "to {}",
                    control.time_step, control.initial_time, control.final_time));
  Table table = chosen_table();
  check_adaptive(table);
  check_cutoff(table);
  check_formulations(table);
  build_model(comm, folder, table.mass);
  build_integrator(std::move(table));
  set_initial_state();
  setup_seconds_ = timer.stop();
}

StepControlOptions Simulation::step_control() const {
  const List& list = parameters_.sublist("Time Integrator").sublist("Time Step Control");
  StepControlOptions options;
  options.initial_time = list.get<double>("Initial Time");
  options.final_time = list.get<double>("Final Time");
  options.time_step = list.get<double>("Time Step");
  options.maximum_cuts = list.get<int>("Maximum Cuts");
  options.minimum_step = list.get<double>("Minimum Time Step");
  for (const char* name : {"History Time Interval", "Fields Time Interval"})
    if (const double interval = parameters_.sublist("Output").get<double>(name); interval > 0)
      options.output_intervals.push_back(interval);
  if (list.get<std::string>("Type") == "Fixed") return options;
  const List& adaptive = list.sublist("Adaptive");
  options.adaptive = {true,
                      adaptive.get<double>("Tolerance"),
                      adaptive.get<double>("Maximum Gap Ratio"),
                      adaptive.get<bool>("Choose Time Points"),
                      adaptive.get<double>("Safety"),
                      adaptive.get<double>("Largest Growth")};
  if (const double longest = adaptive.get<double>("Maximum Time Step"); longest > 0) options.maximum_step = longest;
  return options;
}

void Simulation::check_adaptive(const Table& table) const {
  const AdaptiveOptions asked = step_control().adaptive;
  const std::string path = "Time Integrator/Time Step Control/Adaptive";
  if (!asked.on) return;
  if (asked.tolerance == 0 && asked.gap_ratio == 0)
    throw InputError(path + ": neither Tolerance nor Maximum Gap Ratio is given; one must be greater than 0");
  if (asked.gap_ratio > 0 && !(asked.gap_ratio > 1))
    throw InputError(path + "/Maximum Gap Ratio: must be greater than 1");
  if (asked.tolerance > 0 && table.error_constant == 0)
    throw InputError(path + "/Tolerance: the scheme \"" + table.name + "\" has no estimate of its local error; use 0");
  if (asked.gap_ratio > 0 && sublists(parameters_.sublist("Interactions")).empty())
    throw InputError(path + "/Maximum Gap Ratio: the scene has no interaction; use 0");
  if (asked.time_points && table.interaction_points == 0)
    throw InputError(path + "/Choose Time Points: the scheme \"" + table.name +
                     "\", as it is set, has no points in time of the interaction that could be chosen");
}

void Simulation::check_cutoff(const Table& table) const {
  const bool exact = std::any_of(table.stages.begin(), table.stages.end(),
                                 [](const Stage& stage) { return stage.interaction.mean == Mean::Exact; });
  for (const std::string& name : sublists(parameters_.sublist("Interactions")))
    if (exact && parameters_.sublist("Interactions").sublist(name).get<double>("Cutoff") > 0)
      throw InputError("Interactions/" + name + "/Cutoff: the scheme \"" + table.name +
                       "\", as it is set, takes the exact mean of the interaction, which needs its whole range; use 0, "
                       "or Interaction Points of at least 1");
}

void Simulation::check_formulations(const Table& table) const {
  const bool discrete = std::any_of(table.stages.begin(), table.stages.end(),
                                    [](const Stage& stage) { return stage.elastic.mean == Mean::DiscreteGradient; });
  for (const std::string& name : sublists(parameters_.sublist("Materials"))) {
    const List& list = parameters_.sublist("Materials").sublist(name);
    const Formulation chosen = formulation(list);
    const std::string path = "Materials/" + name;
    if (discrete && chosen != Formulation::Standard)
      throw InputError(path + "/Element Formulation: \"" + list.get<std::string>("Element Formulation") +
                       "\" has no discrete gradient, which the scheme \"" + table.name +
                       "\" takes of the elastic energy; use \"Standard\", or the scheme \"Average Vector Field\"");
    if (chosen == Formulation::Enhanced && list.get<int>("Quadrature Points") < 2)
      throw InputError(path + "/Quadrature Points: 1 does not see the modes of \"Enhanced\" elements; use at least 2");
  }
}

std::vector<std::string> Simulation::reactions() const {
  const auto& names = parameters_.sublist("Output").get<Teuchos::Array<std::string>>("Reactions");
  return {names.begin(), names.end()};
}

StopCriteria Simulation::stop_criteria() const {
  return {parameters_.sublist("Time Integrator").sublist("Stop"), probes_, *model_};
}

Table Simulation::chosen_table() const {
  const List& list = parameters_.sublist("Time Integrator");
  const Scheme& chosen = scheme(list.get<std::string>("Type"));
  try {
    Table table = chosen.table(list.sublist(chosen.name));
    set_predictor(list.get<std::string>("Predictor"), table);
    check(table);
    return table;
  } catch (const std::invalid_argument& error) {
    throw InputError("Time Integrator/" + chosen.name + ": " + error.what());
  }
}

std::vector<int> Simulation::partition(const Mesh& mesh, int ranks, Inertia inertia) const {
  if (ranks == 1) return partition_nodes(mesh, ranks);
  const List& interactions = parameters_.sublist("Interactions");
  std::vector<std::string> contact;
  for (const std::string& name : sublists(interactions))
    contact.push_back(interactions.sublist(name).get<std::string>("Side Set"));
  // An explicit step solves nothing; of an implicit one the residual is a few per cent.
  return partition_nodes(mesh, ranks, node_work(mesh, contact, inertia == Inertia::Lumped ? 0 : 500));
}

void Simulation::build_model(const Comm& comm, const std::string& folder, Inertia inertia) {
  Mesh mesh;
  together<InputError>(comm, [&] {
    mesh = scene_mesh(parameters_.sublist("Mesh"), folder);
    enrich_surfaces(parameters_.sublist("Interactions"), mesh);
  });
  mesh_fingerprint_ = fingerprint(mesh);
  if (mesh.dimension == 3) level_width_ = mean_level_width(mesh);
  const int ranks = comm->getSize();
  std::vector<Material> materials;
  const List& list = parameters_.sublist("Materials");
  for (const std::string& name : sublists(list)) materials.push_back(material(list.sublist(name)));
  model_ = at("Materials", [&] {
    return std::make_unique<Model>(localize(mesh, partition(mesh, ranks, inertia), comm->getRank(), ranks), comm,
                                   materials, inertia);
  });
  for (const std::string& name : sublists(parameters_.sublist("Interactions")))
    add_interaction(parameters_.sublist("Interactions").sublist(name), "Interactions/" + name, *model_);
  const StepControlOptions control = step_control();
  const Histories histories(parameters_.sublist("Histories"), control.initial_time, control.final_time);
  add_conditions(parameters_.sublist("Boundary Conditions"), histories, *model_);
  probes_ = find_probes(parameters_.sublist("Output").sublist("Probes"), *model_);
  const std::vector<std::string> recorded = reactions();
  for (const std::string& name : recorded) {
    if (std::count(recorded.begin(), recorded.end(), name) > 1)
      throw InputError("Output/Reactions: the node set \"" + name + "\" is given twice");
    const std::size_t set = at("Output/Reactions", [&] { return model_->mesh().node_set(name); });
    const int d = model_->mesh().dimension;
    double held = 0;
    for (int node : model_->mesh().node_sets[set])
      for (int i = 0; i < d; ++i) held += model_->constraints().holds(node * d + i) ? 1 : 0;
    if (model_->space().maximum(held) == 0)
      throw InputError("Output/Reactions: no displacement of the node set \"" + name +
                       "\" is prescribed, so it has no reaction");
  }
}

void Simulation::build_integrator(Table table) {
  const List& newton = parameters_.sublist("Nonlinear Solver");
  const NewtonOptions options{newton.get<double>("Tolerance"), newton.get<int>("Maximum Iterations"),
                              newton.sublist("NOX"), newton.get<double>("Linear Tolerance")};
  const ProblemSize size{model_->mesh().dimension,
                         model_->space().global(),
                         model_->space().comm()->getSize(),
                         is_symmetric(table),
                         all_standard(parameters_.sublist("Materials")),
                         level_width_};
  const bool restartable = parameters_.sublist("Output").sublist("Checkpoint").get<int>("Keep") > 0;
  List& linear = parameters_.sublist("Linear Solver");
  linear = completed_linear_solver(linear, size);
  // An explicit step has no tangent; its stable length asks for the damping's matrix.
  if (linear.get<std::string>("Operator") == "Matrix-Free" && !is_explicit(table)) model_->do_without_matrices();
  integrator_ = std::make_unique<Integrator>(
      *model_, std::move(table), std::make_shared<LinearSolverFactory>(linear, model_.get(), restartable), options);
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
      // A derivative node has no place: the field's derivative along the boundary is L dX/ds.
      const double place = mesh.is_derivative(node) ? 0.0 : 1.0;
      double sum = place * uniform[i];
      for (std::size_t j = 0; j < d; ++j)
        sum += gradient[i * d + j] * (mesh.coordinates[node * d + j] - place * origin[j]);
      v[node * d + i] = sum;
    }
  const double time = step_control().initial_time;
  at("Initial Conditions", [&] {
    integrator_->initialize(std::move(u), std::move(v), time);
    return 0;
  });
}

}  // namespace ixos

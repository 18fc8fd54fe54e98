#include "model/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "discretization/nodal_measure.hpp"
#include "mesh/fitted_normal.hpp"

namespace ixos {
namespace {

/// One number for each local node.
using NodalNumbers = std::vector<double>;

/// Adds the load measure[node] * vector.
void add_load(Model& model, const NodalNumbers& measure, const std::vector<double>& vector,
              std::shared_ptr<const TimeFunction> history) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  if (vector.size() != d)
    throw InputError(
        fmt::format("a load's vector has {} components, but the mesh has {} dimensions", vector.size(), d));
  std::vector<double> forces(measure.size() * d);
  for (std::size_t a = 0; a < measure.size(); ++a)
    for (std::size_t i = 0; i < d; ++i) forces[a * d + i] = measure[a] * vector[i];
  model.space().condense(forces.data());
  model.loads().add(std::move(forces), std::move(history));
}

NodalNumbers no_measure(const Model& model) {
  return NodalNumbers(static_cast<std::size_t>(model.mesh().nodes()), 0.0);
}

/// Calls add(block) for the blocks of that name, or for all.
template <class Add>
void for_each_block(const LocalMesh& mesh, const std::string& name, const Add& add) {
  if (name.empty())
    for (const LocalBlock& block : mesh.blocks) add(block);
  else
    for (const std::size_t b : mesh.blocks_named(name)) add(mesh.blocks[b]);
}

/// Returns, by local node, the share of a block's volume that its mass has there: int N_a dV, or that of the lumped
/// mass of quadratic cells, so that gravity accelerates each node alike. Collective.
NodalNumbers volume_of_nodes(const Model& model, const LocalBlock& part) {
  NodalNumbers volume = no_measure(model);
  if (model.mass() == nullptr || !model.mass()->is_lumped() || !is_quadratic(part.type)) {
    add_block_measure(model.mesh(), part, volume);
    return volume;
  }
  Mass lumped(model.mesh(), model.pattern(), true);
  lumped.add_block(part, 1);
  std::vector<double> diagonal(static_cast<std::size_t>(model.space().local()), 0.0);
  lumped.add_diagonal(1, diagonal.data());
  model.space().update_ghosts(diagonal.data());
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t a = 0; a < volume.size(); ++a)
    if (!model.mesh().is_tied(static_cast<int>(a))) volume[a] = diagonal[a * d];
  return volume;
}

}  // namespace

std::vector<int> components_of(const std::string& components, int dimension) {
  const std::string allowed = dimension == 2 ? "xy" : "xyz";
  std::vector<int> numbers;
  for (const char component : components == "all" ? allowed : components) {
    const auto number = allowed.find(component);
    if (number == std::string::npos)
      throw InputError(
          fmt::format("\"{}\" names {}, but the mesh has {} dimensions", components, component, dimension));
    numbers.push_back(static_cast<int>(number));
  }
  if (numbers.empty()) throw InputError("no component is named; \"all\" names all");
  return numbers;
}

void prescribe(Model& model, const std::string& node_set, const std::string& components,
               const std::shared_ptr<const TimeFunction>& motion) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = mesh.node_set(node_set);
  const std::vector<int> numbers = components_of(components, mesh.dimension);
  model.check_open();
  const auto for_each = [&](const auto& visit) {
    for (const int i : numbers)
      for (const int node : mesh.node_sets[set]) {
        if (mesh.is_tied(node)) continue;
        // A derivative along the boundary does not change if all points move alike.
        const bool derivative = mesh.is_derivative(static_cast<std::size_t>(node));
        visit(node, i, derivative ? 0.0 : 1.0, derivative ? nullptr : motion);
      }
  };
  together<InputError>(model.space().comm(), [&] {
    for_each([&](int node, int i, double factor, const std::shared_ptr<const TimeFunction>& function) {
      try {
        model.constraints().check(node * mesh.dimension + i, factor, function);
      } catch (const InputError& error) {
        // Only the axis holds a radial displacement at zero without a condition of the scene.
        throw InputError(fmt::format("{}: component {} of node {} of the mesh{}", error.what(), "xyz"[i],
                                     mesh.message_number(static_cast<std::size_t>(node)),
                                     mesh.axisymmetric && i == 0 ? " (nodes on the axis are held in x)" : ""));
      }
    });
  });
  for_each([&](int node, int i, double factor, const std::shared_ptr<const TimeFunction>& function) {
    model.constraints().add(node * mesh.dimension + i, factor, function);
  });
  for (const int node : mesh.node_sets[set])
    if (mesh.is_tied(node))
      model.tied_conditions().add(node_set, node, [&model, numbers, motion](int master) {
        return std::all_of(numbers.begin(), numbers.end(), [&](int i) {
          return model.constraints().holds_by(master * model.mesh().dimension + i, {{1.0, motion}});
        });
      });
}

void hold_in_plane(Model& model, const std::string& node_set) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const std::vector<int>& nodes = mesh.node_sets[mesh.node_set(node_set)];
  model.check_open();
  std::vector<Vec<3>> places;
  for (const int node : nodes) {
    const auto n = static_cast<std::size_t>(node);
    if (node >= mesh.owned_nodes || mesh.is_derivative(n)) continue;
    places.emplace_back();
    std::copy_n(&mesh.coordinates[n * d], d, places.back().begin());
  }
  const Vec<3> normal =
      fitted_normal(mesh.dimension, places, [&](double* values, int count) { model.space().sum(values, count); });
  if (mesh.axisymmetric && std::abs(normal[0]) > 1e-6)
    throw InputError("its nodes are on a cone; a plane of symmetry of a body of revolution is across the axis");
  together<InputError>(model.space().comm(), [&] {
    for (const int node : nodes) try {
        if (!mesh.is_tied(node)) model.constraints().check_plane(node, d, normal);
      } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}: node {} of the mesh", error.what(), mesh.message_number(static_cast<std::size_t>(node))));
      }
  });
  for (const int node : nodes)
    if (mesh.is_tied(node))
      model.tied_conditions().add(node_set, node, [&model, d, normal](int master) {
        return model.constraints().holds_in_plane(master, d, normal);
      });
    else
      model.constraints().hold_in_plane(node, d, normal);
}

void add_traction(Model& model, const std::string& side_set, const std::vector<double>& vector,
                  std::shared_ptr<const TimeFunction> history) {
  const LocalMesh& mesh = model.mesh();
  NodalNumbers area = no_measure(model);
  add_side_measure(mesh, mesh.side_sets[mesh.side_set(side_set)], area);
  add_load(model, area, vector, std::move(history));
}

void add_point_force(Model& model, const std::string& node_set, const std::vector<double>& vector,
                     std::shared_ptr<const TimeFunction> history) {
  const LocalMesh& mesh = model.mesh();
  NodalNumbers ones = no_measure(model);
  // Nodes that a contact element adds do not count: the force would depend on the element.
  for (const int node : mesh.node_sets[mesh.node_set(node_set)])
    if (!mesh.is_added(static_cast<std::size_t>(node))) ones[static_cast<std::size_t>(node)] = 1;
  add_load(model, ones, vector, std::move(history));
}

void add_body_force(Model& model, const std::string& block, const std::vector<double>& vector,
                    std::shared_ptr<const TimeFunction> history) {
  NodalNumbers volume = no_measure(model);
  for_each_block(model.mesh(), block, [&](const LocalBlock& part) { add_block_measure(model.mesh(), part, volume); });
  add_load(model, volume, vector, std::move(history));
}

void add_gravity(Model& model, const std::string& block, const std::vector<double>& vector,
                 std::shared_ptr<const TimeFunction> history) {
  if (model.mesh().axisymmetric && !vector.empty() && vector[0] != 0)
    throw InputError(
        fmt::format("gravity with the radial component {} does not keep the axial symmetry of the mesh; it "
                    "must be 0",
                    vector[0]));
  NodalNumbers mass = no_measure(model);
  for_each_block(model.mesh(), block, [&](const LocalBlock& part) {
    const NodalNumbers volume = volume_of_nodes(model, part);
    for (const Material& material : model.materials())
      if (material.block == part.name)
        for (std::size_t a = 0; a < mass.size(); ++a) mass[a] += material.density * volume[a];
  });
  add_load(model, mass, vector, std::move(history));
}

}  // namespace ixos

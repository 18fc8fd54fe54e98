#include "scene/conditions.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "discretization/nodal_measure.hpp"

namespace ixos {
namespace {

/// A parameter that the condition's type needs, or refuses.
void require_given(const SceneNode& node, const char* name, bool wanted) {
  const bool array = node.list().isType<Teuchos::Array<double>>(name);
  const bool given = array ? !node.numbers(name).empty() : !node.text(name).empty();
  const std::string& type = node.text("Type");
  if (wanted && !given) throw InputError(fmt::format("{} is missing: a {} needs it", node.path_of(name), type));
  if (!wanted && given) node.refuse(name, fmt::format("a {} has no {}; remove it", type, name));
}

void add_displacement(const SceneNode& node, const Histories& histories, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(node.path_of("Node Set"), [&] { return mesh.node_set(node.text("Node Set")); });
  std::string components = node.text("Components");
  if (components == "all") components = mesh.dimension == 2 ? "xy" : "xyz";
  const auto history = node.text("History");
  std::shared_ptr<const TimeFunction> motion;
  if (!history.empty())
    motion = at(node.path_of("History"), [&] { return histories.get(history, HistoryUse::Motion); });
  for (char component : components)
    if (component - 'x' >= mesh.dimension)
      node.refuse("Components",
                  fmt::format("\"{}\" names z, but the mesh has {} dimensions", components, mesh.dimension));
  together<InputError>(model.space().comm(), [&] {
    for (char component : components)
      for (int place : mesh.node_sets[set]) {
        // A derivative along the boundary does not change if all points move alike.
        const bool derivative = mesh.is_derivative(static_cast<std::size_t>(place));
        try {
          model.constraints().add(place * mesh.dimension + (component - 'x'), derivative ? 0.0 : 1.0,
                                  derivative ? nullptr : motion);
        } catch (const InputError& error) {
          throw InputError(fmt::format("{}: {}: component {} of node {} of the mesh", node.path(), error.what(),
                                       component, mesh.original_ids[static_cast<std::size_t>(place)] + 1));
        }
      }
  });
}

/// Adds int N_a dV over a block, times its density for Gravity.
void add_block(const LocalMesh& mesh, const LocalBlock& block, const std::string& type,
               const std::vector<Material>& materials, std::vector<double>& measure) {
  if (type != "Gravity") {
    add_block_measure(mesh, block, measure);
    return;
  }
  std::vector<double> volume(measure.size(), 0.0);
  add_block_measure(mesh, block, volume);
  for (const Material& material : materials)
    if (material.block == block.name)
      for (std::size_t a = 0; a < measure.size(); ++a) measure[a] += material.density * volume[a];
}

/// Returns int N_a over the surface or body on which the load acts, or 1 at the nodes of a set.
std::vector<double> distribution(const SceneNode& node, const std::vector<Material>& materials, const LocalMesh& mesh) {
  std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0);
  const auto type = node.text("Type");
  if (type == "Traction") {
    const auto set = at(node.path_of("Side Set"), [&] { return mesh.side_set(node.text("Side Set")); });
    add_side_measure(mesh, mesh.side_sets[set], measure);
  } else if (type == "Point Force") {
    const auto set = at(node.path_of("Node Set"), [&] { return mesh.node_set(node.text("Node Set")); });
    // Nodes that a contact element adds do not count: the force would depend on the element.
    for (int place : mesh.node_sets[set])
      if (!mesh.is_added(static_cast<std::size_t>(place))) measure[static_cast<std::size_t>(place)] = 1;
  } else {
    const auto& name = node.text("Block");
    if (name.empty())
      for (const LocalBlock& block : mesh.blocks) add_block(mesh, block, type, materials, measure);
    else
      for (std::size_t b : at(node.path_of("Block"), [&] { return mesh.blocks_named(name); }))
        add_block(mesh, mesh.blocks[b], type, materials, measure);
  }
  return measure;
}

void add_load(const SceneNode& node, const Histories& histories, const std::vector<Material>& materials, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto vector = node.numbers("Vector", d, {});
  const auto& name = node.text("History");
  const auto history =
      name.empty() ? constant(1.0) : at(node.path_of("History"), [&] { return histories.get(name, HistoryUse::Load); });
  const std::vector<double> measure = distribution(node, materials, mesh);
  std::vector<double> forces(measure.size() * d);
  for (std::size_t a = 0; a < measure.size(); ++a)
    for (std::size_t i = 0; i < d; ++i) forces[a * d + i] = measure[a] * vector[i];
  model.loads().add(std::move(forces), history);
}

}  // namespace

void add_conditions(const SceneNode& conditions, const Histories& histories, const std::vector<Material>& materials,
                    Model& model) {
  for (const SceneNode& node : conditions.sublists()) {
    const std::string& type = node.text("Type");
    const bool displacement = type == "Displacement";
    require_given(node, "Node Set", displacement || type == "Point Force");
    require_given(node, "Side Set", type == "Traction");
    require_given(node, "Vector", !displacement);
    if (type != "Body Force" && type != "Gravity") require_given(node, "Block", false);
    if (displacement)
      add_displacement(node, histories, model);
    else
      add_load(node, histories, materials, model);
  }
}

}  // namespace ixos

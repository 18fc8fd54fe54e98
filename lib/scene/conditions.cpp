#include "scene/conditions.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "model/nodal_measure.hpp"
#include "scene/list_access.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// A parameter that the condition's type needs, or refuses.
void require_given(const List& list, const std::string& path, const char* name, bool wanted) {
  const bool array = list.isType<Teuchos::Array<double>>(name);
  const bool given = array ? !list.get<Teuchos::Array<double>>(name).empty() : !list.get<std::string>(name).empty();
  const auto type = list.get<std::string>("Type");
  if (wanted && !given) throw InputError(fmt::format("{}/{} is missing: a {} needs it", path, name, type));
  if (!wanted && given) throw InputError(fmt::format("{}/{}: a {} has no {}; remove it", path, name, type, name));
}

void add_displacement(const List& list, const std::string& path, const Histories& histories, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(path + "/Node Set", [&] { return mesh.node_set(list.get<std::string>("Node Set")); });
  std::string components = list.get<std::string>("Components");
  if (components == "all") components = mesh.dimension == 2 ? "xy" : "xyz";
  const auto history = list.get<std::string>("History");
  std::shared_ptr<const TimeFunction> motion;
  if (!history.empty()) motion = at(path + "/History", [&] { return histories.get(history, HistoryUse::Motion); });
  for (char component : components)
    if (component - 'x' >= mesh.dimension)
      throw InputError(fmt::format("{}/Components: \"{}\" names z, but the mesh has {} dimensions", path, components,
                                   mesh.dimension));
  together<InputError>(model.space().comm(), [&] {
    for (char component : components)
      for (int node : mesh.node_sets[set]) {
        // A derivative along the boundary does not change if all points move alike.
        const bool derivative = mesh.is_derivative(static_cast<std::size_t>(node));
        try {
          model.constraints().add(node * mesh.dimension + (component - 'x'), derivative ? 0.0 : 1.0,
                                  derivative ? nullptr : motion);
        } catch (const InputError& error) {
          throw InputError(fmt::format("{}: {}: component {} of node {} of the mesh", path, error.what(), component,
                                       mesh.original_ids[static_cast<std::size_t>(node)] + 1));
        }
      }
  });
}

/// Returns int N_a over the surface or body on which the load acts, or 1 at the nodes of a set.
std::vector<double> distribution(const List& list, const std::string& path, const LocalMesh& mesh) {
  std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0);
  const auto type = list.get<std::string>("Type");
  if (type == "Traction") {
    const auto set = at(path + "/Side Set", [&] { return mesh.side_set(list.get<std::string>("Side Set")); });
    add_side_measure(mesh, mesh.side_sets[set], measure);
  } else if (type == "Point Force") {
    const auto set = at(path + "/Node Set", [&] { return mesh.node_set(list.get<std::string>("Node Set")); });
    // Nodes that a contact element adds do not count: the force would depend on the element.
    for (int node : mesh.node_sets[set])
      if (!mesh.is_added(static_cast<std::size_t>(node))) measure[static_cast<std::size_t>(node)] = 1;
  } else {
    const auto name = list.get<std::string>("Block");
    if (name.empty())
      for (const LocalBlock& block : mesh.blocks) add_block_measure(mesh, block, measure);
    else
      for (std::size_t b : at(path + "/Block", [&] { return mesh.blocks_named(name); }))
        add_block_measure(mesh, mesh.blocks[b], measure);
  }
  return measure;
}

void add_load(const List& list, const std::string& path, const Histories& histories, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto vector = numbers(list, path, "Vector", d, {});
  const auto name = list.get<std::string>("History");
  const auto history =
      name.empty() ? constant(1.0) : at(path + "/History", [&] { return histories.get(name, HistoryUse::Load); });
  const std::vector<double> measure = distribution(list, path, mesh);
  std::vector<double> forces(measure.size() * d);
  for (std::size_t node = 0; node < measure.size(); ++node)
    for (std::size_t i = 0; i < d; ++i) forces[node * d + i] = measure[node] * vector[i];
  model.loads().add(std::move(forces), history);
}

}  // namespace

void add_conditions(const List& list, const Histories& histories, Model& model) {
  for (const std::string& name : sublists(list)) {
    const List& own = list.sublist(name);
    const std::string path = "Boundary Conditions/" + name;
    const auto type = own.get<std::string>("Type");
    const bool displacement = type == "Displacement";
    require_given(own, path, "Node Set", displacement || type == "Point Force");
    require_given(own, path, "Side Set", type == "Traction");
    require_given(own, path, "Vector", !displacement);
    if (type != "Body Force") require_given(own, path, "Block", false);
    if (displacement)
      add_displacement(own, path, histories, model);
    else
      add_load(own, path, histories, model);
  }
}

}  // namespace ixos

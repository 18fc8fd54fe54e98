#include "scene/mesh_inspection.hpp"

#include <algorithm>

#include "mesh/soundness.hpp"
#include "scene/list_access.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

template <class Set>
const Set* find(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

/// Sets that a scene uses, checked, and the nodes that they hold.
class Inspection {
 public:
  /// `read`: the mesh comes from a file; a generator's sides are outside.
  Inspection(const Mesh& mesh, bool read)
      : mesh_(mesh), read_(read), held_(static_cast<std::size_t>(mesh.nodes()), false) {}

  void sides(const List& list, const std::string& path, bool holds) {
    const SideSet* set = find(mesh_.side_sets, list.get<std::string>("Side Set"));
    if (set == nullptr) return;
    at(path + "/Side Set", [&] {
      require_sides(*set);
      if (read_) require_outer_sides(mesh_, *set);
      return 0;
    });
    for (const Side& side : set->sides) {
      const ElementBlock& block = mesh_.blocks[static_cast<std::size_t>(side.block)];
      const int* nodes = block.nodes.data() + static_cast<std::ptrdiff_t>(side.cell) * nodes_per_cell(block.type);
      for (int node : side_nodes(block.type, side.side)) hold(nodes[node], holds);
    }
  }
  void nodes(const List& list, const std::string& path, bool holds) {
    const NodeSet* set = find(mesh_.node_sets, list.get<std::string>("Node Set"));
    if (set == nullptr) return;
    at(path + "/Node Set", [&] {
      require_nodes(*set);
      return 0;
    });
    for (int node : set->nodes) hold(node, holds);
  }
  const std::vector<bool>& held() const { return held_; }

 private:
  void hold(int node, bool holds) {
    if (holds) held_[static_cast<std::size_t>(node)] = true;
  }

  const Mesh& mesh_;
  bool read_;
  std::vector<bool> held_;
};

}  // namespace

std::vector<std::string> inspect_mesh(const List& scene, const Mesh& mesh) {
  const bool read = scene.sublist("Mesh").get<std::string>("Type") == "Exodus";
  Inspection inspection(mesh, read);
  for (const std::string& name : sublists(scene.sublist("Interactions")))
    inspection.sides(scene.sublist("Interactions").sublist(name), "Interactions/" + name, true);
  for (const std::string& name : sublists(scene.sublist("Boundary Conditions"))) {
    const List& list = scene.sublist("Boundary Conditions").sublist(name);
    const auto type = list.get<std::string>("Type");
    if (type == "Traction") inspection.sides(list, "Boundary Conditions/" + name, false);
    if (type == "Displacement" || type == "Point Force")
      inspection.nodes(list, "Boundary Conditions/" + name, type == "Displacement");
  }
  if (!read) return {};
  std::vector<std::string> warnings = loose_parts(mesh, inspection.held());
  if (std::string nodes = coincident_nodes(mesh); !nodes.empty()) warnings.insert(warnings.begin(), std::move(nodes));
  return warnings;
}

}  // namespace ixos

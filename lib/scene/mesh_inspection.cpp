#include "scene/mesh_inspection.hpp"

#include <algorithm>

#include "mesh/soundness.hpp"
#include "scene/scene_mesh.hpp"

namespace ixos {
namespace {

template <class Set>
const Set* find(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

/// Sets that a scene uses, checked, and the nodes that they hold.
class Inspection {
 public:
  /// `read`: the mesh comes from a file or a program; a generator's sides are outside.
  Inspection(const Mesh& mesh, bool read)
      : mesh_(mesh), read_(read), held_(static_cast<std::size_t>(mesh.nodes()), false) {}

  void sides(const SceneNode& node, bool holds) {
    const SideSet* set = find(mesh_.side_sets, node.text("Side Set"));
    if (set == nullptr) return;
    at(node.path_of("Side Set"), [&] {
      require_sides(*set);
      if (read_) require_outer_sides(mesh_, *set);
    });
    for (const Side& side : set->sides) {
      const ElementBlock& block = mesh_.blocks[static_cast<std::size_t>(side.block)];
      const int* nodes = block.nodes.data() + static_cast<std::ptrdiff_t>(side.cell) * nodes_per_cell(block.type);
      for (int corner : side_nodes(block.type, side.side)) hold(nodes[corner], holds);
    }
  }
  void nodes(const SceneNode& node, bool holds) {
    const NodeSet* set = find(mesh_.node_sets, node.text("Node Set"));
    if (set == nullptr) return;
    at(node.path_of("Node Set"), [&] { require_nodes(*set); });
    for (int number : set->nodes) hold(number, holds);
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

std::vector<std::string> inspect_mesh(const SceneNode& scene, const Mesh& mesh) {
  const bool read = is_from_outside(meshes().chosen(scene.sublist("Mesh")));
  Inspection inspection(mesh, read);
  for (const SceneNode& node : scene.sublist("Interactions").sublists()) inspection.sides(node, true);
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) {
    const std::string& type = node.text("Type");
    if (type == "Traction") inspection.sides(node, false);
    if (type == "Displacement" || type == "Point Force") inspection.nodes(node, type == "Displacement");
  }
  for (const SceneNode& node : scene.sublist("Grips").sublists()) inspection.nodes(node, true);
  if (!read) return {};
  std::vector<std::string> warnings = loose_parts(mesh, inspection.held());
  if (std::string nodes = coincident_nodes(mesh); !nodes.empty()) warnings.insert(warnings.begin(), std::move(nodes));
  return warnings;
}

}  // namespace ixos

#include "scene/examine/mesh_inspection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/joined_parts.hpp"
#include "mesh/selection.hpp"
#include "mesh/soundness.hpp"
#include "scene/read/mesh_parts.hpp"
#include "scene/read/scene_mesh.hpp"

namespace ixos {
namespace {

/// Sets that a scene uses, checked, and the nodes that they hold.
class Inspection {
 public:
  /// `lists`: see part_lists().
  Inspection(const Mesh& mesh, const std::vector<SceneNode>& lists)
      : mesh_(mesh), lists_(lists), held_(static_cast<std::size_t>(mesh.nodes()), false) {}

  /// `parameter`: the one that names the side set.
  void sides(const SceneNode& node, bool holds, const char* parameter = "Side Set") {
    const SideSet* set = find_set(mesh_.side_sets, node.text(parameter));
    if (set == nullptr) return;
    at(node.path_of(parameter), [&] {
      require_sides(*set);
      if (is_read(*set)) require_outer_sides(mesh_, *set);
    });
    for (const Side& side : set->sides) {
      const ElementBlock& block = mesh_.blocks[static_cast<std::size_t>(side.block)];
      const int* nodes = block.nodes.data() + static_cast<std::ptrdiff_t>(side.cell) * nodes_per_cell(block.type);
      for (int corner : side_nodes(block.type, side.side)) hold(nodes[corner], holds);
    }
  }
  void nodes(const SceneNode& node, bool holds) {
    const NodeSet* set = find_set(mesh_.node_sets, node.text("Node Set"));
    if (set == nullptr) return;
    at(node.path_of("Node Set"), [&] { require_nodes(*set); });
    for (int number : set->nodes) hold(number, holds);
  }
  const std::vector<bool>& held() const { return held_; }

 private:
  /// Returns whether a side comes from a file or a program. A generator's sides are outside.
  bool is_read(const SideSet& set) const {
    return std::any_of(set.sides.begin(), set.sides.end(), [this](const Side& side) {
      return is_from_outside(list_of(mesh_.blocks[static_cast<std::size_t>(side.block)], lists_));
    });
  }
  void hold(int node, bool holds) {
    if (holds) held_[static_cast<std::size_t>(node)] = true;
  }

  const Mesh& mesh_;
  const std::vector<SceneNode>& lists_;
  std::vector<bool> held_;
};

/// Returns the warnings about a mesh of one body that was read from a file or given.
std::vector<std::string> faults(const Mesh& mesh, const std::vector<bool>& held) {
  std::vector<std::string> warnings = loose_parts(mesh, held);
  if (std::string nodes = coincident_nodes(mesh); !nodes.empty()) warnings.insert(warnings.begin(), std::move(nodes));
  return warnings;
}

}  // namespace

std::vector<std::string> inspect_mesh(const SceneNode& scene, const Mesh& mesh) {
  const std::vector<SceneNode> lists = part_lists(scene.sublist("Mesh"));
  Inspection inspection(mesh, lists);
  for (const SceneNode& node : scene.sublist("Interactions").sublists()) {
    inspection.sides(node, true);
    inspection.sides(node, true, "Primary Side Set");
  }
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) {
    const std::string& type = node.text("Type");
    if (type == "Traction") inspection.sides(node, false);
    if (type == "Displacement" || type == "Symmetry") inspection.nodes(node, true);
    if (type == "Point Force") inspection.nodes(node, false);
  }
  for (const SceneNode& node : scene.sublist("Grips").sublists()) inspection.nodes(node, true);
  if (lists.size() == 1 && lists.front().path() == "Mesh")
    return is_from_outside(lists.front()) ? faults(mesh, inspection.held()) : std::vector<std::string>();
  std::vector<bool> all_held = inspection.held();
  for (const Tie& tie : mesh.ties) {  // another part holds what is tied to it
    all_held[static_cast<std::size_t>(tie.node)] = true;
    for (const int master : tie.masters) all_held[static_cast<std::size_t>(master)] = true;
  }
  std::vector<std::string> warnings;
  for (const SceneNode& part : lists) {
    if (!is_from_outside(part)) continue;
    std::vector<int> old;
    const Mesh own = part_of_joined(mesh, part.name(), old);
    std::vector<bool> held;
    held.reserve(old.size());
    for (const int node : old) held.push_back(all_held[static_cast<std::size_t>(node)]);
    for (const std::string& fault : faults(own, held))
      warnings.push_back(fmt::format("part \"{}\": {}", part.name(), fault));
  }
  return warnings;
}

}  // namespace ixos

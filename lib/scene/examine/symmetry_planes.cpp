#include "scene/examine/symmetry_planes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

/// The sets of a mesh, against the nodes of a plane.
class Acted {
 public:
  Acted(const Mesh& mesh, const std::vector<int>& in_plane) : mesh_(mesh), nodes_(in_plane) {}

  bool nodes(const std::string& name) const {
    std::set<int> found;
    for (const NodeSet& set : mesh_.node_sets)
      for (const int node : set.nodes)
        if (set.name == name && is_in_plane(node)) found.insert(node);
    return is_enough(found);
  }
  /// Counts the nodes of sides that are in the plane as a whole.
  bool sides(const std::string& name) const {
    std::set<int> found;
    for (const SideSet& set : mesh_.side_sets) {
      if (set.name != name) continue;
      for (const Side& side : set.sides) {
        const SideCorners corners = corners_of(mesh_, side);
        if (!std::all_of(corners.begin(), corners.end(), [this](int node) { return node < 0 || is_in_plane(node); }))
          continue;
        for (const int node : nodes_of_side(mesh_, side))
          if (is_in_plane(node)) found.insert(node);
      }
    }
    return is_enough(found);
  }

 private:
  bool is_in_plane(int node) const { return std::binary_search(nodes_.begin(), nodes_.end(), node); }
  bool is_enough(const std::set<int>& found) const { return 2 * found.size() >= nodes_.size(); }

  const Mesh& mesh_;
  const std::vector<int>& nodes_;
};

bool is_acted_on(const SceneNode& scene, const Mesh& mesh, const CutPlane& plane) {
  const Acted acted(mesh, plane.nodes);
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) {
    const std::string &type = node.text("Type"), &along = node.text("Components");
    if (type == "Displacement" && along != "all" && along.find("xyz"[plane.axis]) == std::string::npos) continue;
    if (acted.nodes(node.text("Node Set")) || acted.sides(node.text("Side Set"))) return true;
  }
  for (const SceneNode& node : scene.sublist("Grips").sublists())
    if (acted.nodes(node.text("Node Set"))) return true;
  for (const SceneNode& node : scene.sublist("Interactions").sublists())
    if (acted.sides(node.text("Side Set")) || acted.sides(node.text("Primary Side Set"))) return true;
  return false;
}

}  // namespace

std::optional<CutPlane> open_cut(const SceneNode& scene, const Mesh& mesh, const SideSet& surface,
                                 const std::vector<int>& parts, const std::array<double, 3>& normal) {
  constexpr double oblique = 0.1;
  for (CutPlane& plane : cut_planes(mesh, surface, parts))
    if (std::abs(normal[plane.axis]) <= oblique && plane.nodes.size() > 2 && !is_acted_on(scene, mesh, plane))
      return std::move(plane);
  return std::nullopt;
}

}  // namespace ixos

#include "mesh/mortar/tied_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/mortar/mortar_weights.hpp"
#include "mesh/node_place.hpp"
#include "mesh/region.hpp"
#include "mesh/selection.hpp"
#include "mesh/side_set_nodes.hpp"
#include "mesh/tied_nodes.hpp"

namespace ixos {
namespace {

/// Weights that are rounding [-].
constexpr double no_weight = 1e-13;

/// One of the two surfaces.
struct Surface {
  std::string name;
  std::set<int> nodes;
  std::vector<Facet> sides;
};

Surface surface_of(const Mesh& mesh, const std::string& name) {
  const SideSet& set = side_set_named(mesh, name);
  if (set.sides.empty()) throw InputError(fmt::format("the side set \"{}\" has no sides", name));
  Surface surface{name, nodes_of(mesh, set), {}};
  surface.sides.reserve(set.sides.size());
  for (const Side& side : set.sides) surface.sides.emplace_back(mesh, side);
  return surface;
}

void refuse_sides_without_dual_functions(const Surface& secondary) {
  const auto has_none = [](const Facet& side) { return !side.has_dual_functions(); };
  if (std::none_of(secondary.sides.begin(), secondary.sides.end(), has_none)) return;
  throw InputError(
      fmt::format("the side set \"{}\" has triangles of six nodes, which can be followed but cannot follow: the "
                  "functions of their corners have no area. Exchange it with the primary one, give the cells nodes in "
                  "their triangles (Mean Dilatation, Cell Order 2), or use linear cells",
                  secondary.name));
}

void refuse_nodes(const Mesh& mesh, const Surface& secondary, const Surface& primary) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; tie surfaces before it is enriched");
  for (const int node : secondary.nodes)
    if (primary.nodes.count(node) > 0)
      throw InputError(
          fmt::format("the side sets \"{}\" and \"{}\" share {}; tied surfaces belong to cells without common nodes",
                      secondary.name, primary.name, node_in_words(mesh, node)));
  for (const Tie& tie : mesh.ties)
    if (secondary.nodes.count(tie.node) > 0)
      throw InputError(fmt::format(
          "{}, of the side set \"{}\", follows other nodes already: it hangs on a coarser cell, or belongs "
          "to another tied surface. A Primary Side Set may have such nodes; one list may tie both faces of an edge",
          node_in_words(mesh, tie.node), secondary.name));
}

/// A secondary surface and what it faces.
class SurfaceTie {
 public:
  SurfaceTie(Mesh& mesh, const Surface& secondary, const Surface& primary, double tolerance)
      : mesh_(mesh), secondary_(secondary), primary_(primary), tolerance_(tolerance) {}

  void apply() {
    refuse_wide_tolerance();
    const MortarSurfaces surfaces{secondary_.sides, primary_.sides, mesh_.axisymmetric,
                                  [this](const Facet& side) { return reach(side); }};
    const std::vector<FacingParts> parts = all_facing_parts(surfaces);
    const std::vector<bool> at_rim = facets_at_rim(surfaces.secondary);
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!is_covered(parts[k], at_rim[k])) refuse_uncovered(surfaces.secondary[k], parts[k]);
    const MortarWeights weights = mortar_weights(surfaces, parts);
    if (weights.failed != nullptr)
      throw InputError(
          fmt::format("{} is too distorted, or the surface too bent there, to be projected onto the side "
                      "set \"{}\"; smaller cells help",
                      side_in_words(*weights.failed), primary_.name));
    mesh_.ties.reserve(mesh_.ties.size() + weights.of_node.size());
    for (const auto& [node, masters] : weights.of_node) mesh_.ties.push_back(tie_of(node, masters));
    refuse_leaving_the_axis();
    place_tied_nodes(mesh_);
    note_way(longest_way());
  }

 private:
  std::string side_in_words(const Facet& side) const {
    return fmt::format("the side of \"{}\" at {}", secondary_.name, point_in_words(side.middle(), mesh_.dimension));
  }

  double reach(const Facet& side) const { return tolerance_ > 0 ? tolerance_ : side.size() / 20; }

  /// Nodes that move by half of a side turn cells inside out.
  void refuse_wide_tolerance() const {
    for (const Facet& side : secondary_.sides)
      if (tolerance_ > side.size() / 2)
        throw InputError(fmt::format("the Tolerance, {:.3g} L0, is more than half of {}, which is {:.3g} L0 long",
                                     tolerance_, side_in_words(side), side.size()));
  }

  /// Returns why nothing faces a side: the nearest primary side is far away, or looks the same way.
  std::string why_nothing_faces(const Facet& side) const {
    const auto distance = [&](const Facet& other) { return length(other.middle() - side.middle()); };
    const auto looks_away = [&](const Facet& other) { return inner(other.normal(), side.normal()) > 0; };
    const Facet& nearest =
        *std::min_element(primary_.sides.begin(), primary_.sides.end(), [&](const Facet& a, const Facet& b) {
          return std::pair(looks_away(a), distance(a)) < std::pair(looks_away(b), distance(b));
        });
    if (looks_away(nearest))
      return fmt::format("the nearest one, at {}, looks the same way",
                         point_in_words(nearest.middle(), mesh_.dimension));
    return fmt::format("the middle of the nearest one, at {}, is {:.3g} L0 away; the tolerance is {:.3g} L0",
                       point_in_words(nearest.middle(), mesh_.dimension), distance(nearest), reach(side));
  }

  [[noreturn]] void refuse_uncovered(const Facet& side, const FacingParts& found) const {
    if (found.covered > 1)
      throw InputError(fmt::format("several sides of \"{}\" face {}: they cover {:.6g} times its area within {:.3g} L0",
                                   primary_.name, side_in_words(side), found.covered, reach(side)));
    if (found.too_far > 0)
      throw InputError(fmt::format("{} is {:.3g} L0 away from \"{}\"; the tolerance is {:.3g} L0", side_in_words(side),
                                   found.too_far, primary_.name, reach(side)));
    if (found.covered == 0)
      throw InputError(
          fmt::format("no side of \"{}\" faces {}: {}", primary_.name, side_in_words(side), why_nothing_faces(side)));
    throw InputError(
        fmt::format("the sides of \"{}\" face {:.6g} % of {}. A primary surface must cover the secondary one; if it is "
                    "the smaller one, exchange them",
                    primary_.name, 100 * found.covered, side_in_words(side)));
  }

  static Tie tie_of(int node, const std::map<int, double>& masters) {
    Tie tie{node, {}, {}};
    double sum = 0;
    std::size_t largest = 0;
    for (const auto& [master, weight] : masters) {
      if (std::abs(weight) < no_weight) continue;
      tie.masters.push_back(master);
      tie.weights.push_back(weight);
      sum += weight;
      if (std::abs(weight) > std::abs(tie.weights[largest])) largest = tie.weights.size() - 1;
    }
    tie.weights[largest] += 1 - sum;  // rounding: a translation moves the node as its masters, to the last digit
    return tie;
  }

  /// A node on the axis stays there only with nodes that do.
  void refuse_leaving_the_axis() const {
    if (!mesh_.axisymmetric) return;
    const auto is_off = [this, slack = place_tolerance(mesh_)](int node) { return node_place(mesh_, node)[0] > slack; };
    for (const Tie& tie : mesh_.ties)
      if (secondary_.nodes.count(tie.node) > 0 && !is_off(tie.node) &&
          std::any_of(tie.masters.begin(), tie.masters.end(), is_off))
        throw InputError(
            fmt::format("{}, of \"{}\", is on the axis and would follow nodes that are not; \"{}\" must have a node "
                        "there, and both at least two sides",
                        node_in_words(mesh_, tie.node), secondary_.name, primary_.name));
  }

  /// Returns how far a node moved. Throws InputError if that is too far.
  double longest_way() const {
    double longest = 0;
    for (const Facet& side : secondary_.sides)
      for (std::size_t a = 0; a < side.nodes().size(); ++a) {
        const int node = side.nodes()[a];
        const double way = length(node_place(mesh_, node) - side.places()[a]);
        if (way > reach(side))
          throw InputError(fmt::format("{}, of \"{}\", would move by {:.3g} L0 onto \"{}\"; the tolerance is {:.3g} L0",
                                       node_in_words(mesh_, node), secondary_.name, way, primary_.name, reach(side)));
        longest = std::max(longest, way);
      }
    return longest;
  }

  void note_way(double way) const {
    if (way > place_tolerance(mesh_))
      mesh_.notes.push_back(fmt::format("the nodes of \"{}\" moved by up to {:.3g} L0 onto \"{}\", which they follow",
                                        secondary_.name, way, primary_.name));
  }

  Mesh& mesh_;
  const Surface& secondary_;
  const Surface& primary_;
  double tolerance_;
};

}  // namespace

void tie_surfaces(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance) {
  const Surface followers = surface_of(mesh, secondary), leaders = surface_of(mesh, primary);
  refuse_sides_without_dual_functions(followers);
  refuse_nodes(mesh, followers, leaders);
  SurfaceTie(mesh, followers, leaders, tolerance).apply();
  for (const Surface* surface : {&followers, &leaders})
    mesh.nodes_of_tied_sides.insert(mesh.nodes_of_tied_sides.end(), surface->nodes.begin(), surface->nodes.end());
}

}  // namespace ixos

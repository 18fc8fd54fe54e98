#include "mesh/periodic_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/region.hpp"
#include "mesh/selection.hpp"
#include "mesh/side_set_nodes.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
using PlacedNode = std::pair<TreePoint, int>;

Vec<3> middle_of(const Mesh& mesh, const std::set<int>& nodes) {
  Vec<3> sum{};
  for (const int node : nodes) sum = sum + 1 / static_cast<double>(nodes.size()) * node_place(mesh, node);
  return sum;
}

/// Throws InputError if sides of one set have no partner in the other although their nodes have: triangles may be cut
/// along other diagonals.
void require_same_sides(const Mesh& mesh, const SideSet& secondary, const SideSet& primary,
                        const std::map<int, int>& partner) {
  std::set<SideCorners> there;
  for (const Side& side : primary.sides) there.insert(sorted_corners(mesh, side));
  for (const Side& side : secondary.sides) {
    SideCorners corners = corners_of(mesh, side);
    const std::string place = point_in_words(centre_of(mesh, corners), mesh.dimension);
    for (int& node : corners)
      if (node >= 0) node = partner.at(node);
    std::sort(corners.begin(), corners.end());
    if (there.count(corners) == 0)
      throw InputError(
          fmt::format("the side at {} of the side set \"{}\" has no partner in \"{}\", though its nodes have: its "
                      "triangles are cut "
                      "along another diagonal. Periodic sides have the same mesh",
                      place, secondary.name, primary.name));
  }
}

/// A node that follows others already must follow nodes of its own side: it is on an edge of other periodic sides, or
/// hangs on a coarser cell.
void refuse_other_masters(const Mesh& mesh, const Tie& tie, const std::set<int>& followers, const std::string& set) {
  if (std::all_of(tie.masters.begin(), tie.masters.end(), [&](int master) { return followers.count(master) > 0; }))
    return;
  throw InputError(fmt::format(
      "{}, of the side set \"{}\", follows nodes of another side already: that of a tied surface, or of other periodic "
      "sides. A Primary Side Set may have such nodes",
      node_in_words(mesh, tie.node), set));
}

/// The places of a body of revolution repeat along its axis only.
void refuse_translation_across_the_axis(const Mesh& mesh, const Vec<3>& translation, double reach) {
  if (mesh.axisymmetric && std::abs(translation[0]) > reach)
    throw InputError(
        fmt::format("the sides are {:.6g} L0 apart along x, the radius; an axisymmetric mesh can be periodic "
                    "along y, its axis, only",
                    std::abs(translation[0])));
}

}  // namespace

void make_periodic(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; make sides periodic before it is enriched");
  const std::set<int> followers = nodes_of(mesh, side_set_named(mesh, secondary)),
                      leaders = nodes_of(mesh, side_set_named(mesh, primary));
  for (const int node : followers)
    if (leaders.count(node) > 0)
      throw InputError(fmt::format("the side sets \"{}\" and \"{}\" share {}; periodic sides lie apart", secondary,
                                   primary, node_in_words(mesh, node)));
  if (followers.empty() || followers.size() != leaders.size())
    throw InputError(fmt::format(
        "the side set \"{}\" has {} nodes and \"{}\" {}; periodic sides have the same mesh and at least one side",
        secondary, followers.size(), primary, leaders.size()));
  const Vec<3> translation = middle_of(mesh, leaders) - middle_of(mesh, followers);
  std::vector<PlacedNode> placed;
  placed.reserve(leaders.size());
  for (const int node : leaders) placed.emplace_back(tree_point(node_place(mesh, node)), node);
  const bg::index::rtree<PlacedNode, bg::index::rstar<16>> tree(placed);
  const double reach = tolerance > 0 ? tolerance : place_tolerance(mesh);
  refuse_translation_across_the_axis(mesh, translation, reach);
  std::set<int> tied;
  std::map<int, int> partner, follower;  // of the nodes of the secondary, the primary sides
  for (const Tie& tie : mesh.ties) {
    if (followers.count(tie.node) == 0) continue;
    refuse_other_masters(mesh, tie, followers, secondary);
    tied.insert(tie.node);
  }
  for (const int node : followers) {
    const Vec<3> x = node_place(mesh, node), wanted = x + translation;
    const TreePoint there = tree_point(wanted);
    std::vector<PlacedNode> nearest;
    tree.query(bg::index::nearest(there, 1), std::back_inserter(nearest));
    if (const double off = bg::distance(nearest.front().first, there); off > reach)
      throw InputError(
          fmt::format("node {} of the side set \"{}\" at {} has no partner in \"{}\": the nearest node to {} is {:.3g} "
                      "L0 away, and the tolerance is {:.3g} L0. Periodic sides have the same mesh, and are not turned",
                      node + 1, secondary, point_in_words(x, mesh.dimension), primary,
                      point_in_words(wanted, mesh.dimension), off, reach));
    partner[node] = nearest.front().second;
    if (const auto [other, is_first] = follower.insert({nearest.front().second, node}); !is_first)
      throw InputError(
          fmt::format("{} and {} of the side set \"{}\" have the same partner in \"{}\": the tolerance, {:.3g} "
                      "L0, is larger than the sides",
                      node_in_words(mesh, other->second), node_in_words(mesh, node), secondary, primary, reach));
    if (tied.count(node) == 0) mesh.ties.push_back({node, {nearest.front().second}, {1.0}, false});
  }
  require_same_sides(mesh, side_set_named(mesh, secondary), side_set_named(mesh, primary), partner);
  for (const std::set<int>& nodes : {followers, leaders})
    mesh.nodes_of_tied_sides.insert(mesh.nodes_of_tied_sides.end(), nodes.begin(), nodes.end());
}

}  // namespace ixos

#include "mesh/periodic_sides.hpp"

#include <fmt/format.h>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <iterator>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "mesh/cell_place.hpp"
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
  std::set<int> tied;
  for (const Tie& tie : mesh.ties) tied.insert(tie.node);
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
    if (tied.count(node) == 0) mesh.ties.push_back({node, {nearest.front().second}, {1.0}, false});
  }
  for (const std::set<int>& nodes : {followers, leaders})
    mesh.nodes_of_tied_sides.insert(mesh.nodes_of_tied_sides.end(), nodes.begin(), nodes.end());
}

}  // namespace ixos

#include "mesh/periodic_sides.hpp"

#include <fmt/format.h>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <iterator>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/region.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using PlacedNode = std::pair<Point, int>;

std::set<int> nodes_of(const Mesh& mesh, const std::string& set) {
  std::set<int> nodes;
  for (const Side& side : side_set_named(mesh, set).sides) {
    const std::vector<int> own = nodes_of_side(mesh, side);
    nodes.insert(own.begin(), own.end());
  }
  return nodes;
}

Vec<3> middle_of(const Mesh& mesh, const std::set<int>& nodes) {
  Vec<3> sum{};
  for (const int node : nodes) sum = sum + 1 / static_cast<double>(nodes.size()) * node_place(mesh, node);
  return sum;
}

}  // namespace

void make_periodic(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; make sides periodic before it is enriched");
  const std::set<int> followers = nodes_of(mesh, secondary), leaders = nodes_of(mesh, primary);
  for (const int node : followers)
    if (leaders.count(node) > 0)
      throw InputError(
          fmt::format("the side sets \"{}\" and \"{}\" share node {} of the mesh; periodic sides lie apart", secondary,
                      primary, node + 1));
  if (followers.empty() || followers.size() != leaders.size())
    throw InputError(fmt::format(
        "the side set \"{}\" has {} nodes and \"{}\" {}; periodic sides have the same mesh and at least one side",
        secondary, followers.size(), primary, leaders.size()));
  const Vec<3> translation = middle_of(mesh, leaders) - middle_of(mesh, followers);
  std::vector<PlacedNode> placed;
  for (const int node : leaders) {
    const Vec<3> x = node_place(mesh, node);
    placed.emplace_back(Point(x[0], x[1], x[2]), node);
  }
  const bg::index::rtree<PlacedNode, bg::index::rstar<16>> tree(placed);
  const double reach = tolerance > 0 ? tolerance : place_tolerance(mesh);
  std::set<int> tied;
  for (const Tie& tie : mesh.ties) tied.insert(tie.node);
  for (const int node : followers) {
    const Vec<3> x = node_place(mesh, node);
    const Vec<3> wanted = x + translation;
    const Point there(wanted[0], wanted[1], wanted[2]);
    std::vector<PlacedNode> nearest;
    tree.query(bg::index::nearest(there, 1), std::back_inserter(nearest));
    if (const double off = bg::distance(nearest.front().first, there); off > reach)
      throw InputError(
          fmt::format("node {} of the side set \"{}\" at {} has no partner in \"{}\": the nearest node to {} is {:.3g} "
                      "L0 away, and "
                      "the tolerance is {:.3g} L0. Periodic sides have the same mesh, and are not turned",
                      node + 1, secondary, point_in_words(x, mesh.dimension), primary,
                      point_in_words(wanted, mesh.dimension), off, reach));
    if (tied.count(node) == 0) mesh.ties.push_back({node, {nearest.front().second}, {1.0}, false});
  }
}

}  // namespace ixos

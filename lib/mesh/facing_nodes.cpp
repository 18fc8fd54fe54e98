#include "mesh/facing_nodes.hpp"

#include <algorithm>
#include <array>
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>

#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/selection.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;

/// A side with its middle and the radius of a ball around it that holds the nodes.
struct Ball {
  Side side;
  std::vector<int> nodes;
  Vec<3> middle{};
  double radius = 0;
};

std::vector<Ball> balls(const Mesh& mesh, const std::string& name) {
  std::vector<Ball> result;
  for (const Side& side : side_set_named(mesh, name).sides) {
    Ball ball{side, nodes_of_side(mesh, side)};
    for (const int node : ball.nodes)
      ball.middle = ball.middle + 1 / static_cast<double>(ball.nodes.size()) * node_place(mesh, node);
    for (const int node : ball.nodes) ball.radius = std::max(ball.radius, length(node_place(mesh, node) - ball.middle));
    result.push_back(std::move(ball));
  }
  return result;
}

}  // namespace

FacingNodes facing_nodes(const Mesh& mesh, const std::string& first, const std::string& second, double distance) {
  const std::vector<Ball> own = balls(mesh, first), other = balls(mesh, second);
  using Entry = std::pair<TreePoint, std::size_t>;
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < other.size(); ++k) entries.emplace_back(tree_point(other[k].middle), k);
  const bg::index::rtree<Entry, bg::index::quadratic<8>> tree(entries);
  FacingNodes result;
  for (const Ball& ball : own) {
    std::vector<Entry> found;
    tree.query(bg::index::nearest(tree_point(ball.middle), 1), std::back_inserter(found));
    if (found.empty()) continue;
    const Ball& near = other[found.front().second];
    if (!(length(near.middle - ball.middle) < distance + near.radius + ball.radius)) continue;
    result.sides.push_back(ball.side);
    for (const int node : ball.nodes) {
      const auto nearer = [&](int a, int b) {
        return length(node_place(mesh, a) - node_place(mesh, node)) <
               length(node_place(mesh, b) - node_place(mesh, node));
      };
      result.pairs.emplace_back(node, *std::min_element(near.nodes.begin(), near.nodes.end(), nearer));
    }
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  result.pairs.erase(std::unique(result.pairs.begin(), result.pairs.end()), result.pairs.end());
  return result;
}

}  // namespace ixos

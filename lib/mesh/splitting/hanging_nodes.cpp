#include "mesh/splitting/hanging_nodes.hpp"

#include <cstddef>
#include <set>
#include <unordered_set>

namespace ixos {
namespace {

/// Returns the values at coordinate k/4 of the quadratic functions of the nodes at 0, 1/2 and 1.
std::array<double, 3> quadratic_at(int quarter) {
  const double x = quarter / 4.0;
  return {(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)};
}

class HangingSearch {
 public:
  HangingSearch(CellTree& tree, int order) : tree_(tree), middles_(tree.middles()), order_(order) {}

  HangingNodes result() {
    // Faces first: their middles may also lie on edges of cells that are halved in one direction.
    if (tree_.dimension() == 3)
      for_each_box([&](const TreeCell& leaf) {
        for (int axis = 0; axis < 3; ++axis)
          for (const int end : {0, 1}) look_at_face(leaf, axis, end);
      });
    for_each_box([&](const TreeCell& leaf) {
      for (int axis = 0; axis < tree_.dimension(); ++axis)
        for (const auto& [left, right] : tree_.edges(axis))
          look_at_edge(leaf.corners[static_cast<std::size_t>(left)], leaf.corners[static_cast<std::size_t>(right)]);
    });
    return std::move(result_);
  }

 private:
  /// Simplices have no nodes of others on their edges, and cells that stay whole have neighbours that do.
  template <class Visit>
  void for_each_box(const Visit& visit) const {
    tree_.for_each_leaf([&](const TreeCell& leaf) {
      if (leaf.shape == TreeShape::Box) visit(leaf);
    });
  }

  /// Ties a node, unless it is tied already, to those of the masters that have a weight.
  void tie(int node, const std::vector<int>& masters, const std::vector<double>& weights) {
    if (!tied_.insert(node).second) return;
    Tie own{node, {}, {}};
    for (std::size_t k = 0; k < masters.size(); ++k) {
      if (weights[k] == 0) continue;
      own.masters.push_back(masters[k]);
      own.weights.push_back(weights[k]);
    }
    result_.ties.push_back(std::move(own));
  }

  void look_at_edge(int a, int b) {
    const int m = middles_.find(a, b);
    if (m < 0 || !tree_.is_corner(m)) return;
    if (edges_.insert({std::min(a, b), std::max(a, b)}).second) result_.edges.push_back({a, b, m});
    if (order_ == 1) return tie(m, {a, b}, {0.5, 0.5});
    for (const auto& [end, other] : {std::array{a, b}, std::array{b, a}}) {
      const auto weights = quadratic_at(1);
      if (const int quarter = middles_.find(end, m); quarter >= 0)
        tie(quarter, {end, m, other}, {weights.begin(), weights.end()});
    }
  }

  int between(int a, int b) { return a < 0 || b < 0 ? -1 : middles_.find(a, b); }

  void look_at_face(const TreeCell& leaf, int axis, int end) {
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2, fixed = end << axis;
    const auto corner = [&](int i, int j) {
      return leaf.corners[static_cast<std::size_t>(fixed | i << first | j << second)];
    };
    // Nodes by quarters of the face's edges.
    std::array<std::array<int, 5>, 5> grid;
    for (auto& row : grid) row.fill(-1);
    for (const std::size_t i : {0U, 1U})
      for (const std::size_t j : {0U, 1U}) grid[4 * i][4 * j] = corner(static_cast<int>(i), static_cast<int>(j));
    for (const std::size_t k : {0U, 4U}) {
      grid[2][k] = between(grid[0][k], grid[4][k]);
      grid[k][2] = between(grid[k][0], grid[k][4]);
    }
    grid[2][2] = between(grid[2][0], grid[2][4]);
    if (grid[2][2] < 0) grid[2][2] = between(grid[0][2], grid[4][2]);
    if (order_ == 1) {
      if (grid[2][2] >= 0 && tree_.is_corner(grid[2][2]))
        tie(grid[2][2], {grid[0][0], grid[0][4], grid[4][0], grid[4][4]}, {0.25, 0.25, 0.25, 0.25});
      return;
    }
    const bool halved = tree_.is_corner(grid[2][0]) || tree_.is_corner(grid[0][2]) || tree_.is_corner(grid[2][4]) ||
                        tree_.is_corner(grid[4][2]) || tree_.is_corner(grid[2][2]);
    if (!halved) return;
    for (const std::size_t j : {0U, 2U, 4U})
      for (const std::size_t i : {1U, 3U}) {
        grid[i][j] = between(grid[i - 1][j], grid[i + 1][j]);
        grid[j][i] = between(grid[j][i - 1], grid[j][i + 1]);
      }
    for (const std::size_t i : {1U, 3U}) {  // middles of halves, if only one direction is halved
      if (grid[i][2] < 0) grid[i][2] = between(grid[i][0], grid[i][4]);
      if (grid[2][i] < 0) grid[2][i] = between(grid[0][i], grid[4][i]);
    }
    for (const std::size_t i : {1U, 3U})
      for (const std::size_t j : {1U, 3U}) {
        grid[i][j] = between(grid[i][j - 1], grid[i][j + 1]);
        if (grid[i][j] < 0) grid[i][j] = between(grid[i - 1][j], grid[i + 1][j]);
      }
    std::vector<int> masters;
    for (const std::size_t i : {0U, 2U, 4U})
      for (const std::size_t j : {0U, 2U, 4U}) masters.push_back(grid[i][j]);
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        if ((i % 2 == 0 && j % 2 == 0) || grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] < 0) continue;
        const auto along = quadratic_at(i), across = quadratic_at(j);
        std::vector<double> weights;
        for (const double x : along)
          for (const double y : across) weights.push_back(x * y);
        tie(grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], masters, weights);
      }
  }

  CellTree& tree_;
  MiddleNodes& middles_;
  int order_;
  HangingNodes result_;
  std::unordered_set<int> tied_;
  std::set<std::array<int, 2>> edges_;
};

}  // namespace

HangingNodes find_hanging_nodes(CellTree& tree, int order) { return HangingSearch(tree, order).result(); }

}  // namespace ixos

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "mesh/contact_nodes.hpp"

namespace ixos {
namespace {

using Edge = std::pair<int, int>;

/// The same for both directions of an edge.
Edge key(int a, int b) { return std::minmax(a, b); }

class LagrangeNodes {
 public:
  LagrangeNodes(Mesh& mesh, const SideSet& set, int order) : mesh_(mesh), set_(set), inner_(order - 1) {}

  std::vector<ExtraNodes> add() {
    if (mesh_.dimension == 3) find_rim();
    std::vector<ExtraNodes> result;
    for (const Side& side : set_.sides) {
      const std::vector<int> corners = side_corners(mesh_, side);
      const std::size_t edges = corners.size() == 2 ? 1 : corners.size();
      ExtraNodes extra;
      for (std::size_t k = 0; k < edges; ++k) add_edge(corners[k], corners[(k + 1) % corners.size()], k, extra);
      if (corners.size() == 4) add_interior(corners, extra);
      result.push_back(std::move(extra));
    }
    complete_node_sets(mesh_, added_);
    return result;
  }

 private:
  /// Counts for each edge of the set's faces those faces less all cells around it. A cell has one face in the set, so
  /// that nothing is left where every cell at the edge is enriched along it; cells may also meet in the edge alone.
  void find_rim() {
    constexpr std::array<std::array<int, 2>, 12> edges{
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    for (const Side& side : set_.sides) {
      const std::vector<int> corners = side_corners(mesh_, side);
      for (std::size_t k = 0; k < 4; ++k) ++balance_[key(corners[k], corners[(k + 1) % 4])];
    }
    for (const ElementBlock& block : mesh_.blocks) {
      const int n = nodes_per_cell(block.type);
      for (int cell = 0; cell < block.cells(); ++cell)
        for (const auto& [a, b] : edges) {
          const auto found =
              balance_.find(key(block.nodes[cell_entry(cell, n, a)], block.nodes[cell_entry(cell, n, b)]));
          if (found != balance_.end()) --found->second;
        }
    }
  }

  void add_edge(int first, int second, std::size_t number, ExtraNodes& extra) {
    const auto count = balance_.find(key(first, second));
    if (count != balance_.end() && count->second != 0) {
      extra.tied |= 1U << number;
      extra.nodes.insert(extra.nodes.end(), static_cast<std::size_t>(inner_), first);
      return;
    }
    const auto [known, is_new] = edges_.try_emplace(key(first, second));
    Between& edge = known->second;
    if (is_new) {
      edge.corners = {first, second};
      for (int k = 1; k <= inner_; ++k) {
        const double t = static_cast<double>(k) / (inner_ + 1);
        edge.nodes.push_back(add_point(edge.corners, {1 - t, t}));
      }
      added_.push_back(edge);
    }
    if (edge.corners[0] == first)
      extra.nodes.insert(extra.nodes.end(), edge.nodes.begin(), edge.nodes.end());
    else
      extra.nodes.insert(extra.nodes.end(), edge.nodes.rbegin(), edge.nodes.rend());
  }

  void add_interior(const std::vector<int>& corners, ExtraNodes& extra) {
    Between face{corners, {}};
    for (int j = 1; j <= inner_; ++j)
      for (int i = 1; i <= inner_; ++i) {
        const double s = static_cast<double>(i) / (inner_ + 1), t = static_cast<double>(j) / (inner_ + 1);
        face.nodes.push_back(add_point(corners, {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}));
      }
    extra.nodes.insert(extra.nodes.end(), face.nodes.begin(), face.nodes.end());
    added_.push_back(std::move(face));
  }

  int add_point(const std::vector<int>& corners, const std::vector<double>& weights) {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> x(d, 0.0);
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t i = 0; i < d; ++i)
        x[i] += weights[a] * mesh_.coordinates[static_cast<std::size_t>(corners[a]) * d + i];
    return add_node(mesh_, x, -1);
  }

  Mesh& mesh_;
  const SideSet& set_;
  int inner_;                      ///< nodes inside an edge
  std::map<Edge, int> balance_;    ///< 0: all cells at the edge are enriched along it
  std::map<Edge, Between> edges_;  ///< an edge's nodes, in the direction in which it was met first
  std::vector<Between> added_;
};

}  // namespace

std::vector<ExtraNodes> add_lagrange_nodes(Mesh& mesh, const SideSet& set, int order) {
  return LagrangeNodes(mesh, set, order).add();
}

}  // namespace ixos

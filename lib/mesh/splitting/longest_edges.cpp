#include "mesh/splitting/longest_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/cell_info.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double squared_length(const Mesh& mesh, int a, int b) {
  const auto d = at(mesh.dimension);
  double squares = 0;
  for (std::size_t i = 0; i < d; ++i) {
    const double edge = mesh.coordinates[at(b) * d + i] - mesh.coordinates[at(a) * d + i];
    squares += edge * edge;
  }
  return squares;
}

}  // namespace

LongestEdges::LongestEdges(const Mesh& mesh) {
  for (const ElementBlock& block : mesh.blocks) {
    const CellInfo& info = cell_info(block.type);
    if (tree_shape(info.shape) != TreeShape::Simplex) continue;
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a <= info.dimension; ++a)
        for (int b = 0; b < a; ++b) {
          const int left = block.nodes[cell_entry(cell, info.nodes, a)];
          const int right = block.nodes[cell_entry(cell, info.nodes, b)];
          rank_[{std::min(left, right), std::max(left, right)}] = 0;
        }
  }
  std::vector<std::pair<double, Edge>> sorted;
  for (const auto& [edge, rank] : rank_) sorted.emplace_back(squared_length(mesh, edge[0], edge[1]), edge);
  std::sort(sorted.begin(), sorted.end());
  constexpr double rounding = 1e-10;
  int rank = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (k > 0 && sorted[k].first > (1 + rounding) * sorted[k - 1].first) ++rank;
    rank_[sorted[k].second] = rank;
  }
}

/// Returns the longest edge of a simplex without one of its corners, -1 for none.
MarkedEdges::Edge LongestEdges::longest(const TreeCell& simplex, int left_out) const {
  MarkedEdges::Edge found{};
  std::tuple<int, Edge> most{-1, {}};
  for (int a = 0; a < simplex.count; ++a)
    for (int b = 0; b < a; ++b) {
      if (a == left_out || b == left_out) continue;
      const auto [low, high] = std::minmax(simplex.corners[at(a)], simplex.corners[at(b)]);
      const std::tuple<int, Edge> own{rank_.at({low, high}), {low, high}};
      if (own <= most) continue;
      most = own;
      found = {static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(a)};
    }
  return found;
}

MarkedEdges LongestEdges::marks(const TreeCell& simplex) const {
  MarkedEdges marks;
  marks.refinement = longest(simplex, -1);
  for (int corner = 0; corner < (simplex.count == 4 ? 4 : 0); ++corner)
    marks.faces[at(corner)] = longest(simplex, corner);
  return marks;
}

}  // namespace ixos

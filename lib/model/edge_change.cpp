#include "model/edge_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ixos {
namespace {

/// Returns pairs of corners in Exodus order.
const std::vector<std::array<int, 2>>& edges_of(int dimension) {
  static const std::vector<std::array<int, 2>> quad{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
  static const std::vector<std::array<int, 2>> hex{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}, {{4, 5}}, {{5, 6}},
                                                   {{6, 7}}, {{7, 4}}, {{0, 4}}, {{1, 5}}, {{2, 6}}, {{3, 7}}};
  return dimension == 2 ? quad : hex;
}

}  // namespace

double edge_change(const Model& model, const double* u0, const double* u1) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double largest = 0;  // square
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (const auto& edge : edges_of(mesh.dimension)) {
        const std::size_t a = d * static_cast<std::size_t>(block.nodes[cell_entry(cell, n, edge[0])]);
        const std::size_t b = d * static_cast<std::size_t>(block.nodes[cell_entry(cell, n, edge[1])]);
        double change = 0, length = 0;
        for (std::size_t i = 0; i < d; ++i) {
          const double before = u0[b + i] - u0[a + i], after = u1[b + i] - u1[a + i];
          const double middle = mesh.coordinates[b + i] - mesh.coordinates[a + i] + (before + after) / 2;
          change += (after - before) * (after - before);
          length += middle * middle;
        }
        if (change > 0) largest = std::max(largest, length > 0 ? change / length : std::numeric_limits<double>::max());
      }
  }
  return std::sqrt(model.space().maximum(largest));
}

}  // namespace ixos

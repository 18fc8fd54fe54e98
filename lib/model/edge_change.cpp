#include "model/edge_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "fem/cell_info.hpp"

namespace ixos {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// Returns the edges of a type of cell as pairs of its corners, by number of the type. Those of a plane cell are its
/// sides.
std::vector<Edges> edges_by_type() {
  std::vector<Edges> all;
  for (const CellInfo& info : cell_infos()) {
    std::set<std::pair<int, int>> own;
    for (const std::vector<int>& side : cell_info(info.corners).sides)
      for (std::size_t a = 0; a < side.size(); ++a) own.insert(std::minmax(side[a], side[(a + 1) % side.size()]));
    all.emplace_back(own.begin(), own.end());
  }
  return all;
}

}  // namespace

double edge_change(const Model& model, const double* u0, const double* u1) {
  static const std::vector<Edges> edges = edges_by_type();
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double largest = 0;  // square
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (const auto& [first, second] : edges[static_cast<std::size_t>(block.type)]) {
        const std::size_t a = d * static_cast<std::size_t>(block.nodes[cell_entry(cell, n, first)]);
        const std::size_t b = d * static_cast<std::size_t>(block.nodes[cell_entry(cell, n, second)]);
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

/// Quadrature of a block's cells, and the factors of their shape functions.
#pragma once
#include <array>
#include <vector>

#include "fem/shape_table.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the Gauss points along each direction. For an enriched element the block gives the number along the contact
/// side; linear elements take `points` in every direction, quadratic ones one more. 0 stands for the element's own
/// number.
template <class Element>
std::array<int, Element::dimension> cell_points(const LocalBlock& block, int points) {
  std::array<int, Element::dimension> counts = Element::default_points;
  const bool enriched = is_enriched(block.type);
  for (std::size_t d = 0; enriched && block.points > 0 && d + 1 < counts.size(); ++d) counts[d] = block.points;
  if (!enriched && points > 0) counts.fill(is_quadratic(block.type) ? points + 1 : points);
  return counts;
}

/// Returns cells x nodes factors, see node_scale(); empty if all are 1.
inline std::vector<double> node_scales(const LocalBlock& block) {
  std::vector<double> scales;
  if (block.derivative_scale.empty()) return scales;
  const int n = nodes_per_cell(block.type);
  for (int cell = 0; cell < block.cells(); ++cell)
    for (int a = 0; a < n; ++a) scales.push_back(node_scale(block, cell, a));
  return scales;
}

}  // namespace ixos

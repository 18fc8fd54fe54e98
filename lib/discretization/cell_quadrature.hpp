/// Quadrature of a block's cells, and the factors of their shape functions.
#pragma once
#include <array>
#include <vector>

#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the rule of a block's cells, with `points` along each direction, see element_rule(); quadratic elements take
/// one more. 0 stands for the element's own rule, as do 1 and 2 for triangles, tetrahedra, prisms and pyramids, which
/// need that many points at least. For an enriched element the block gives the number along the contact
/// side.
template <class Element>
QuadratureRule<Element::dimension> cell_rule(const LocalBlock& block, int points) {
  if constexpr (CellTraits<Element>::contact_side >= 0) {
    auto counts = Element::default_points;
    for (std::size_t d = 0; block.points > 0 && d + 1 < counts.size(); ++d) counts[d] = block.points;
    return product_rule(counts);
  } else if constexpr (HasRule<Element>::value) {
    return points > 2 ? element_rule<Element>(points + CellTraits<Element>::order - 1)
                      : own_rule<Element>(block.high_rule);
  } else {
    return points > 0 ? element_rule<Element>(points + CellTraits<Element>::order - 1)
                      : own_rule<Element>(block.high_rule);
  }
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

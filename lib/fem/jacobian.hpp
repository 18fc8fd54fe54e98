/// The derivative of the geometry map of a cell or a side.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/enriched_cell.hpp"

namespace ixos {

/// Returns the factor of each node's shape function in its cell, see node_scale(). `Block` is an ElementBlock or a
/// LocalBlock.
template <class Element, class Block>
std::array<double, Element::nodes> cell_scales(const Block& block, int cell) {
  std::array<double, Element::nodes> scales;
  for (std::size_t a = 0; a < scales.size(); ++a) scales[a] = node_scale(block, cell, static_cast<int>(a));
  return scales;
}

/// Returns dX_i/dxi_d at a point with shape gradients dN_a/dxi_d, in a space of S dimensions [L0]. `coordinates`: nodes
/// x S; `nodes` and `scales`: the element's.
template <std::size_t S, std::size_t N, std::size_t D>
Small<double, S, D> jacobian(const std::vector<double>& coordinates, const int* nodes,
                             const std::array<double, N>& scales,
                             const std::array<std::array<double, D>, N>& gradient) {
  Small<double, S, D> result{};
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t i = 0; i < S; ++i)
      for (std::size_t d = 0; d < D; ++d)
        result[i][d] += scales[a] * coordinates[static_cast<std::size_t>(nodes[a]) * S + i] * gradient[a][d];
  return result;
}

/// Returns the Jacobian at a point of a cell without factors, in the space of its dimension.
template <class Element, std::size_t D>
Small<double, D> jacobian_at(const std::array<double, D>& xi, const std::vector<double>& coordinates,
                             const int* nodes) {
  std::array<double, Element::nodes> ones, value;
  ones.fill(1);
  std::array<std::array<double, D>, Element::nodes> gradient;
  Element::evaluate(xi, value, gradient);
  return jacobian<D>(coordinates, nodes, ones, gradient);
}

}  // namespace ixos

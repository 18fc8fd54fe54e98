/// Shape functions at the points of an even grid.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/ties.hpp"

namespace ixos {

/// Returns the values of an element's shape functions at the points of a grid, the first direction fastest: `counts`
/// points, at least 2, along each reference direction, evenly from -1 to 1, so that the corners are among them. `tied`:
/// see evaluate_tied().
template <class Element>
std::vector<std::array<double, Element::nodes>> shape_grid(const std::array<int, Element::dimension>& counts,
                                                           unsigned tied = 0) {
  constexpr std::size_t D = Element::dimension, N = Element::nodes;
  std::size_t size = 1;
  for (int count : counts) size *= static_cast<std::size_t>(count);
  std::vector<std::array<double, N>> values(size);
  std::array<std::array<double, D>, N> gradient;
  for (std::size_t k = 0; k < size; ++k) {
    std::array<double, D> xi;
    std::size_t rest = k;
    for (std::size_t d = 0; d < D; ++d) {
      const auto count = static_cast<std::size_t>(counts[d]);
      xi[d] = -1 + 2 * static_cast<double>(rest % count) / static_cast<double>(count - 1);
      rest /= count;
    }
    evaluate_tied<Element>(tied, xi, values[k], gradient);
  }
  return values;
}

}  // namespace ixos

/// Shape functions at the points of an even grid.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/shape_table.hpp"
#include "fem/ties.hpp"

namespace ixos {

/// Returns the points of an even grid, the first direction fastest: `counts` points, at least 2, along each reference
/// direction from -1 to 1, so that the corners are among them. On the triangle those of the grid in it, from 0 to 1.
template <class Element>
std::vector<std::array<double, Element::dimension>> grid_points(const std::array<int, Element::dimension>& counts) {
  constexpr std::size_t D = Element::dimension;
  static_assert(!HasRule<Element>::value || D == 2, "of these shapes only the triangle has a grid");
  std::size_t size = 1;
  for (int count : counts) size *= static_cast<std::size_t>(count);
  std::vector<std::array<double, D>> points;
  for (std::size_t k = 0; k < size; ++k) {
    std::array<double, D> xi;
    std::size_t rest = k, steps = 0;
    for (std::size_t d = 0; d < D; ++d) {
      const auto count = static_cast<std::size_t>(counts[d]);
      const std::size_t step = rest % count;
      xi[d] = HasRule<Element>::value ? static_cast<double>(step) / static_cast<double>(count - 1)
                                      : -1 + 2 * static_cast<double>(step) / static_cast<double>(count - 1);
      rest /= count;
      steps += step;
    }
    if (!HasRule<Element>::value || steps < static_cast<std::size_t>(counts[0])) points.push_back(xi);
  }
  return points;
}

/// Returns the values of an element's shape functions at grid_points(). `tied`: see evaluate_tied().
template <class Element>
std::vector<std::array<double, Element::nodes>> shape_grid(const std::array<int, Element::dimension>& counts,
                                                           unsigned tied = 0) {
  std::vector<std::array<double, Element::nodes>> values;
  std::array<std::array<double, Element::dimension>, Element::nodes> gradient;
  for (const auto& xi : grid_points<Element>(counts)) evaluate_tied<Element>(tied, xi, values.emplace_back(), gradient);
  return values;
}

}  // namespace ixos

/// The diagonal entries of some degrees of freedom in a matrix.
#pragma once
#include <cstddef>
#include <vector>

#include "discretization/pattern.hpp"

namespace ixos {

/// Returns the number of a rank's own degrees of freedom.
inline std::size_t owned_dofs(const Pattern& pattern) {
  return static_cast<std::size_t>(pattern.rows()) * static_cast<std::size_t>(pattern.dimension());
}

/// Stands for a degree of freedom without a row on this rank.
constexpr std::size_t no_place = static_cast<std::size_t>(-1);

/// Returns, parallel to `dofs`, the places of the diagonal entries in the matrix values; globals, from `first_global`
/// on, have none.
inline std::vector<std::size_t> diagonal_places(const std::vector<int>& dofs, const Pattern& pattern,
                                                int first_global) {
  std::vector<std::size_t> places;
  for (const int dof : dofs) {
    if (dof >= first_global) {
      places.push_back(no_place);
      continue;
    }
    const int node = dof / pattern.dimension(), i = dof % pattern.dimension();
    places.push_back(pattern.has_row(node)
                         ? static_cast<std::size_t>(pattern.offset(node, node) + (pattern.stride(node) + 1) * i)
                         : no_place);
  }
  return places;
}

/// Adds factor times the coefficients at these places.
inline void add_to_places(double factor, const std::vector<double>& coefficients,
                          const std::vector<std::size_t>& places, double* values) {
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places[k] != no_place) values[places[k]] += factor * coefficients[k];
}

}  // namespace ixos

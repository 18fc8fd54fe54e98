/// Shape functions at quadrature points.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "fem/quadrature.hpp"
#include "fem/ties.hpp"

namespace ixos {

/// Values of an element's shape functions at the points of a tensor product of Gauss rules, the first direction
/// fastest.
template <class Element>
struct ShapeTable {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;

  /// `counts`: points along each reference direction, 1 to 64. `tied`: edges kept straight, see evaluate_tied().
  explicit ShapeTable(const std::array<int, D>& counts = Element::default_points, unsigned tied = 0)
      : two_points(std::all_of(counts.begin(), counts.end(), [](int count) { return count == 2; })) {
    std::array<Quadrature, D> rules;
    std::size_t size = 1;
    for (std::size_t d = 0; d < D; ++d) {
      rules[d] = gauss_legendre(counts[d]);
      size *= rules[d].points.size();
    }
    weight.assign(size, 1.0);
    point.resize(size);
    value.resize(size);
    gradient.resize(size);
    for (std::size_t q = 0; q < size; ++q) {
      std::array<double, D>& xi = point[q];
      std::size_t rest = q;
      for (std::size_t d = 0; d < D; ++d) {
        const std::size_t i = rest % rules[d].points.size();
        rest /= rules[d].points.size();
        xi[d] = rules[d].points[i];
        weight[q] *= rules[d].weights[i];
      }
      evaluate_tied<Element>(tied, xi, value[q], gradient[q]);
    }
  }

  /// Makes the table at the points of another element's.
  template <class Other>
  explicit ShapeTable(const ShapeTable<Other>& other)
      : two_points(other.two_points),
        weight(other.weight),
        point(other.point),
        value(other.size()),
        gradient(other.size()) {
    for (std::size_t q = 0; q < size(); ++q) Element::evaluate(point[q], value[q], gradient[q]);
  }

  std::size_t size() const { return weight.size(); }

  bool two_points;                                             ///< whether there are two along each direction
  std::vector<double> weight;                                  ///< quadrature weights
  std::vector<std::array<double, D>> point;                    ///< xi_q
  std::vector<std::array<double, N>> value;                    ///< N_a(xi_q)
  std::vector<std::array<std::array<double, D>, N>> gradient;  ///< dN_a/dxi_d (xi_q)
};

}  // namespace ixos

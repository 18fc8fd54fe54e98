/// Points and weights of quadrature.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace ixos {

struct Quadrature {
  std::vector<double> points;
  std::vector<double> weights;
};

/// Returns the Gauss-Legendre rule with n points on [-1, 1], exact for polynomials of degree 2n - 1, points ascending.
/// Finds the roots of the Legendre polynomial by Newton's method from the asymptotic guess (Abramowitz and Stegun 1964,
/// 25.4.29). Throws InputError unless 1 <= n <= 64.
Quadrature gauss_legendre(int n);

/// Returns that rule mapped to [0, 1].
Quadrature gauss_legendre_unit(int n);

/// Returns the Gauss-Jacobi rule with n points for integrals of (1 - x)^power f(x) over [0, 1], exact for f of degree
/// 2n - 1. Finds the roots one after another by Newton's method with deflation. Throws InputError unless 1 <= n <= 64.
Quadrature gauss_jacobi_unit(int n, int power);

/// Points of a reference shape of D dimensions, and their weights.
template <std::size_t D>
struct QuadratureRule {
  std::vector<std::array<double, D>> points;
  std::vector<double> weights;
  std::array<int, D> along{};  ///< of a product of Gauss rules: the points along each direction; 0: another rule

  std::size_t size() const { return weights.size(); }
  bool operator==(const QuadratureRule& other) const { return points == other.points && weights == other.weights; }
};

/// Returns the points of a rule with three coordinates, of which the last are 0 in fewer directions.
template <std::size_t D>
std::vector<std::array<double, 3>> places_of(const QuadratureRule<D>& rule) {
  std::vector<std::array<double, 3>> places;
  for (const std::array<double, D>& point : rule.points) {
    places.emplace_back();
    for (std::size_t i = 0; i < D; ++i) places.back()[i] = point[i];
  }
  return places;
}

/// Returns the product of Gauss rules with that many points along each direction, 1 to 64, the first direction fastest.
template <std::size_t D>
QuadratureRule<D> product_rule(const std::array<int, D>& along) {
  std::array<Quadrature, D> rules;
  std::size_t size = 1;
  for (std::size_t d = 0; d < D; ++d) {
    rules[d] = gauss_legendre(along[d]);
    size *= rules[d].points.size();
  }
  QuadratureRule<D> rule{{}, std::vector<double>(size, 1.0), along};
  rule.points.resize(size);
  for (std::size_t q = 0; q < size; ++q) {
    std::size_t rest = q;
    for (std::size_t d = 0; d < D; ++d) {
      const std::size_t i = rest % rules[d].points.size();
      rest /= rules[d].points.size();
      rule.points[q][d] = rules[d].points[i];
      rule.weights[q] *= rules[d].weights[i];
    }
  }
  return rule;
}

}  // namespace ixos

/// Bernstein polynomials, whose coefficients bound a polynomial on [0, 1].
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

/// Returns the binomial coefficient C(n, k).
constexpr double binomial(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 1; i <= k; ++i) result = result * static_cast<double>(n - k + i) / static_cast<double>(i);
  return result;
}

/// From the powers of t to Bernstein polynomials of the same degree: b_i = sum_(k <= i) share[i][k] c_k with the
/// factors C(i, k)/C(degree, k). The polynomial lies between the least and the largest b_i on [0, 1].
template <std::size_t Degree>
constexpr std::array<std::array<double, Degree + 1>, Degree + 1> bernstein_shares() {
  std::array<std::array<double, Degree + 1>, Degree + 1> shares{};
  for (std::size_t i = 0; i <= Degree; ++i)
    for (std::size_t k = 0; k <= i; ++k) shares[i][k] = binomial(i, k) / binomial(Degree, k);
  return shares;
}

}  // namespace ixos

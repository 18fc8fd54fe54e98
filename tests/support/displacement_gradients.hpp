/// Displacement gradients for tests of elastic laws and kernels.
#pragma once
#include <cmath>
#include <cstddef>

#include "base/small_matrix.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos::test {

/// Returns a displacement gradient without any symmetry, entries up to `size`; another phase gives another one.
template <std::size_t D>
Small<double, D> sample(double size, double phase = 1.0) {
  Small<double, D> h{};
  for (auto& row : h)
    for (double& value : row) value = size * std::sin(phase += 1.3);
  return h;
}

/// A number with the derivatives by the entries of a displacement gradient, row by row.
template <std::size_t D>
using OfGradient = Dual<static_cast<int>(D* D)>;

/// Returns the gradient with its entries as the independent variables.
template <std::size_t D>
Small<OfGradient<D>, D> seeded(const Small<double, D>& h) {
  Small<OfGradient<D>, D> result{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      result[i][j] = variable<static_cast<int>(D * D)>(static_cast<int>(i * D + j), h[i][j]);
  return result;
}

}  // namespace ixos::test

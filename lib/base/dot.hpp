/// The inner product of two arrays.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// Returns the inner product of the first `count` entries.
inline double dot(const double* x, const double* y, std::size_t count) {
  double sums[8] = {};  // in turn: one would wait for itself
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8)
    for (std::size_t k = 0; k < 8; ++k) sums[k] += x[i + k] * y[i + k];
  for (; i < count; ++i) sums[0] += x[i] * y[i];
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}
/// In a local array a rank's owned entries come first.
inline double dot(const std::vector<double>& x, const std::vector<double>& y, std::size_t count) {
  return dot(x.data(), y.data(), count);
}

}  // namespace ixos

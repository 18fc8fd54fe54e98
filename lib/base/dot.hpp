/// The inner product of two arrays.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// Returns the inner product of the first `count` entries: in a local array a rank's owned entries come first.
inline double dot(const std::vector<double>& x, const std::vector<double>& y, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace ixos

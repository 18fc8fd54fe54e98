/// Vectors in space. In two dimensions the third component is 0.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

/// T is double, or Pack.
template <class T>
T dot(const std::array<T, 3>& x, const std::array<T, 3>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

template <class T>
std::array<T, 3> cross(const std::array<T, 3>& x, const std::array<T, 3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// Returns the unit vector along axis k.
inline std::array<double, 3> basis_vector(std::size_t k) {
  std::array<double, 3> e{};
  e[k] = 1;
  return e;
}

}  // namespace ixos

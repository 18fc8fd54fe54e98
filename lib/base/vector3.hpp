/// Vectors in space. In two dimensions the third component is 0.
#pragma once
#include <array>

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

}  // namespace ixos

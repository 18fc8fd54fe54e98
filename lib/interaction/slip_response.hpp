/// Friction at a point of a surface as a function of its slip.
#pragma once
#include <array>
#include <cstddef>

#include "base/small_matrix.hpp"

namespace ixos {

/// The parts of a response that a function computes: the traction and its derivative by the threshold, or all.
enum class SlipPart { Traction, All };

/// The traction t that resists a slip q, its derivative by q, and its derivative by the threshold. The projector onto
/// the tangent plane is part of the derivative by q.
template <class T, std::size_t D>
struct SlipResponse {
  std::array<T, D> traction{};      ///< [E0]
  Small<T, D> stiffness{};          ///< [E0/L0]
  std::array<T, D> by_threshold{};  ///< [-]
};

template <class T, std::size_t D>
T inner(const std::array<T, D>& a, const std::array<T, D>& b) {
  T sum = a[0] * b[0];
  for (std::size_t i = 1; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace ixos

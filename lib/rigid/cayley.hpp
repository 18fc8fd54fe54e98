/// Cayley's map from vectors to rotations, and what it makes of rates and moments.
#pragma once
#include <array>
#include <cstddef>

#include "base/turn.hpp"

namespace ixos {

/// The rotation Q = (I - A/2)^-1 (I + A/2), A x = w x x, by the angle 2 atan(|w|/2) about w, any less than half a turn.
/// It joins the mean M = (I + Q)/2 to the difference, Q - I = M A, on which the conservation laws of a rigid body in
/// steps of finite length rest (Simo and Wong 1991, section 3).
template <class T>
Small<T, 3> cayley_turn(const std::array<T, 3>& w) {
  const Small<T, 3> a = axial_matrix(w), square = product(a, a);
  const T factor = T(1.0) / (T(1.0) + dot(w, w) * 0.25);
  Small<T, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = factor * (a[i][j] + square[i][j] * 0.5);
  return result;
}

/// Returns the spin in the body's axes, Q^T Q' = [spin]x, from w and w': (w' - w x w'/2)/(1 + |w|^2/4).
template <class T>
std::array<T, 3> cayley_spin(const std::array<T, 3>& w, const std::array<T, 3>& rate) {
  const std::array<T, 3> across = cross(w, rate);
  const T factor = T(1.0) / (T(1.0) + dot(w, w) * 0.25);
  std::array<T, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = factor * (rate[i] - 0.5 * across[i]);
  return result;
}

/// Returns the rate of that spin, from w, w' and w''.
template <class T>
std::array<T, 3> cayley_spin_rate(const std::array<T, 3>& w, const std::array<T, 3>& rate,
                                  const std::array<T, 3>& acceleration) {
  std::array<T, 3> result = cayley_spin(w, acceleration);
  const std::array<T, 3> spin = cayley_spin(w, rate);
  const T factor = dot(w, rate) * 0.5 / (T(1.0) + dot(w, w) * 0.25);
  for (std::size_t i = 0; i < 3; ++i) result[i] -= factor * spin[i];
  return result;
}

/// Returns the force that does on w' the work of a moment in the body's axes on the spin: the transpose of
/// cayley_spin(), in which w changes its sign.
template <class T>
std::array<T, 3> cayley_force(const std::array<T, 3>& w, const std::array<T, 3>& moment) {
  return cayley_spin(scaled(-1, w), moment);
}

/// Returns the moment for a force, the inverse of cayley_force(): f - w x f/2 + w (w . f)/4.
inline std::array<double, 3> cayley_moment(const std::array<double, 3>& w, const std::array<double, 3>& force) {
  return sum(sum(force, cross(w, force), -0.5), w, dot(w, force) / 4);
}

}  // namespace ixos

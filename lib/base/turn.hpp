/// Rotations in space, as what they add to the identity.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/small_matrix.hpp"
#include "base/vector3.hpp"

namespace ixos {

/// R - I of a rotation R: a small rotation keeps all its digits.
using Turn = Small<double, 3>;

/// Returns the matrix of x -> v x x.
template <class T>
Small<T, 3> axial_matrix(const std::array<T, 3>& v) {
  return {{{T(0.0), -v[2], v[1]}, {v[2], T(0.0), -v[0]}, {-v[1], v[0], T(0.0)}}};
}

template <class T>
std::array<T, 3> times(const Small<T, 3>& m, const std::array<T, 3>& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

/// Returns M^T v.
template <class T>
std::array<T, 3> transposed_times(const Small<T, 3>& m, const std::array<T, 3>& v) {
  std::array<T, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[j] += m[i][j] * v[i];
  return result;
}

template <class T>
std::array<T, 3> sum(std::array<T, 3> x, const std::array<T, 3>& y, double factor = 1) {
  for (std::size_t i = 0; i < 3; ++i) x[i] += factor * y[i];
  return x;
}

template <class T>
std::array<T, 3> scaled(double factor, std::array<T, 3> x) {
  for (T& value : x) value *= factor;
  return x;
}

/// Return R v and R^T v.
inline std::array<double, 3> turned(const Turn& turn, const std::array<double, 3>& v) { return sum(v, times(turn, v)); }
inline std::array<double, 3> turned_back(const Turn& turn, const std::array<double, 3>& v) {
  return sum(v, transposed_times(turn, v));
}

/// Returns the matrix R.
inline Small<double, 3> rotation_matrix(Turn turn) {
  for (std::size_t i = 0; i < 3; ++i) turn[i][i] += 1;
  return turn;
}

/// Returns the turn of R S.
inline Turn compose(const Turn& r, const Turn& s) {
  Turn result = product(r, s);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] += r[i][j] + s[i][j];
  return result;
}

/// Returns the turn by an angle [rad] about a unit vector (Rodrigues 1840).
inline Turn turn_about(const std::array<double, 3>& axis, double angle) {
  const double sine = std::sin(angle), half = std::sin(angle / 2);
  const Small<double, 3> n = axial_matrix(axis), square = product(n, n);
  Turn result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = sine * n[i][j] + 2 * half * half * square[i][j];
  return result;
}

}  // namespace ixos

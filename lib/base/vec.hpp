/// Vectors of a fixed number of components.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace ixos {

template <std::size_t D>
using Vec = std::array<double, D>;

template <std::size_t D>
Vec<D> operator+(const Vec<D>& a, const Vec<D>& b) {
  Vec<D> sum;
  for (std::size_t i = 0; i < D; ++i) sum[i] = a[i] + b[i];
  return sum;
}

template <std::size_t D>
Vec<D> operator-(const Vec<D>& a, const Vec<D>& b) {
  Vec<D> difference;
  for (std::size_t i = 0; i < D; ++i) difference[i] = a[i] - b[i];
  return difference;
}

template <std::size_t D>
Vec<D> operator*(double s, const Vec<D>& a) {
  Vec<D> product;
  for (std::size_t i = 0; i < D; ++i) product[i] = s * a[i];
  return product;
}

/// Returns the inner product.
template <std::size_t D>
double inner(const Vec<D>& a, const Vec<D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

inline double length(const Vec<2>& a) { return std::hypot(a[0], a[1]); }
inline double length(const Vec<3>& a) { return std::hypot(a[0], a[1], a[2]); }

/// Returns whether two directions differ by 30 degrees or less.
template <std::size_t D>
bool meet_smoothly(const Vec<D>& before, const Vec<D>& after) {
  return inner(before, after) >= std::sqrt(3.0) / 2 * length(before) * length(after);
}

}  // namespace ixos

/// The projection of a field in one element on linear functions of the position.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/pack.hpp"

namespace ixos {

/// The orthogonal projection on {1, X} in the sum over an element's quadrature points, X the reference position:
///   Pi v = sum_i psi_i (sum over the points of w psi_i v),  psi orthonormal in that sum,
/// which Gram and Schmidt's method yields. A function that the points do not see, such as a coordinate that is the
/// same at all of them, is left out.
template <class T, std::size_t D>
class LinearProjection {
 public:
  /// The number of functions.
  static constexpr std::size_t size = D + 1;

  LinearProjection() = default;
  /// `places`: X at the points [L0]; `points` have the quadrature weights.
  template <class Point>
  LinearProjection(const std::vector<Point>& points, const std::vector<std::array<T, D>>& places)
      : functions_(points.size()) {
    using std::sqrt;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t q = 0; q < functions_.size(); ++q) functions_[q][i] = i == 0 ? T(1.0) : places[q][i - 1];
      const T before = product(points, i, i);
      // The second pass removes what rounding left of the first.
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t j = 0; j < i; ++j) {
          const T share = product(points, i, j);
          for (std::array<T, size>& values : functions_) values[i] -= share * values[j];
        }
      const T square = product(points, i, i);
      const auto is_seen = square > rounding * before;
      const T factor = select(is_seen, T(1.0 / sqrt(T(select(is_seen, square, T(1.0))))), T(0.0));
      for (std::array<T, size>& values : functions_) values[i] *= factor;
    }
  }

  /// Returns the functions at a point.
  const std::array<T, size>& at(std::size_t q) const { return functions_[q]; }

  /// Computes the projection at the points from the values there. `points`: those of the constructor.
  template <class Point>
  void project(const std::vector<Point>& points, const T* values, T* result) const {
    std::array<T, size> shares{};
    for (std::size_t q = 0; q < functions_.size(); ++q) {
      const T weighted = points[q].weight * values[q];
      for (std::size_t i = 0; i < size; ++i) shares[i] += weighted * functions_[q][i];
    }
    for (std::size_t q = 0; q < functions_.size(); ++q) {
      T sum = shares[0] * functions_[q][0];
      for (std::size_t i = 1; i < size; ++i) sum += shares[i] * functions_[q][i];
      result[q] = sum;
    }
  }

 private:
  /// A square below this share of a function's own is one of rounding errors.
  static constexpr double rounding = 1e-24;

  template <class Point>
  T product(const std::vector<Point>& points, std::size_t i, std::size_t j) const {
    T sum(0.0);
    for (std::size_t q = 0; q < functions_.size(); ++q) sum += points[q].weight * functions_[q][i] * functions_[q][j];
    return sum;
  }

  std::vector<std::array<T, size>> functions_;  ///< psi_i, by point
};

}  // namespace ixos

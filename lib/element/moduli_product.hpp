/// A tangent at quadrature points, applied without a matrix: of laws of any moduli.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/pack.hpp"
#include "element/displacement_gradient.hpp"
#include "element/prefetch.hpp"
#include "material/points.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// K u from the moduli at the quadrature points, in plane strain and in three dimensions. With G = dxi/dX the law's
/// moduli A act on g = du/dxi as
///
///   t_id = B_idke g_ke,  B_idke = w G_dJ A_iJkL G_eL,
///
/// summed over the time points and the undeformed body: D^2 (D^2 + 1)/2 numbers a point, 45 in three dimensions,
/// whatever the number of time points; and the point's mass. SpatialProduct needs fewer numbers for laws with a spatial
/// tangent, and is better in single precision: here, rotations cost an energy of 1e-7 of that of a strain of their
/// size. The tangent is symmetric. See SpatialProduct for what the functions compute.
template <std::size_t D>
class ModuliProduct {
  static constexpr std::size_t size = D * D;
  static constexpr std::size_t moduli_size = size * (size + 1) / 2;

 public:
  static constexpr std::size_t most = 32;  ///< points that keep() takes at once

  /// Without a mass; for moduli of any source, see keep_moduli().
  ModuliProduct() = default;
  ModuliProduct(Rule rule, double rest, double inertia) : rule_(std::move(rule)), rest_(rest), inertia_(inertia) {}

  bool has_mass() const { return inertia_ != 0; }
  std::size_t point_size() const { return moduli_size + (has_mass() ? 1 : 0); }

  /// Fills in the data of some points, not more than `most`. `law`: LawPoints or a PointLaw.
  template <class Points, class T, class Kept>
  void keep(const Points& law, const PointEnds<T, D>& ends, const SpacePoint<T, D>* points, Kept* data) const {
    std::array<Small<T, size>, most> moduli;
    law.moduli(ends, rule_, moduli.data());
    if (rest_ != 0) {
      const Small<T, D> undeformed{};  // at rest all points are alike
      Small<T, size> at_rest;
      law.moduli(PointEnds<T, D>{1, &undeformed, nullptr, nullptr}, end_rule(), &at_rest);
      for (std::size_t q = 0; q < ends.size; ++q)
        for (std::size_t r = 0; r < size; ++r)
          for (std::size_t c = 0; c < size; ++c) moduli[q][r][c] += rest_ * at_rest[r][c];
    }
    keep_moduli(ends.size, moduli.data(), points, data);
  }

  /// Fills in the data for symmetric moduli, row i D + J.
  template <class T, class Kept>
  void keep_moduli(std::size_t count, const Small<T, size>* moduli, const SpacePoint<T, D>* points, Kept* data) const {
    for (std::size_t q = 0; q < count; ++q) {
      const Small<T, size> mixed = in_element_coordinates(moduli[q], points[q].inverse_jacobian);
      for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = r; c < size; ++c) *data++ = narrow<Kept>(T(points[q].weight * mixed[r][c]));
      if (has_mass()) *data++ = narrow<Kept>(T(inertia_ * points[q].weight));
    }
  }

  template <class T, class Kept>
  [[gnu::noinline]] void multiply(std::size_t count, const Kept* data, Small<T, D>* gradients,
                                  std::array<T, D>* values) const {
    const std::size_t own = point_size();
    for (std::size_t q = 0; q < count; ++q, data += own) {
      if constexpr (D == 3) prefetch(data + count * own, own);
      multiply(data, gradients[q]);
      if (values == nullptr) continue;
      const T mass = widen<T>(data[moduli_size]);
      for (T& v : values[q]) v *= mass;
    }
  }

  template <class T, class Kept>
  Small<T, D, D * D> diagonal(const Kept* data) const {
    Small<T, D, D * D> b;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = 0; e < D; ++e) b[i][d * D + e] = widen<T>(data[place(i * D + d, i * D + e)]);
    return b;
  }

 private:
  /// Returns the position of an entry in the upper triangle, stored row by row.
  static constexpr std::size_t place(std::size_t r, std::size_t c) {
    return r > c ? place(c, r) : r * size - r * (r + 1) / 2 + c;
  }

  /// Returns G_dJ A_iJkL G_eL, row i D + d, column k D + e.
  template <class T>
  static Small<T, size> in_element_coordinates(const Small<T, size>& moduli, const Small<T, D>& g) {
    Small<T, size> half{}, result{};
    for (std::size_t r = 0; r < size; ++r)
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t e = 0; e < D; ++e)
          for (std::size_t l = 0; l < D; ++l) half[r][k * D + e] += moduli[r][k * D + l] * g[e][l];
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t c = 0; c < size; ++c) result[i * D + d][c] += g[d][j] * half[i * D + j][c];
    return result;
  }

  // Inlined, as a call for each point would go through memory. The recursion over rows has constant bounds in each, so
  // that compilers unroll all of it and keep the sums in registers.
  template <class T, class Kept>
  [[gnu::always_inline]] static void multiply(const Kept* data, Small<T, D>& gradient) {
    std::array<T, size> x, y;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        x[i * D + d] = gradient[i][d];
        y[i * D + d] = T(0);
      }
    add_rows<0>(data, x, y);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) gradient[i][d] = y[i * D + d];
  }
  /// Adds the part of the rows from `row` on, and of the columns below.
  template <std::size_t row, class T, class Kept>
  [[gnu::always_inline]] static void add_rows(const Kept* data, const std::array<T, size>& x, std::array<T, size>& y) {
    T sum = widen<T>(data[0]) * x[row];
    for (std::size_t k = 1; k < size - row; ++k) {
      const T value = widen<T>(data[k]);
      sum += value * x[row + k];
      y[row + k] += value * x[row];
    }
    y[row] += sum;
    if constexpr (row + 1 < size) add_rows<row + 1>(data + (size - row), x, y);
  }

  Rule rule_;
  double rest_ = 0, inertia_ = 0;
};

}  // namespace ixos

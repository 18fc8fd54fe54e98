/// The elastic tangent of an element applied without forming its matrix, for laws of any moduli.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "element/elastic_kernel.hpp"
#include "element/point_gradients.hpp"

namespace ixos {

/// The layout of the data that ModuliAction keeps, the same for all elements of D dimensions.
template <std::size_t D>
struct ModuliLayout {
  static constexpr std::size_t moduli_size = D * D * (D * D + 1) / 2;

  ModuliLayout() = default;
  template <class Material>
  ModuliLayout(const Material& /*material*/, const Rule& /*rule*/, double /*rest*/, double inertia)
      : has_mass(inertia != 0) {}
  std::size_t point_size() const { return moduli_size + (has_mass ? 1 : 0); }

  bool has_mass = false;
};

/// K u from the moduli at the quadrature points, in plane strain and in three dimensions. With G = dxi/dX the law's
/// moduli A act on g = du/dxi as
///
///   t_id = B_idke g_ke,  B_idke = w G_dJ A_iJkL G_eL,
///
/// summed over the time points and the undeformed body: D^2 (D^2 + 1)/2 numbers a point, 45 in three dimensions,
/// whatever the number of time points; and the point's mass. ElasticAction needs fewer numbers for laws with a spatial
/// tangent, and is better in single precision: here, rotations cost an energy of 1e-7 of that of a strain of their
/// size. The tangent is symmetric. See ElasticAction for what the functions compute.
template <class Element, class Material>
struct ModuliAction {
  using Kernel = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr std::size_t size = D * D;
  using Layout = ModuliLayout<D>;
  static constexpr std::size_t moduli_size = Layout::moduli_size;
  /// The action of the same data on another element's nodes.
  template <class Other>
  using On = ModuliAction<Other, Material>;
  template <class T>
  using Nodal = typename Kernel::template Nodal<T>;

  template <class T>
  using Scratch = PointScratch<D, T>;

  template <class T, class Kept>
  static void linearize(const Material& material, const typename Kernel::template Geometry<T>& geometry,
                        const typename Kernel::template Segment<T>& segment, const Rule& rule, double rest,
                        double inertia, Kept* data) {
    keep(geometry.points, inertia, data, [&](std::size_t q) {
      const typename Kernel::template Ends<T> ends(segment, Kernel::shape_gradients(geometry, q));
      Small<T, size> sum{};
      const auto add = [&](const Small<T, D>& h, double weight) {
        Small<T, D> p;
        Small<T, size> moduli;
        material.stress_and_moduli(h, p, moduli);
        for (std::size_t r = 0; r < size; ++r)
          for (std::size_t c = 0; c < size; ++c) sum[r][c] += weight * moduli[r][c];
      };
      for (const RulePoint& time : rule.points) add(ends.at(time), time.weight * time.to);
      if (rest != 0) add({}, rest);
      return sum;
    });
  }

  /// Fills `data` for moduli of any source: moduli(point) returns those of a point, symmetric, row i D + J.
  template <class T, class Kept, class Moduli>
  static void keep(const std::vector<SpacePoint<T, D>>& points, double inertia, Kept* data, const Moduli& moduli) {
    for (std::size_t q = 0; q < points.size(); ++q) {
      const Small<T, size> mixed = in_element_coordinates(moduli(q), points[q].inverse_jacobian);
      for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = r; c < size; ++c) *data++ = narrow<Kept>(T(points[q].weight * mixed[r][c]));
      if (inertia != 0) *data++ = narrow<Kept>(T(inertia * points[q].weight));
    }
  }

  template <class T, class Kept>
  static void add_product(const ShapeTable<Element>& table, const Layout& layout, const Kept* data, const Nodal<T>& u,
                          Scratch<T>& scratch, Nodal<T>& f) {
    if (layout.has_mass)
      add_product<true>(table, data, u, scratch, f);
    else
      add_product<false>(table, data, u, scratch, f);
  }

  template <class T, class Kept>
  static void add_diagonal(const ShapeTable<Element>& table, const Layout& layout, const Kept* data,
                           Nodal<T>& diagonal) {
    for (std::size_t q = 0; q < table.size(); ++q, data += layout.point_size())
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t d = 0; d < D; ++d)
            for (std::size_t e = 0; e < D; ++e)
              diagonal[a][i] +=
                  (table.gradient[q][a][d] * table.gradient[q][a][e]) * widen<T>(data[place(i * D + d, i * D + e)]);
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

  template <bool HasMass, class T, class Kept>
  static void add_product(const ShapeTable<Element>& table, const Kept* data, const Nodal<T>& u, Scratch<T>& scratch,
                          Nodal<T>& f) {
    Small<T, D>* gradients = scratch.gradients.data();
    std::array<T, D>* values = HasMass ? scratch.values.data() : nullptr;
    PointGradients<Element>::template evaluate<HasMass>(table, u, gradients, values);
    if constexpr (HasMass) scratch.complete_values();
    constexpr std::size_t point_size = moduli_size + (HasMass ? 1 : 0);
    for (std::size_t q = 0; q < table.size(); ++q) {
      if constexpr (D == 3) prefetch(data + table.size() * point_size, point_size);
      multiply(data, gradients[q]);
      data += moduli_size;
      if constexpr (HasMass) {
        const T mass = widen<T>(*data++);
        for (T& v : values[q]) v *= mass;
      }
    }
    PointGradients<Element>::template integrate<HasMass>(table, gradients, values, f);
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
};

}  // namespace ixos

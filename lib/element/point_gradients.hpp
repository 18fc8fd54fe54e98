/// From nodal values to gradients and values at an element's quadrature points, and back.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "element/simplex_gradients.hpp"
#include "element/tensor_gradients.hpp"
#include "fem/cells/tetrahedra.hpp"
#include "fem/cells/triangles.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"
#include "fem/shape_table.hpp"

namespace ixos {

/// du_i/dxi_d = sum_a u_ai dN_a/dxi_d at every point of the table, and its transpose f_ai += sum_q t_q,id dN_a/dxi_d;
/// with WithValues also u_i = sum_a u_ai N_a and its transpose. Nodal arrays are [node][component], gradients
/// [point][component][reference direction], values [point][component].
template <class Element>
struct TabulatedGradients {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;

  template <bool WithValues, class T>
  static void evaluate(const ShapeTable<Element>& table, const Small<T, N, D>& u, Small<T, D>* gradients,
                       std::array<T, D>* values) {
    for (std::size_t q = 0; q < table.size(); ++q) {
      gradients[q] = {};
      if constexpr (WithValues) values[q] = {};
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          for (std::size_t d = 0; d < D; ++d) gradients[q][i][d] += u[a][i] * table.gradient[q][a][d];
          if constexpr (WithValues) values[q][i] += u[a][i] * table.value[q][a];
        }
    }
  }

  template <bool WithValues, class T>
  static void integrate(const ShapeTable<Element>& table, const Small<T, D>* stresses, const std::array<T, D>* values,
                        Small<T, N, D>& f) {
    for (std::size_t q = 0; q < table.size(); ++q)
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          for (std::size_t d = 0; d < D; ++d) f[a][i] += stresses[q][i][d] * table.gradient[q][a][d];
          if constexpr (WithValues) f[a][i] += values[q][i] * table.value[q][a];
        }
  }
};

/// Scratch arrays of gradients and values, for as many points as a table has.
template <std::size_t D, class T>
struct PointScratch {
  explicit PointScratch(std::size_t points) : gradients(points), values(points) {}

  /// In single precision nodal values are differences from those of a node, `origin` (see
  /// ElementBatches::gather_differences()): adds them to the values at the points.
  void complete_values() {
    if constexpr (std::is_same_v<T, NarrowPack>)
      for (auto& value : values)
        for (std::size_t i = 0; i < D; ++i) value[i] += origin[i];
  }

  std::vector<Small<T, D>> gradients;
  std::vector<std::array<T, D>> values;
  std::array<T, D> origin{};
};

/// TabulatedGradients, or a faster specialisation if the element has one.
template <class Element>
struct PointGradients : TabulatedGradients<Element> {};

/// Quadratic elements: TensorGradients if they serve the table, else TabulatedGradients.
template <class Element>
struct QuadraticPointGradients {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;

  template <bool WithValues, class T>
  static void evaluate(const ShapeTable<Element>& table, const Small<T, N, D>& u, Small<T, D>* gradients,
                       std::array<T, D>* values) {
    if (TensorGradients<Element>::serves(table))
      TensorGradients<Element>::template evaluate<WithValues>(u, gradients, values);
    else
      TabulatedGradients<Element>::template evaluate<WithValues>(table, u, gradients, values);
  }

  template <bool WithValues, class T>
  static void integrate(const ShapeTable<Element>& table, const Small<T, D>* stresses, const std::array<T, D>* values,
                        Small<T, N, D>& f) {
    if (TensorGradients<Element>::serves(table))
      TensorGradients<Element>::template integrate<WithValues>(stresses, values, f);
    else
      TabulatedGradients<Element>::template integrate<WithValues>(table, stresses, values, f);
  }
};
template <>
struct PointGradients<Quad9> : QuadraticPointGradients<Quad9> {};
template <>
struct PointGradients<Hex27> : QuadraticPointGradients<Hex27> {};

/// Quadratic triangles and tetrahedra: QuadraticSimplexGradients if they serve the table and no values are asked for.
template <class Element>
struct SimplexPointGradients {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  using Quadratic = QuadraticSimplexGradients<Element>;

  template <bool WithValues, class T>
  static void evaluate(const ShapeTable<Element>& table, const Small<T, N, D>& u, Small<T, D>* gradients,
                       std::array<T, D>* values) {
    if constexpr (!WithValues)
      if (const typename Quadratic::Points points(table); points.serves)
        return Quadratic::evaluate(points, u, gradients);
    TabulatedGradients<Element>::template evaluate<WithValues>(table, u, gradients, values);
  }

  template <bool WithValues, class T>
  static void integrate(const ShapeTable<Element>& table, const Small<T, D>* stresses, const std::array<T, D>* values,
                        Small<T, N, D>& f) {
    if constexpr (!WithValues)
      if (const typename Quadratic::Points points(table); points.serves)
        return Quadratic::integrate(points, stresses, f);
    TabulatedGradients<Element>::template integrate<WithValues>(table, stresses, values, f);
  }
};
template <>
struct PointGradients<Tri6> : SimplexPointGradients<Tri6> {};
template <>
struct PointGradients<Tet10> : SimplexPointGradients<Tet10> {};

/// The trilinear hexahedron on 2 x 2 x 2 points by sum factorisation: 24 additions turn nodal values into coefficients
/// of 1, xi, eta, zeta, xi eta, ..., and each derivative is bilinear in the two other directions. This takes a third of
/// the operations of the product with the table.
template <>
struct PointGradients<Hex8> : TabulatedGradients<Hex8> {
  using Tabulated = TabulatedGradients<Hex8>;
  static constexpr std::size_t D = 3;
  static constexpr std::size_t N = 8;

  template <bool WithValues, class T>
  static void evaluate(const ShapeTable<Hex8>& table, const Small<T, N, D>& u, Small<T, D>* gradients,
                       std::array<T, D>* values) {
    if (!table.two_points) return Tabulated::evaluate<WithValues>(table, u, gradients, values);
    for (std::size_t i = 0; i < D; ++i) {
      const Coefficients<T> c = coefficients(u, i);
      spread<0>(c.x, c.xy, c.xz, c.xyz, i, gradients);
      spread<1>(c.y, c.xy, c.yz, c.xyz, i, gradients);
      spread<2>(c.z, c.xz, c.yz, c.xyz, i, gradients);
      if constexpr (WithValues) spread_values(c, i, values);
    }
  }

  template <bool WithValues, class T>
  static void integrate(const ShapeTable<Hex8>& table, const Small<T, D>* stresses, const std::array<T, D>* values,
                        Small<T, N, D>& f) {
    if (!table.two_points) return Tabulated::integrate<WithValues>(table, stresses, values, f);
    for (std::size_t i = 0; i < D; ++i) {
      Coefficients<T> c{};
      if constexpr (WithValues) collect_values(values, i, c);
      collect<0>(stresses, i, c.x, c.xy, c.xz, c.xyz);
      collect<1>(stresses, i, c.y, c.xy, c.yz, c.xyz);
      collect<2>(stresses, i, c.z, c.xz, c.yz, c.xyz);
      add_nodal(c, i, f);
    }
  }

 private:
  static constexpr double g = 0.57735026918962576451;  ///< the Gauss points are +-g

  /// The coefficients of u = mean/8 + (x xi + y eta + z zeta)/8 + (xy xi eta + ...)/8. Those of products already carry
  /// the factor g or g^2, and all are divided by 8, so that signs in place of coordinates give values at the Gauss
  /// points.
  template <class T>
  struct Coefficients {
    T x, y, z, xy, xz, yz, xyz, mean;
  };

  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Small<T, N, D>& u, std::size_t i) {
    const T s0 = u[0][i] + u[1][i], d0 = u[1][i] - u[0][i], s1 = u[3][i] + u[2][i], d1 = u[2][i] - u[3][i];
    const T s2 = u[4][i] + u[5][i], d2 = u[5][i] - u[4][i], s3 = u[7][i] + u[6][i], d3 = u[6][i] - u[7][i];
    const T bottom = s0 + s1, bottom_y = s1 - s0, bottom_x = d0 + d1, bottom_xy = d1 - d0;
    const T top = s2 + s3, top_y = s3 - s2, top_x = d2 + d3, top_xy = d3 - d2;
    return {0.125 * (bottom_x + top_x),
            0.125 * (bottom_y + top_y),
            0.125 * (top - bottom),
            (0.125 * g) * (bottom_xy + top_xy),
            (0.125 * g) * (top_x - bottom_x),
            (0.125 * g) * (top_y - bottom_y),
            (0.125 * g * g) * (top_xy - bottom_xy),
            0.125 * (bottom + top)};
  }

  /// Applies the transpose of coefficients().
  template <class T>
  [[gnu::always_inline]] static void add_nodal(const Coefficients<T>& c, std::size_t i, Small<T, N, D>& f) {
    const T x = 0.125 * c.x, y = 0.125 * c.y, z = 0.125 * c.z, mean = 0.125 * c.mean;
    const T xy = (0.125 * g) * c.xy, xz = (0.125 * g) * c.xz, yz = (0.125 * g) * c.yz, xyz = (0.125 * g * g) * c.xyz;
    const T bottom_x = x - xz, top_x = x + xz, bottom_y = y - yz, top_y = y + yz, bottom_xy = xy - xyz;
    const T top_xy = xy + xyz;
    const T bottom = mean - z, top = mean + z;
    const T s0 = bottom - bottom_y, s1 = bottom + bottom_y, d0 = bottom_x - bottom_xy, d1 = bottom_x + bottom_xy;
    const T s2 = top - top_y, s3 = top + top_y, d2 = top_x - top_xy, d3 = top_x + top_xy;
    f[0][i] += s0 - d0;
    f[1][i] += s0 + d0;
    f[2][i] += s1 + d1;
    f[3][i] += s1 - d1;
    f[4][i] += s2 - d2;
    f[5][i] += s2 + d2;
    f[6][i] += s3 + d3;
    f[7][i] += s3 - d3;
  }

  /// Computes mean + g (x s + y t + z r + xy s t + ... + xyz s t r) at the points' signs s, t, r: each pass takes one
  /// direction.
  template <class T>
  [[gnu::always_inline]] static void spread_values(const Coefficients<T>& c, std::size_t i, std::array<T, D>* values) {
    T v[8] = {c.mean, g * c.x, g * c.y, g * c.xy, g * c.z, g * c.xz, g * c.yz, g * c.xyz};
    add_and_subtract(v);
    for (std::size_t q = 0; q < 8; ++q) values[q][i] = v[q];
  }

  template <class T>
  [[gnu::always_inline]] static void collect_values(const std::array<T, D>* values, std::size_t i, Coefficients<T>& c) {
    T v[8];
    for (std::size_t q = 0; q < 8; ++q) v[q] = values[q][i];
    add_and_subtract(v);  // the transpose, but that sums and differences have changed places, and the latter their sign
    c = {-g * v[6], -g * v[5], -g * v[3], g * v[4], g * v[2], g * v[1], -g * v[0], v[7]};
  }

  /// Replaces v_k, v_k+n by v_k - v_k+n, v_k + v_k+n, for n = 1, 2, 4 in turn.
  template <class T>
  [[gnu::always_inline]] static void add_and_subtract(T (&v)[8]) {
    for (std::size_t n = 1; n < 8; n *= 2)
      for (std::size_t k = 0; k < 8; ++k)
        if ((k & n) == 0) {
          const T low = v[k], high = v[k + n];
          v[k] = low - high;
          v[k + n] = low + high;
        }
  }

  /// Returns the number of the point whose first, second coordinates beside direction `Along` have these signs (0 or
  /// 1).
  template <std::size_t Along>
  static constexpr std::size_t point(std::size_t along, std::size_t first, std::size_t second) {
    if (Along == 0) return along + 2 * first + 4 * second;
    if (Along == 1) return first + 2 * along + 4 * second;
    return first + 2 * second + 4 * along;
  }

  /// Computes c + a s + b t + ab s t at the signs s, t of the two other coordinates, for both points along the
  /// direction.
  template <std::size_t Along, class T>
  [[gnu::always_inline]] static void spread(const T& c, const T& a, const T& b, const T& ab, std::size_t i,
                                            Small<T, D>* gradients) {
    const T low = c - b, high = c + b, low_slope = a - ab, high_slope = a + ab;
    const T values[2][2] = {{low - low_slope, low + low_slope}, {high - high_slope, high + high_slope}};
    for (std::size_t second = 0; second < 2; ++second)
      for (std::size_t first = 0; first < 2; ++first)
        for (std::size_t along = 0; along < 2; ++along)
          gradients[point<Along>(along, first, second)][i][Along] = values[second][first];
  }

  template <std::size_t Along, class T>
  [[gnu::always_inline]] static void collect(const Small<T, D>* stresses, std::size_t i, T& c, T& a, T& b, T& ab) {
    T values[2][2];
    for (std::size_t second = 0; second < 2; ++second)
      for (std::size_t first = 0; first < 2; ++first)
        values[second][first] =
            stresses[point<Along>(0, first, second)][i][Along] + stresses[point<Along>(1, first, second)][i][Along];
    const T low = values[0][0] + values[0][1], low_slope = values[0][1] - values[0][0];
    const T high = values[1][0] + values[1][1], high_slope = values[1][1] - values[1][0];
    c += low + high;
    b += high - low;
    a += low_slope + high_slope;
    ab += high_slope - low_slope;
  }
};

}  // namespace ixos

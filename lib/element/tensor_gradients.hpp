/// Sum factorisation for quadratic quadrilaterals and hexahedra.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "fem/shape_table.hpp"
#include "fem/ties.hpp"

namespace ixos {

/// A polynomial of degree 2 along a line, by its values at -1, 0, 1 or at the Gauss points -g, 0, g. Sums and
/// differences of the two outer values halve the multiplications.
struct QuadraticLine {
  static constexpr double g = 0.77459666924148337704;

  /// Replaces the values at -1, 0, 1 by those at -g, 0, g. That at 0 stays.
  template <class T>
  [[gnu::always_inline]] static void to_points(T& left, T& middle, T& right) {
    const T even = 0.3 * (left + right) + 0.4 * middle, odd = (0.5 * g) * (right - left);
    left = even - odd;
    right = even + odd;
  }

  /// Applies the transpose of to_points().
  template <class T>
  [[gnu::always_inline]] static void to_nodes(T& left, T& middle, T& right) {
    const T sum = left + right, even = 0.3 * sum, odd = (0.5 * g) * (right - left);
    middle += 0.4 * sum;
    left = even - odd;
    right = even + odd;
  }

  /// Computes the slopes at -g, 0, g from the values there.
  template <class T>
  [[gnu::always_inline]] static std::array<T, 3> slopes(const T& left, const T& middle, const T& right) {
    const T mean = (0.5 / g) * (right - left), change = (1 / g) * ((left + right) - 2.0 * middle);
    return {mean - change, mean, mean + change};
  }

  /// Adds the transpose of slopes().
  template <class T>
  [[gnu::always_inline]] static void add_from_slopes(const T& first, const T& second, const T& third, T& left,
                                                     T& middle, T& right) {
    const T mean = (0.5 / g) * ((first + third) + second), change = (1 / g) * (third - first);
    left += change - mean;
    middle -= 2.0 * change;
    right += change + mean;
  }
};

/// Computes what TabulatedGradients computes, for products of LagrangeEdge<2> on three points along each direction. It
/// first interpolates the nodal values at the points, one direction after the other. Three points along a line
/// determine a polynomial of degree 2. The derivatives therefore follow from the values along each line (Kronbichler
/// and Kormann 2019, ACM Trans. Math. Softw. 45, 29). In three dimensions this takes a seventh of the operations.
template <class Element>
struct TensorGradients {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;

  /// Returns whether the table has three points along each direction, and no tied edge.
  static bool serves(const ShapeTable<Element>& table) {
    if (table.size() != N) return false;
    for (const double coordinate : table.point[0])
      if (std::abs(coordinate + QuadraticLine::g) > 1e-12) return false;
    if constexpr (HasInnerNodes<Element>::value)
      for (const InnerNode& inner : Element::inner_nodes())
        if (table.value[0][inner.node] == 0) return false;
    return true;
  }

  template <bool WithValues, class T>
  static void evaluate(const Small<T, N, D>& u, Small<T, D>* gradients, std::array<T, D>* values) {
    for (std::size_t i = 0; i < D; ++i) {
      std::array<T, N> v;
      for_each_line<0>([&](auto line) {
        v[line.first] = u[nodes[line.first]][i];
        v[line.second] = u[nodes[line.second]][i];
        v[line.third] = u[nodes[line.third]][i];
        QuadraticLine::to_points(v[line.first], v[line.second], v[line.third]);
      });
      for_each_other_direction([&](auto direction) {
        for_each_line<direction>(
            [&](auto line) { QuadraticLine::to_points(v[line.first], v[line.second], v[line.third]); });
      });
      if constexpr (WithValues)
        for (std::size_t q = 0; q < N; ++q) values[q][i] = v[q];
      spread<0>(v, i, gradients);
      for_each_other_direction([&](auto direction) { spread<direction>(v, i, gradients); });
    }
  }

  template <bool WithValues, class T>
  static void integrate(const Small<T, D>* stresses, const std::array<T, D>* values, Small<T, N, D>& f) {
    for (std::size_t i = 0; i < D; ++i) {
      std::array<T, N> v;
      for (std::size_t q = 0; q < N; ++q) v[q] = WithValues ? values[q][i] : T(0);
      collect<0>(stresses, i, v);
      for_each_other_direction([&](auto direction) { collect<direction>(stresses, i, v); });
      for_each_other_direction([&](auto direction) {
        for_each_line<direction>(
            [&](auto line) { QuadraticLine::to_nodes(v[line.first], v[line.second], v[line.third]); });
      });
      for_each_line<0>([&](auto line) {
        QuadraticLine::to_nodes(v[line.first], v[line.second], v[line.third]);
        f[nodes[line.first]][i] += v[line.first];
        f[nodes[line.second]][i] += v[line.second];
        f[nodes[line.third]][i] += v[line.third];
      });
    }
  }

 private:
  /// The three places of a line in an array of N, the first direction fastest. Constants, so that all loops unroll.
  template <std::size_t Along, std::size_t Number>
  struct Line {
    static constexpr std::size_t step = Along == 0 ? 1 : Along == 1 ? 3 : 9;
    static constexpr std::size_t first = Number / step * 3 * step + Number % step;
    static constexpr std::size_t second = first + step;
    static constexpr std::size_t third = second + step;
  };

  /// Returns the nodes in the order of the places.
  static constexpr std::array<std::size_t, N> find_nodes() {
    std::array<std::size_t, N> result{};
    for (std::size_t a = 0; a < N; ++a) {
      std::size_t place = 0;
      for (std::size_t d = D; d-- > 0;) {
        const std::size_t factor = Element::factors(a)[d];
        place = 3 * place + (factor == 0 ? 0 : factor == 1 ? 2 : 1);
      }
      result[place] = a;
    }
    return result;
  }
  static constexpr std::array<std::size_t, N> nodes = find_nodes();

  template <std::size_t Along, class Visit, std::size_t... Numbers>
  [[gnu::always_inline]] static void visit_lines(const Visit& visit, std::index_sequence<Numbers...> /*numbers*/) {
    (visit(Line<Along, Numbers>{}), ...);
  }
  template <std::size_t Along, class Visit>
  [[gnu::always_inline]] static void for_each_line(const Visit& visit) {
    visit_lines<Along>(visit, std::make_index_sequence<N / 3>{});
  }
  template <class Visit>
  [[gnu::always_inline]] static void for_each_other_direction(const Visit& visit) {
    visit(std::integral_constant<std::size_t, 1>{});
    if constexpr (D == 3) visit(std::integral_constant<std::size_t, 2>{});
  }

  template <std::size_t Along, class T>
  [[gnu::always_inline]] static void spread(const std::array<T, N>& v, std::size_t i, Small<T, D>* gradients) {
    for_each_line<Along>([&](auto line) {
      const std::array<T, 3> slopes = QuadraticLine::slopes(v[line.first], v[line.second], v[line.third]);
      gradients[line.first][i][Along] = slopes[0];
      gradients[line.second][i][Along] = slopes[1];
      gradients[line.third][i][Along] = slopes[2];
    });
  }

  template <std::size_t Along, class T>
  [[gnu::always_inline]] static void collect(const Small<T, D>* stresses, std::size_t i, std::array<T, N>& v) {
    for_each_line<Along>([&](auto line) {
      QuadraticLine::add_from_slopes(stresses[line.first][i][Along], stresses[line.second][i][Along],
                                     stresses[line.third][i][Along], v[line.first], v[line.second], v[line.third]);
    });
  }
};

}  // namespace ixos

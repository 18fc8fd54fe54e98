/// Reference elements: shape functions and the quadrature that goes with them.
///
/// An element type offers `dimension`, `nodes`, `points` and table(), the values at its quadrature points. Node order
/// is that of Exodus; the reference domain is [-1, 1]^dimension.
#pragma once
#include <array>

#include "fem/quadrature.hpp"

namespace ixos {

template <int Dim, int Nodes, int Points>
struct ShapeTable {
  std::array<double, Points> weight;                                        ///< quadrature weights
  std::array<std::array<double, Nodes>, Points> value;                      ///< N_a(xi_q)
  std::array<std::array<std::array<double, Dim>, Nodes>, Points> gradient;  ///< dN_a/dxi_d (xi_q)
};

/// Corners of [-1, 1]^Dim in Exodus order; also the signs of the multilinear shape functions.
template <int Dim>
constexpr std::array<std::array<double, Dim>, (1 << Dim)> corners() {
  if constexpr (Dim == 1)
    return {{{-1}, {1}}};
  else if constexpr (Dim == 2)
    return {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  else
    return {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
}

/// Multilinear shape functions prod_d (1 + s_d xi_d)/2 at one reference point.
template <int Dim>
struct Multilinear {
  static constexpr int dimension = Dim;
  static constexpr int nodes = 1 << Dim;

  static void evaluate(const std::array<double, Dim>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, Dim>, nodes>& gradient) {
    constexpr auto corner = corners<Dim>();
    for (std::size_t a = 0; a < nodes; ++a) {
      value[a] = 1;
      for (std::size_t d = 0; d < Dim; ++d) value[a] *= (1 + corner[a][d] * xi[d]) / 2;
      for (std::size_t d = 0; d < Dim; ++d) {
        gradient[a][d] = corner[a][d] / 2;
        for (std::size_t e = 0; e < Dim; ++e)
          if (e != d) gradient[a][d] *= (1 + corner[a][e] * xi[e]) / 2;
      }
    }
  }

  /// The table at the tensor product of an n-point Gauss rule; Points must be n^Dim.
  template <int Points>
  static ShapeTable<Dim, nodes, Points> tabulate(int n) {
    const Quadrature rule = gauss_legendre(n);
    ShapeTable<Dim, nodes, Points> table{};
    for (std::size_t q = 0; q < Points; ++q) {
      std::array<double, Dim> xi;
      table.weight[q] = 1;
      std::size_t rest = q;
      for (std::size_t d = 0; d < Dim; ++d) {
        const std::size_t i = rest % static_cast<std::size_t>(n);
        rest /= static_cast<std::size_t>(n);
        xi[d] = rule.points[i];
        table.weight[q] *= rule.weights[i];
      }
      evaluate(xi, table.value[q], table.gradient[q]);
    }
    return table;
  }
};

/// Four-noded bilinear quadrilateral, 2 x 2 Gauss points.
struct Quad4 : Multilinear<2> {
  static constexpr int points = 4;
  static const ShapeTable<2, 4, 4>& table() {
    static const auto values = tabulate<4>(2);
    return values;
  }
};

/// Eight-noded trilinear hexahedron, 2 x 2 x 2 Gauss points.
struct Hex8 : Multilinear<3> {
  static constexpr int points = 8;
  static const ShapeTable<3, 8, 8>& table() {
    static const auto values = tabulate<8>(2);
    return values;
  }
};

}  // namespace ixos

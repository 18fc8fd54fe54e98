/// Quadrilaterals and hexahedra of second order in each direction.
#pragma once
#include <array>
#include <cstddef>

#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"

namespace ixos {

/// Node order of Exodus QUAD9: the corners, the middles of the edges 0-1, 1-2, 2-3 and 3-0, the centre.
using Quad9 = LagrangeFace<2>;

/// The product of three LagrangeEdge<2>. Node order of Exodus HEX27: the corners; the middles of the four edges at
/// zeta = -1, of the four along zeta, of the four at zeta = 1; the centre; the centres of the faces at zeta = -1 and 1,
/// xi = -1 and 1, eta = -1 and 1.
struct Hex27 {
  using Edge = LagrangeEdge<2>;
  static constexpr int dimension = 3;
  static constexpr int nodes = 27;
  static constexpr std::array<int, 3> default_points{3, 3, 3};

  /// Returns the nodes of the three edges, along xi, eta and zeta, whose functions' product is node `a`'s: 0 and 1 are
  /// the ends of an edge, 2 is its middle.
  static constexpr std::array<std::size_t, 3> factors(std::size_t a) {
    constexpr std::array<std::array<std::size_t, 3>, 27> table{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {2, 0, 0},
         {1, 2, 0}, {2, 1, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {2, 0, 1}, {1, 2, 1},
         {2, 1, 1}, {0, 2, 1}, {2, 2, 2}, {2, 2, 0}, {2, 2, 1}, {0, 2, 2}, {1, 2, 2}, {2, 0, 2}, {2, 1, 2}}};
    return table[a];
  }

  static void evaluate(const std::array<double, 3>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 3>, nodes>& gradient) {
    std::array<std::array<double, 3>, 3> on_edge;
    std::array<std::array<std::array<double, 1>, 3>, 3> slope;
    for (std::size_t d = 0; d < 3; ++d) Edge::evaluate({xi[d]}, on_edge[d], slope[d]);
    for (std::size_t a = 0; a < nodes; ++a) {
      const auto [i, j, k] = factors(a);
      value[a] = on_edge[0][i] * on_edge[1][j] * on_edge[2][k];
      gradient[a] = {slope[0][i][0] * on_edge[1][j] * on_edge[2][k], on_edge[0][i] * slope[1][j][0] * on_edge[2][k],
                     on_edge[0][i] * on_edge[1][j] * slope[2][k][0]};
    }
  }
};

}  // namespace ixos

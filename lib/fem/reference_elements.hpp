/// Reference elements: shape functions on [-1, 1]^dimension.
///
/// An element type offers `dimension`, `nodes`, `default_points` (Gauss points along each direction) and
/// evaluate(xi, value, gradient). Node order is that of Exodus.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

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

/// Line, bilinear quadrilateral, trilinear hexahedron: shape functions prod_d (1 + s_d xi_d)/2.
template <int Dim>
struct Multilinear {
  static constexpr int dimension = Dim;
  static constexpr int nodes = 1 << Dim;
  static constexpr std::array<int, Dim> default_points = [] {
    std::array<int, Dim> points{};
    for (int& count : points) count = 2;
    return points;
  }();

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
};

using Line2 = Multilinear<1>;
using Quad4 = Multilinear<2>;
using Hex8 = Multilinear<3>;

}  // namespace ixos

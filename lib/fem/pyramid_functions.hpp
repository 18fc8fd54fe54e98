/// Rational functions on the pyramid |xi|, |eta| <= 1 - zeta.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

/// 1, x, y, z, x^2, xy, y^2, xz, yz, z^2; r = xy/(1 - z), rx, ry, r^2; the bubbles of the four triangles,
/// z ((1 - z)^2 - b^2)(1 - z +- a)/(1 - z) with a = y, -x, -y, x and b the other one; that of the cell,
/// z ((1 - z)^2 - x^2)((1 - z)^2 - y^2)/(1 - z)^2. The first 14 and all 19 are the spaces of Pyr14 and Pyr19.
struct PyramidFunctions {
  explicit PyramidFunctions(const std::array<double, 3>& xi);
  std::array<double, 19> value;
  std::array<std::array<double, 3>, 19> gradient;
};

/// Returns, by node and function, the coefficients of the shape functions whose nodes these are: N_a = sum_k c_ak f_k
/// is 1 at node a and 0 at the others. `Count`: 14 or 19.
template <std::size_t Count>
std::array<std::array<double, Count>, Count> pyramid_coefficients(
    const std::array<std::array<double, 3>, Count>& nodes);

}  // namespace ixos

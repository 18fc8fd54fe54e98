/// The corners of quadrilaterals and hexahedra by their places.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

/// Returns the corner of a linear cell, in Exodus order, as the bits of its place: bit k tells the end along the cell's
/// axis k. Also returns the corner of such bits, for the permutation is its own inverse.
constexpr int corner_bits(int corner) {
  constexpr std::array<int, 8> permutation{0, 1, 3, 2, 4, 5, 7, 6};
  return permutation[static_cast<std::size_t>(corner)];
}

}  // namespace ixos

/// Moduli of bodies of revolution.
#pragma once
#include <array>
#include <cstddef>

#include "base/small_matrix.hpp"

namespace ixos {

/// Components of a displacement gradient that are not zero if a body of revolution deforms without torsion: radius and
/// axis, in the order 00, 01, 10, 11, and the hoop, 22.
constexpr std::size_t meridian_size = 5;
constexpr std::array<std::array<std::size_t, 2>, meridian_size> meridian_components{
    {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 2}}};

/// Copies the moduli between those components, A[iJ][kL] with row 3 i + J.
template <class T>
void copy_meridian(const Small<T, 9>& moduli, Small<T, meridian_size>& result) {
  for (std::size_t r = 0; r < meridian_size; ++r)
    for (std::size_t c = 0; c < meridian_size; ++c)
      result[r][c] = moduli[3 * meridian_components[r][0] + meridian_components[r][1]]
                           [3 * meridian_components[c][0] + meridian_components[c][1]];
}

/// Copies moduli between all components to those that a space has.
template <class T, std::size_t size>
void copy_moduli(const Small<T, size>& moduli, Small<T, size>& result) {
  result = moduli;
}
template <class T>
void copy_moduli(const Small<T, 9>& moduli, Small<T, meridian_size>& result) {
  copy_meridian(moduli, result);
}

}  // namespace ixos

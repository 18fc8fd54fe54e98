/// Elements of the meridian plane of a body of revolution. x is the radius R, y runs along the axis.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/cell_traits.hpp"

namespace ixos {

/// A plane element that stands for the ring that it sweeps around the y axis. Shape functions and nodes are those of
/// the plane element.
template <class Element>
struct Revolved : Element {
  static_assert(Element::dimension == 2, "a meridian plane has two dimensions");
};

template <class Element>
struct CellTraits<Revolved<Element>> : CellTraits<Element> {};

template <class Element>
struct IsRevolved : std::false_type {};
template <class Element>
struct IsRevolved<Revolved<Element>> : std::true_type {};

/// Returns 2 pi R, the length of the circle that a point of the meridian plane sweeps [L0].
template <class T>
T circumference(const T& radius) {
  return 6.283185307179586476925 * radius;
}

/// Returns 2 pi R at a point with these values of the shape functions. `x`: nodal coordinates [L0].
template <class T, std::size_t N>
T circumference(const Small<T, N, 2>& x, const std::array<double, N>& value) {
  T radius = value[0] * x[0][0];
  for (std::size_t a = 1; a < N; ++a) radius += value[a] * x[a][0];
  return circumference(radius);
}

/// Does the same for a cell or side of a mesh. `coordinates`: nodes x 2; `nodes` and `scales`: the element's.
template <std::size_t N>
double circumference(const std::vector<double>& coordinates, const int* nodes, const std::array<double, N>& scales,
                     const std::array<double, N>& value) {
  double radius = 0;
  for (std::size_t a = 0; a < N; ++a)
    radius += scales[a] * value[a] * coordinates[2 * static_cast<std::size_t>(nodes[a])];
  return circumference(radius);
}

}  // namespace ixos

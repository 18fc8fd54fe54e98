/// Gauss points on the sides of a surface.
#pragma once
#include <vector>

#include "geometry/surface_patch.hpp"

namespace ixos {

/// The most Gauss points per direction on a side, those of gauss_legendre().
inline constexpr int most_points_on_a_side = 64;

/// Returns the number of Gauss points per direction on a side of a pair: `asked`, or the default if that is 0.
constexpr int points_on_a_side(int asked) { return asked > 0 ? asked : 5; }

/// Returns that on a patch: half as many, rounded up, if the surface is cut, see SplitSides.
constexpr int points_on_a_patch(int asked, bool is_split) {
  return is_split ? (points_on_a_side(asked) + 1) / 2 : points_on_a_side(asked);
}

template <std::size_t D>
struct PatchPoint {
  PatchParameters<D> xi;
  double weight;  ///< of an integral over the parameters
};

/// Returns the points with `along` of them per direction, those of the first parameter fastest. Throws InputError
/// unless 1 <= along <= 64.
template <std::size_t D>
std::vector<PatchPoint<D>> patch_points(int along);

}  // namespace ixos

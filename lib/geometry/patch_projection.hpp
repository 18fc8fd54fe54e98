/// The point of a patch that is nearest to a place.
#pragma once
#include "geometry/surface_patch.hpp"

namespace ixos {

/// The nearest point of one patch.
template <std::size_t D>
struct PatchProjection {
  PatchParameters<D> xi{};
  typename PlacedPatch<D>::Frame frame{};  ///< at xi
  double distance = 0;                     ///< [L0], not negative
  /// By parameter: the nearest point is at a kink or a free rim, so that the parameter stays when the place moves a
  /// little. False inside, and at a side with a smooth continuation.
  std::array<bool, D - 1> fixed{};
};

/// Returns the point of the patch that is nearest to the place. `smooth`: see SurfacePatch. In space it finds the
/// minimum of the squared distance by Newton's method, from `start` or, if the degree is 4, from the nearest of a grid
/// of points: patches that bend by less than about 60 degrees have no other minimum near that from PatchBound::start().
/// In the plane it does so where the squared distance is convex along the whole curve, and looks at all minima
/// elsewhere.
template <std::size_t D>
PatchProjection<D> nearest_point(const PlacedPatch<D>& patch, const std::array<bool, 2 * (D - 1)>& smooth,
                                 const Vec<D>& place, const PatchParameters<D>& start);

extern template PatchProjection<2> nearest_point(const PlacedPatch<2>&, const std::array<bool, 2>&, const Vec<2>&,
                                                 const PatchParameters<2>&);
extern template PatchProjection<3> nearest_point(const PlacedPatch<3>&, const std::array<bool, 4>&, const Vec<3>&,
                                                 const PatchParameters<3>&);

}  // namespace ixos

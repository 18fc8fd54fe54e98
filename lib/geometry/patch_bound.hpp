/// Bounds on the distance between a place and a patch.
#pragma once
#include "geometry/surface_patch.hpp"

namespace ixos {

/// Bounds that need no search for the nearest point. They use a box around the patch, with its axes along the tangent
/// plane and the normal at its middle, the patch's hull, and the tangent plane.
template <std::size_t D>
class PatchBound {
 public:
  explicit PatchBound(const PlacedPatch<D>& patch);

  /// Returns a lower bound on the distance of the place from the patch, smaller than that from the box by more than
  /// rounding [L0].
  double distance(const Vec<D>& place) const;
  /// Returns the parameters of the nearest point of the tangent plane at the middle, or the nearest bounds.
  PatchParameters<D> start(const Vec<D>& place) const;
  /// Returns a lower bound on the distance of the place, too: from the plane that touches the hull and is normal to the
  /// way from `point` to the place. It is sharp if `point` is near the nearest point of the patch, at a side beyond
  /// which the place lies [L0].
  double distance(const Vec<D>& place, const Vec<D>& point) const;

 private:
  std::array<Vec<D>, D> axes_;  ///< orthonormal
  Vec<D> low_, high_;           ///< along these axes [L0]
  Vec<D> middle_;
  std::array<Vec<D>, D - 1> slopes_{};  ///< of the parameters by the place, on the tangent plane; 0 if there is none
  std::size_t points_;                  ///< of the hull
  std::array<std::array<double, PlacedPatch<D>::most>, D> hull_;  ///< by component
};

extern template class PatchBound<2>;
extern template class PatchBound<3>;

}  // namespace ixos

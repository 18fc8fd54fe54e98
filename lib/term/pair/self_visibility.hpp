/// The parts of a surface that interact with each other.
#pragma once
#include <cstddef>
#include <vector>

#include "base/record.hpp"
#include "geometry/placed_surface.hpp"

namespace ixos {

/// For each patch of a surface that interacts with itself, the patches that it sees: those within range, except those
/// nearer than a distance along the surface in the undeformed body, and except those that do not face it. Two patches
/// face each other if each one's middle is on the outer side of the other one's tangent plane. The
/// exclusion by distance does not change in a run. find() decides at the start of a step which patches face each other,
/// and the step keeps that; see() takes what a state or a step has.
template <std::size_t D>
class SelfVisibility {
 public:
  /// `x`: places of the nodes in the undeformed body; `exclusion`: the distance along the surface, from middle to
  /// middle of patches that share a corner, at most 8 % longer than the straight way on a grid [L0]; `range`: of the
  /// law, finite [L0]. The patches must outlive it.
  SelfVisibility(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x, double exclusion,
                 double range);

  /// Returns the patches that each one sees at these places: within the range and `skin`, by which a gap can fall in
  /// the step. `before`: what patches saw at the last places; null if overlaps have no forces. Two patches that saw
  /// each other then, whose normals are still opposed and that no longer face each other, overlap: they go on seeing
  /// each other.
  std::vector<std::vector<int>> find(const std::vector<Vec<D>>& x, double skin,
                                     const std::vector<std::vector<int>>* before = nullptr) const;
  /// Returns the patches that a patch sees, ascending.
  const std::vector<int>& seen(std::size_t patch) const { return seen_[patch]; }
  const std::vector<std::vector<int>>& seen() const { return seen_; }
  void see(const std::vector<std::vector<int>>& seen) {
    if (seen == seen_) return;
    seen_ = seen;
    ++version_;
  }
  /// Returns a number that changes with what is seen.
  long version() const { return version_; }
  bool is_excluded(std::size_t patch, int other) const;
  /// Transfers lists of patches by patch, equal on all ranks: loading works on every partition. Throws InputError if
  /// they are not of this surface.
  static void transfer(Record& record, std::vector<std::vector<int>>& seen);

 private:
  void exclude(const std::vector<Vec<D>>& middles, double exclusion);

  const std::vector<SurfacePatch<D>>& patches_;
  double range_;
  long version_ = 0;
  std::vector<std::vector<int>> excluded_, seen_;  ///< by patch, ascending
};

extern template class SelfVisibility<2>;
extern template class SelfVisibility<3>;

}  // namespace ixos

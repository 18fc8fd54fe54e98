/// A surface, its sides as patches, at one place of its nodes: the search for nearest points.
#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/patch_bound.hpp"
#include "geometry/patch_projection.hpp"
#include "geometry/surface_patch.hpp"

namespace ixos {

/// The point of a surface that is nearest to a place.
template <std::size_t D>
struct SurfaceProjection {
  int patch = -1;  ///< -1: the surface is out of range
  PatchParameters<D> xi{};
  std::array<bool, D - 1> fixed{};                       ///< see PatchProjection
  double gap = std::numeric_limits<double>::infinity();  ///< signed least distance, negative in the body [L0]
  Vec<D> normal{};                                       ///< unit vector, the gap's gradient in the place
  typename PlacedPatch<D>::Frame frame{};                ///< of the patch at the closest point
  /// How much farther all other patches are at least; without a closest point, by how much all patches are out of range
  /// [L0].
  double clearance = 0;
};

/// Where the nearest point is likely to be. It changes the time of a search, and the result by rounding errors at most.
template <std::size_t D>
struct ProjectionGuess {
  int patch = -1;  ///< -1: unknown
  std::optional<PatchParameters<D>> xi{};
};

/// Some of the patches of a surface.
struct PatchSubset {
  std::vector<int> patches;  ///< ascending
  std::vector<int> slots;    ///< by patch of the surface: its place in `patches`, -1 if it is none of them
};

/// Patches at places of their nodes. A surface of all patches has them in a tree of their bounding boxes
/// (Boost.Geometry's R-tree, packed), so that a search visits few of them. One of some patches searches among those
/// that the caller names. The result depends on the places alone: of two patches that are equally near, it is the one
/// with the lower number. The patches must outlive it.
template <std::size_t D>
class PlacedSurface {
 public:
  /// `x`: places of the nodes, by the numbers that patches have [L0].
  PlacedSurface(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x);
  /// Places these patches only. Functions that search in the tree must not be called.
  PlacedSurface(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x,
                std::shared_ptr<const PatchSubset> subset);
  ~PlacedSurface();
  PlacedSurface(PlacedSurface&&) noexcept;
  PlacedSurface& operator=(PlacedSurface&&) = delete;
  PlacedSurface(const PlacedSurface&) = delete;
  PlacedSurface& operator=(const PlacedSurface&) = delete;

  /// Places these patches of the same surface, at other places of its nodes. It reuses the memory, and has no tree.
  void move(const std::vector<Vec<D>>& x, std::shared_ptr<const PatchSubset> subset);

  const PlacedPatch<D>& patch(int number) const { return placed_[slot(number)]; }
  /// Returns the nearest point if it is nearer than `range`; else a closest point without a patch. The closest point
  /// has no clearance. The gap is positive on the outer side. At a kink, the sum of the normals of the patches that
  /// meet there, weighted by their angles, tells the outer side (Baerentzen and Aanaes 2005); beyond a free rim the gap
  /// is positive. It searches in the tree.
  SurfaceProjection<D> nearest(const Vec<D>& place, double range = std::numeric_limits<double>::infinity(),
                               const ProjectionGuess<D>& guess = {}) const;
  /// Does the same among these patches, ascending, which must contain all that are nearer than `range`, or than the
  /// nearest one and the slack. `slack`: the greatest clearance that the closest point can have; more of it costs time.
  SurfaceProjection<D> nearest_among(const std::vector<int>& patches, const Vec<D>& place, double range,
                                     const ProjectionGuess<D>& guess = {}, double slack = 0) const;
  /// Returns the nearest point of the patch that is known to be the nearest one. `guess`: names the patch.
  SurfaceProjection<D> nearest_on(const ProjectionGuess<D>& guess, const Vec<D>& place, double range) const;
  /// Sets `result` to those of these patches that can hold the point nearest to a place in a ball, if it is nearer than
  /// `range`, and to those that are farther by no more than the slack.
  void reduce(const std::vector<int>& patches, const Vec<D>& center, double radius, double range, double slack,
              std::vector<int>& result) const;
  /// Returns at least those of all patches, searched in the tree.
  std::vector<int> reduced(const Vec<D>& center, double radius, double range, double slack) const;
  /// Returns the nearest point of these patches, ascending, if it is nearer than `range`. A side beyond which no such
  /// patch lies counts as a free rim.
  SurfaceProjection<D> nearest_of(const std::vector<int>& patches, const Vec<D>& place, double range) const;
  /// Returns the patches whose bounding boxes are nearer than `range` to the bounding box of these points, ascending.
  /// It searches in the tree.
  template <class Points>
  std::vector<int> near(const Points& points, double range) const {
    return near(Box(points), range);
  }
  /// Returns how far the nodes and the place may move along their ways, as a factor s in [0, 1], while the distance
  /// surely stays at least `least`. The later of two bounds counts for each patch: the motion of the
  /// place relative to the patch's hull is as long as the distance exceeds `least`; or the hull, seen along the normal
  /// at the closest point, comes nearer to the place than `least`. `ways`: by node, as x. `patches`: those that count.
  double free_share(const Vec<D>& place, const Vec<D>& way, const std::vector<Vec<D>>& ways, double least,
                    const std::vector<int>& patches) const;

 private:
  /// A bounding box.
  struct Box {
    Vec<D> low, high;
    template <class Points>
    explicit Box(const Points& points) : low(*points.begin()), high(*points.begin()) {
      for (const Vec<D>& p : points)
        for (std::size_t i = 0; i < D; ++i) {
          low[i] = p[i] < low[i] ? p[i] : low[i];
          high[i] = p[i] > high[i] ? p[i] : high[i];
        }
    }
  };
  struct Tree;
  /// A patch with its distance, which is less than `range`, or none; and a bound on the distance of all others.
  struct Best {
    int patch = -1;
    PatchProjection<D> projection;
    double others = std::numeric_limits<double>::infinity();
    explicit Best(double range) { projection.distance = range; }
    double clearance(double slack) const { return std::max(0.0, std::min(others - projection.distance, slack)); }
  };
  void place(const std::vector<Vec<D>>& x, const std::vector<int>& patches);
  std::size_t slot(int patch) const { return static_cast<std::size_t>(subset_ ? subset_->slots[at(patch)] : patch); }
  static std::size_t at(int number) { return static_cast<std::size_t>(number); }
  double bound(int patch, const Vec<D>& place) const { return bounds_[slot(patch)].distance(place); }
  void look(int patch, const std::array<bool, SurfacePatch<D>::sides>& smooth, const Vec<D>& place, Best& best,
            const std::optional<PatchParameters<D>>& start = std::nullopt) const;
  std::vector<int> near(const Box& box, double range) const;
  template <class Counts>
  SurfaceProjection<D> complete(const Vec<D>& place, const Best& best, const Counts& counts, double slack) const;
  bool is_outside(const Vec<D>& from_projection, const SurfaceProjection<D>& projection) const;

  const std::vector<SurfacePatch<D>>& patches_;
  std::shared_ptr<const PatchSubset> subset_;  ///< null: all patches
  std::vector<PlacedPatch<D>> placed_;         ///< in the order of the subset
  std::vector<PatchBound<D>> bounds_;
  std::unique_ptr<Tree> tree_;  ///< null for a subset
};

extern template class PlacedSurface<2>;
extern template class PlacedSurface<3>;

}  // namespace ixos

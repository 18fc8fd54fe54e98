/// A surface, its sides as patches, at one place of its nodes: the search for nearest points.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "interaction/patch_bound.hpp"
#include "interaction/patch_foot.hpp"
#include "interaction/surface_patch.hpp"

namespace ixos {

/// The point of a surface that is nearest to a place.
template <std::size_t D>
struct SurfaceFoot {
  int patch = -1;  ///< -1: the surface is out of range
  PatchParameters<D> xi{};
  std::array<bool, D - 1> fixed{};                       ///< see PatchFoot
  double gap = std::numeric_limits<double>::infinity();  ///< signed least distance, negative in the body [L0]
  Vec<D> normal{};                                       ///< unit vector, the gap's gradient in the place
  typename PlacedPatch<D>::Frame frame{};                ///< of the patch at the foot
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

  const PlacedPatch<D>& patch(int number) const { return placed_[slot(number)]; }
  /// Returns the nearest point if it is nearer than `range`; else a foot without a patch. `guess`: a patch that is
  /// likely near, or -1; it changes the time of the search only. `start`: the nearest point of a place near by, or
  /// null; it changes the result by rounding errors at most, and its patch replaces the guess, if it has one. The gap
  /// is positive on the outer side. At a kink, the sum of the normals of the patches that meet there, weighted by their
  /// angles, tells the outer side (Baerentzen and Aanaes 2005); beyond a free rim the gap is positive. It searches in
  /// the tree.
  SurfaceFoot<D> nearest(const Vec<D>& place, double range = std::numeric_limits<double>::infinity(), int guess = -1,
                         const SurfaceFoot<D>* start = nullptr) const;
  /// Does the same among these patches, ascending, which must contain all patches that are nearer than `range`.
  SurfaceFoot<D> nearest_among(const std::vector<int>& patches, const Vec<D>& place, double range, int guess = -1,
                               const SurfaceFoot<D>* start = nullptr) const;
  /// Returns those of these patches that can hold the point nearest to a place in a ball, if it is nearer than `range`.
  std::vector<int> reduced(const std::vector<int>& patches, const Vec<D>& center, double radius, double range) const;
  /// Returns the nearest point of these patches, ascending, if it is nearer than `range`. A side beyond which no such
  /// patch lies counts as a free rim.
  SurfaceFoot<D> nearest_of(const std::vector<int>& patches, const Vec<D>& place, double range) const;
  /// Returns the patches whose bounding boxes are nearer than `range` to the bounding box of these points, ascending.
  /// It searches in the tree.
  template <class Points>
  std::vector<int> near(const Points& points, double range) const {
    return near(Box(points), range);
  }
  /// Returns how far the nodes and the place may move along their ways, as a factor s in [0, 1], while the distance
  /// surely stays at least `least`. The later of two bounds counts for each patch: the motion of the
  /// place relative to the patch's hull is as long as the distance exceeds `least`; or the hull, seen along the normal
  /// at the foot, comes nearer to the place than `least`. `ways`: by node, as x. `fastest`: a bound on the ways of all
  /// points of the surface. `among`: the patches that count; null: all, searched in the tree.
  double free_share(const Vec<D>& place, const Vec<D>& way, const std::vector<Vec<D>>& ways, double fastest,
                    double least, const std::vector<int>* among = nullptr) const;

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
  /// A patch with its distance, which is less than `range`, or none.
  struct Best {
    int patch = -1;
    PatchFoot<D> foot;
    explicit Best(double range) { foot.distance = range; }
  };
  void place(const std::vector<Vec<D>>& x, const std::vector<int>& patches);
  std::size_t slot(int patch) const { return static_cast<std::size_t>(subset_ ? subset_->slots[at(patch)] : patch); }
  static std::size_t at(int number) { return static_cast<std::size_t>(number); }
  double bound(int patch, const Vec<D>& place) const { return bounds_[slot(patch)].distance(place); }
  void look(int patch, const std::array<bool, SurfacePatch<D>::sides>& smooth, const Vec<D>& place, Best& best,
            const PatchParameters<D>* start = nullptr) const;
  std::vector<int> near(const Box& box, double range) const;
  template <class Counts>
  SurfaceFoot<D> complete(const Vec<D>& place, const Best& best, const Counts& counts) const;
  bool is_outside(const Vec<D>& from_foot, const SurfaceFoot<D>& foot) const;

  const std::vector<SurfacePatch<D>>& patches_;
  std::shared_ptr<const PatchSubset> subset_;  ///< null: all patches
  std::vector<PlacedPatch<D>> placed_;         ///< in the order of the subset
  std::vector<PatchBound<D>> bounds_;
  std::unique_ptr<Tree> tree_;  ///< null for a subset
};

extern template class PlacedSurface<2>;
extern template class PlacedSurface<3>;

}  // namespace ixos

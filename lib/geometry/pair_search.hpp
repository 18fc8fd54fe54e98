/// The patches of one surface that are near those of another.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "geometry/placed_surface.hpp"
#include "geometry/surface_patches.hpp"

namespace ixos {

/// Both surfaces of a pair.
template <std::size_t D>
struct PairSurfaces {
  SurfacePatches<D> secondary, primary;
};

/// Both surfaces at one place: the nodes of each, in the order of SurfacePatches [L0].
template <std::size_t D>
struct PairPlaces {
  std::vector<Vec<D>> secondary, primary;
  bool is_finite() const;
};

/// Returns, by secondary patch, whether forces between its points and the primary surface act on nodes with a row on
/// this rank, see LocalMesh::has_row(): all of them if a primary node has one.
template <std::size_t D>
std::vector<char> acting_patches(const PairSurfaces<D>& surfaces, const LocalMesh& mesh);

/// Returns, by patch, whether one of its nodes has a row on this rank.
template <std::size_t D>
std::vector<char> patches_with_own_nodes(const SurfacePatches<D>& surface, const LocalMesh& mesh);

/// The overlaps on which a law acts that is defined at every gap: they may be deeper than its range.
template <std::size_t D>
struct PairOverlap {
  double depth = 0;  ///< of the deepest overlap that counts, see PairOptions; 0: none beyond the range [L0]
  /// Lists of patches within a range can lack the closest points of overlaps that are deeper than this [L0].
  double least = std::numeric_limits<double>::infinity();
  double clearance = 0;  ///< the greatest clearance of closest points, see SurfaceProjection [L0]
  std::vector<PatchParameters<D>> points = {};  ///< of each secondary patch: forces act there
};

/// Secondary patches, and the primary ones that their points can have closest points on. If places are no numbers,
/// these are all secondary patches, without primary ones and without `together`.
struct PairNeighbours {
  std::vector<std::size_t> secondary;           ///< ascending
  std::vector<std::vector<int>> primary;        ///< by entry of `secondary`, ascending
  std::shared_ptr<const PatchSubset> together;  ///< all of these primary ones
  /// By entry: points of the patch can be deeper in the other body than the range. Empty if none are.
  std::vector<char> deep = {};
  bool is_deep(std::size_t entry) const { return !deep.empty() && deep[entry] != 0; }
};

/// Returns the secondary patches whose bounding boxes are nearer than `range` to those of primary patches, with these.
/// It adds those whose points can overlap more deeply, with the primary ones that can have their closest points, while
/// gaps change by no more than `motion` [L0].
template <std::size_t D>
std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<D>& surfaces, const PairPlaces<D>& places,
                                                      double range, const PairOverlap<D>& overlap = {},
                                                      double motion = 0);

/// Finds neighbours and keeps them as long as they hold. Those within a range were searched within the range and a skin
/// beyond it, its reach. They hold as long as the range and the change of gaps stay within that reach. Without a range
/// they are the patches that can have closest points, and those that are farther by twice the skin and the greatest
/// clearance. They hold for places from which no gap can have changed by more than the skin. Closest points do not
/// depend on which patches are kept, as long as these contain all that can have one. Lists within a range contain the
/// closest points of overlaps, too.
template <std::size_t D>
class PairSearch {
 public:
  /// `clearance`: the greatest clearance of closest points, see SurfaceProjection [L0]. The surfaces must outlive it.
  /// `overlap`: its `least` and its clearance are not used.
  PairSearch(const PairSurfaces<D>& surfaces, double clearance, PairOverlap<D> overlap = {});

  /// Returns neighbours within the range at all of these places and on straight ways between them. If a place is no
  /// number, it returns what PairNeighbours says of such places, without a search.
  std::shared_ptr<const PairNeighbours> cover(const std::vector<const PairPlaces<D>*>& times, double range);
  /// Forgets lists that a long way has made much longer than usual.
  void begin_step() {
    if (is_wide_) last_ = nullptr;
  }
  /// Returns a bound on the change of a gap between two places. The mean motion of all nodes changes no gap.
  double motion(const PairPlaces<D>& from, const PairPlaces<D>& to) const;
  /// Returns a bound on the ways of all points of the secondary and of the primary surface, if their nodes move along
  /// these [L0].
  std::array<double, 2> fastest(const PairPlaces<D>& ways) const;
  long searches() const { return searches_; }

 private:
  const PairSurfaces<D>& surfaces_;
  double clearance_;
  PairOverlap<D> overlap_;
  double secondary_amplification_, primary_amplification_;
  std::shared_ptr<const PairNeighbours> all_, last_;
  PairPlaces<D> places_;         ///< of the last search
  double reach_ = 0, skin_ = 0;  ///< of the last search: the range and the skin, and the skin
  bool is_wide_ = false;         ///< the last search had a much wider skin than usual
  long searches_ = 0;
};

/// Returns a subset of a surface of `count` patches. `patches`: ascending.
std::shared_ptr<const PatchSubset> patch_subset(std::vector<int> patches, std::size_t count);

extern template std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<2>&, const PairPlaces<2>&,
                                                                      double, const PairOverlap<2>&, double);
extern template std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<3>&, const PairPlaces<3>&,
                                                                      double, const PairOverlap<3>&, double);
extern template struct PairPlaces<2>;
extern template struct PairPlaces<3>;
extern template class PairSearch<2>;
extern template class PairSearch<3>;

}  // namespace ixos

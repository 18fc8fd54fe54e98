/// The points of a surface with their closest points on another one, at several places of both.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "geometry/pair_search.hpp"

namespace ixos {

/// A quadrature point at one place of the surfaces. A point beyond the law's range has no closest point and no force.
template <std::size_t D>
struct PairContact {
  std::size_t patch, point;
  std::size_t entry;  ///< of the patch among those with neighbours
  Vec<D> place{};
  SurfaceProjection<D> projection{};
  double traction = 0, stiffness = 0;  ///< T and -dT/dg
};

/// All points at one place of the surfaces.
template <std::size_t D>
struct PairContacts {
  PairPlaces<D> places;
  std::shared_ptr<const PairNeighbours> neighbours;
  std::vector<PairContact<D>> all;  ///< of the secondary patches with neighbours
  std::vector<int> first;           ///< by secondary patch: its first point in `all`; -1: it has none there
  double least_gap = std::numeric_limits<double>::infinity();
  std::unique_ptr<PlacedSurface<D>> primary;  ///< null if a place, also at another time, is no number
  std::unique_ptr<PlacedSurface<D>> spare;    ///< memory for `primary`
  /// Returns the primary patches that a point can have its closest point on.
  const std::vector<int>& candidates(const PairContact<D>& c) const { return neighbours->primary[c.entry]; }
  /// Returns the point of a patch; null if it is not there.
  const PairContact<D>* find(std::size_t patch, std::size_t point) const {
    const int start = first.empty() ? -1 : first[patch];
    return start < 0 ? nullptr : &all[static_cast<std::size_t>(start) + point];
  }
};

/// The points at several places.
template <std::size_t D>
using PairTimes = std::vector<PairContacts<D>>;

/// Closest points at earlier places, at which the search for those at the present ones begins. They change the time of
/// a search, and the closest points by rounding errors at most.
template <std::size_t D>
struct EarlierProjections {
  const PairContacts<D>* last = nullptr;          ///< at the places that are nearest
  bool same = false;                              ///< these are the present ones
  bool same_neighbours = false;                   ///< the search was among the same neighbours
  const PairContacts<D>* last_but_one = nullptr;  ///< at places before them on the same path, or null
  double longer = 0;                              ///< the way since the last places over that between the two
  double motion = 0;                              ///< a bound on the change of a gap since the last places [L0]
  /// The clearance that closest points need until the last of the places, or the most that is worth its time [L0].
  double slack = 0;

  /// Returns where the projection of a point is likely to be. `patch`: the likely one if nothing else is known.
  ProjectionGuess<D> guess(std::size_t secondary, std::size_t point, int patch) const;
  /// Returns the least clearance that the closest point still has; 0 if it may have none.
  double clearance(std::size_t secondary, std::size_t point) const;
};

/// Sets this for each of these times, whose places are set. `earlier`: the same number of times, at other places near
/// by; null: none. `most`: of slack.
template <std::size_t D>
void find_earlier_projections(const PairTimes<D>& times, const PairTimes<D>* earlier, const PairSearch<D>& search,
                              double most, std::vector<EarlierProjections<D>>& result);

extern template struct EarlierProjections<2>;
extern template struct EarlierProjections<3>;
extern template void find_earlier_projections(const PairTimes<2>&, const PairTimes<2>*, const PairSearch<2>&, double,
                                              std::vector<EarlierProjections<2>>&);
extern template void find_earlier_projections(const PairTimes<3>&, const PairTimes<3>*, const PairSearch<3>&, double,
                                              std::vector<EarlierProjections<3>>&);

}  // namespace ixos

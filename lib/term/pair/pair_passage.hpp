/// Points of two bodies that pass through each other within one step.
#pragma once
#include "term/pair/pair_points.hpp"

namespace ixos {

/// Returns the end of a point of one surface that surely passes through the body of the other one while both move along
/// straight ways, with the least gap that was found on its way; see Admissibility::passage(). It looks at the corners
/// and the middles of patches and of their sides. Each one's way crosses the patches of the other surface, which count
/// as flat between their corners, where it enters the body and where it leaves it. A primary surface with a free rim
/// says only where a point enters its body: the point has passed if it ends deeper than an overlap can be. Parts of one
/// surface pass if they leave it at another side.
template <std::size_t D>
LowestPoint find_passage(const PairPoints<D>& points, const PairPlaces<D>& from, const PairPlaces<D>& to);

extern template LowestPoint find_passage(const PairPoints<2>&, const PairPlaces<2>&, const PairPlaces<2>&);
extern template LowestPoint find_passage(const PairPoints<3>&, const PairPlaces<3>&, const PairPlaces<3>&);

}  // namespace ixos

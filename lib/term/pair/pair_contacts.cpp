#include "term/pair/pair_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// Returns how much longer the way from b to c is than that from a to b, along the latter; at most twice as long.
template <std::size_t D>
double ratio_of_ways(const PairPlaces<D>& a, const PairPlaces<D>& b, const PairPlaces<D>& c) {
  double product = 0, square = 0;
  const auto add = [&](const std::vector<Vec<D>>& first, const std::vector<Vec<D>>& second,
                       const std::vector<Vec<D>>& third) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Vec<D> way = second[i] - first[i];
      product += inner(way, third[i] - second[i]);
      square += inner(way, way);
    }
  };
  add(a.secondary, b.secondary, c.secondary);
  add(a.primary, b.primary, c.primary);
  return square > 0 ? std::clamp(product / square, -1.0, 2.0) : 0;
}

}  // namespace

template <std::size_t D>
ProjectionGuess<D> EarlierProjections<D>::guess(std::size_t secondary, std::size_t point, int patch) const {
  const PairContact<D>* const known = last != nullptr ? last->find(secondary, point) : nullptr;
  if (known == nullptr || known->projection.patch < 0) return {patch, {}};
  const SurfaceProjection<D>& projection = known->projection;
  ProjectionGuess<D> result{projection.patch, projection.xi};
  const PairContact<D>* const before = last_but_one != nullptr ? last_but_one->find(secondary, point) : nullptr;
  if (before == nullptr || before->projection.patch != projection.patch) return result;
  for (std::size_t k = 0; k < projection.xi.size(); ++k)
    (*result.xi)[k] = std::clamp(projection.xi[k] + longer * (projection.xi[k] - before->projection.xi[k]), 0.0, 1.0);
  return result;
}

/// A closest point's patch comes no farther than by the motion, and others come no nearer than by it. A clearance says
/// nothing of patches that were no neighbours.
template <std::size_t D>
double EarlierProjections<D>::clearance(std::size_t secondary, std::size_t point) const {
  const PairContact<D>* const known = last != nullptr && same_neighbours ? last->find(secondary, point) : nullptr;
  if (known == nullptr) return 0;
  return known->projection.clearance - (known->projection.patch < 0 ? 1 : 2) * motion;
}

template <std::size_t D>
void find_earlier_projections(const PairTimes<D>& times, const PairTimes<D>* earlier, const PairSearch<D>& search,
                              double most, std::vector<EarlierProjections<D>>& result) {
  result.assign(times.size(), {});
  for (std::size_t k = 0; k < times.size(); ++k) {
    const PairPlaces<D>& places = times[k].places;
    EarlierProjections<D>& own = result[k];
    own.motion = std::numeric_limits<double>::infinity();
    if (!times[k].primary) continue;
    const auto look = [&](const PairContacts<D>& at) {
      const double motion = at.primary ? search.motion(at.places, places) : own.motion;
      if (!(motion < own.motion)) return;
      own.last = &at;
      own.motion = motion;
    };
    if (k > 0) look(times[k - 1]);
    if (earlier != nullptr) look((*earlier)[k]);
    if (own.last == nullptr) continue;
    own.same = own.last->places.secondary == places.secondary && own.last->places.primary == places.primary;
    own.same_neighbours = own.last->neighbours == times[k].neighbours;
    if (k < 2 || own.last != &times[k - 1] || !times[k - 2].primary) continue;
    own.last_but_one = &times[k - 2];
    own.longer = ratio_of_ways(times[k - 2].places, times[k - 1].places, places);
  }
  double to_come = 0;
  for (std::size_t k = times.size(); k-- > 1;) {
    to_come += result[k].motion;
    result[k - 1].slack = std::isfinite(to_come) ? std::min(2 * to_come, most) : 0;
  }
}

template struct EarlierProjections<2>;
template struct EarlierProjections<3>;
template void find_earlier_projections(const PairTimes<2>&, const PairTimes<2>*, const PairSearch<2>&, double,
                                       std::vector<EarlierProjections<2>>&);
template void find_earlier_projections(const PairTimes<3>&, const PairTimes<3>*, const PairSearch<3>&, double,
                                       std::vector<EarlierProjections<3>>&);

}  // namespace ixos

// Where the points of a surface have their closest points, and which of them a rank looks at.
#include <algorithm>
#include <limits>

#include "term/pair/pair_points.hpp"

namespace ixos {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

template <std::size_t D>
void PairPoints<D>::place_primary(Contacts& contacts) const {
  if (contacts.primary) contacts.spare = std::move(contacts.primary);
  if (!contacts.neighbours->together || !contacts.places.is_finite()) return;
  const std::vector<Vec<D>>& x = contacts.places.primary;
  const auto& together = contacts.neighbours->together;
  if (contacts.spare) {
    contacts.primary = std::move(contacts.spare);
    contacts.primary->move(x, together);
  } else {
    contacts.primary = std::make_unique<PlacedSurface<D>>(primary().patches, x, together);
  }
}

template <std::size_t D>
void PairPoints<D>::place_points(std::size_t s, const Places& at, PlacedPoints& points) const {
  const SurfacePatch<D>& patch = secondary().patches[s];
  const typename SurfacePatch<D>::Points x = patch.among(at.secondary);
  points.places.resize(per_patch_);
  points.middle = {};
  for (std::size_t q = 0; q < per_patch_; ++q) {
    const auto& weights = points_[s * per_patch_ + q].weights;
    Vec<D> place{};
    for (std::size_t a = 0; a < patch.count; ++a) place = place + weights[a] * x[a];
    points.places[q] = place;
    points.middle = points.middle + 1 / static_cast<double>(per_patch_) * place;
  }
}

template <std::size_t D>
double PairPoints<D>::PlacedPoints::radius() const {
  double result = 0;
  for (const Vec<D>& place : places) result = std::max(result, length(place - middle));
  return result;
}

/// A patch without own nodes acts on them where its points can have closest points on primary patches with own nodes.
template <std::size_t D>
void PairPoints<D>::find_acting(const Times& times, double range, std::vector<char>& acting) const {
  const Contacts& first = times.front();
  const PairNeighbours& near = *first.neighbours;
  const auto is_own = [](char own) { return own != 0; };
  const bool reacts_here = reacts_ && std::any_of(owns_primary_.begin(), owns_primary_.end(), is_own);
  std::transform(near.secondary.begin(), near.secondary.end(), acting.begin(),
                 [&](std::size_t s) { return reacts_here || owns_secondary_[s] != 0 ? 1 : 0; });
  const bool placed = std::all_of(times.begin(), times.end(), [](const Contacts& c) { return c.primary != nullptr; });
  if (visibility_ || !placed || std::all_of(owns_secondary_.begin(), owns_secondary_.end(), is_own)) return;
  double motion = 0;
  for (const Contacts& later : times) motion = std::max(motion, search_.motion(first.places, later.places));
  PlacedPoints& points = memory_.points;
  std::vector<int>& possible = memory_.nearest;
  for (std::size_t entry = 0; entry < near.secondary.size(); ++entry) {
    const std::size_t s = near.secondary[entry];
    if (acting[entry] == 0 || owns_secondary_[s] != 0) continue;
    place_points(s, first.places, points);
    first.primary->reduce(near.primary[entry], points.middle, points.radius(), search_range(near, entry, range),
                          2 * motion, possible);
    acting[entry] = std::any_of(possible.begin(), possible.end(),
                                [&](int p) { return owns_primary_[static_cast<std::size_t>(p)] != 0; })
                        ? 1
                        : 0;
  }
}

template <std::size_t D>
void PairPoints<D>::find_projections(Contacts& contacts, const EarlierProjections<D>& earlier,
                                     const std::vector<char>& looks, double range) const {
  const PairNeighbours& near = *contacts.neighbours;
  contacts.all.clear();
  contacts.all.reserve(near.secondary.size() * per_patch_);
  contacts.first.assign(secondary().patches.size(), -1);
  int guess = -1;
  PlacedPoints& points = memory_.points;
  for (std::size_t entry = 0; entry < near.secondary.size(); ++entry) {
    if (looks[entry] == 0) continue;
    const std::size_t s = near.secondary[entry];
    contacts.first[s] = static_cast<int>(contacts.all.size());
    place_points(s, contacts.places, points);
    const std::vector<int>& candidates = near.primary[entry];
    const double farthest = search_range(near, entry, range);
    std::vector<int>& nearest = memory_.nearest;  // of the candidates, for points that need them
    bool has_nearest = false;
    for (std::size_t q = 0; q < per_patch_; ++q) {
      const Vec<D>& place = points.places[q];
      Contact contact{s, q, entry, place};
      const ProjectionGuess<D> start = earlier.guess(s, q, guess);
      const double clearance = earlier.clearance(s, q);
      if (!contacts.primary) {
        contact.projection.patch = 0;
        contact.projection.gap = nan;
        contact.projection.normal.fill(nan);
        for (Vec<D>& tangent : contact.projection.frame.tangents) tangent.fill(nan);
      } else if (const Contact* const known = earlier.same ? earlier.last->find(s, q) : nullptr; known != nullptr) {
        contact.projection = known->projection;  // to the last bit, whatever neighbours a search found in between
        if (!earlier.same_neighbours) contact.projection.clearance = 0;
      } else if (clearance > 0) {
        const int patch = earlier.last->find(s, q)->projection.patch;
        if (patch >= 0) contact.projection = contacts.primary->nearest_on(start, place, farthest);
        contact.projection.clearance = contact.projection.patch == patch ? clearance : 0;
      } else if (visibility_) {
        contact.projection = contacts.primary->nearest_of(candidates, place, farthest);
      } else {
        if (!has_nearest)
          contacts.primary->reduce(candidates, points.middle, points.radius(), farthest, earlier.slack, nearest);
        has_nearest = true;
        contact.projection = contacts.primary->nearest_among(nearest, place, farthest, start, earlier.slack);
      }
      count_below_rim(contact.projection);
      keep_within(range, farthest, contact.projection);
      guess = contact.projection.patch;
      contacts.all.push_back(contact);
    }
  }
}

template void PairPoints<2>::place_primary(Contacts&) const;
template void PairPoints<2>::place_points(std::size_t, const Places&, PlacedPoints&) const;
template double PairPoints<2>::PlacedPoints::radius() const;
template void PairPoints<2>::find_acting(const Times&, double, std::vector<char>&) const;
template void PairPoints<2>::find_projections(Contacts&, const EarlierProjections<2>&, const std::vector<char>&,
                                              double) const;
template void PairPoints<3>::place_primary(Contacts&) const;
template void PairPoints<3>::place_points(std::size_t, const Places&, PlacedPoints&) const;
template double PairPoints<3>::PlacedPoints::radius() const;
template void PairPoints<3>::find_acting(const Times&, double, std::vector<char>&) const;
template void PairPoints<3>::find_projections(Contacts&, const EarlierProjections<3>&, const std::vector<char>&,
                                              double) const;

}  // namespace ixos

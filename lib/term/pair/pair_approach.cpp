#include "term/pair/pair_approach.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ixos {
namespace {

/// Returns the largest distance between two corners of a patch's side.
template <std::size_t D>
double longest_side(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x) {
  double longest = 0;
  for (const SurfacePatch<D>& patch : patches)
    for (std::size_t a = 0; a < patch.side_corners; ++a)
      for (std::size_t b = 0; b < a; ++b)
        longest = std::max(
            longest, length(x[static_cast<std::size_t>(patch.nodes[a])] - x[static_cast<std::size_t>(patch.nodes[b])]));
  return longest;
}

/// Lowers the lowest point to a place at that gap, if it is lower.
template <std::size_t D>
void lower_to(const Vec<D>& place, double gap, LowestPoint& lowest) {
  if (!(gap < lowest.gap)) return;
  lowest.gap = gap;
  std::copy(place.begin(), place.end(), lowest.place.begin());
}

/// Lowers the lowest point to the ends and the middles of the sides of one surface before the other. A surface that
/// crosses the other has an end no deeper than its longest side, or a middle. The ends are the nodes in space, unless
/// splines pass beside them.
template <std::size_t D>
void lower(const SurfacePatches<D>& surface, const std::vector<Vec<D>>& x, const PlacedSurface<D>& own,
           const PlacedSurface<D>& other, LowestPoint& lowest) {
  const std::vector<SurfacePatch<D>>& patches = surface.patches;
  const double longest = longest_side(patches, x);
  int guess = -1;
  const auto look = [&](const Vec<D>& place) {
    const SurfaceProjection<D> projection = other.nearest(place, std::max(std::abs(lowest.gap), longest), {guess, {}});
    guess = projection.patch;
    lower_to<D>(place, projection.gap, lowest);
  };
  if (D == 3 && surface.through_nodes)
    for (const Vec<D>& place : x) look(place);
  PatchParameters<D> middle;
  middle.fill(0.5);
  for (std::size_t s = 0; s < patches.size(); ++s) {
    const PlacedPatch<D>& patch = own.patch(static_cast<int>(s));
    look(patch.at(middle));
    if constexpr (D == 2) {
      look(patch.at({0}));
      if (patches[s].neighbours[1] < 0) look(patch.at({1}));
    } else if (!surface.through_nodes) {
      for (const double first : {0.0, 1.0})
        for (const double second : {0.0, 1.0}) look(patch.at({first, second}));
    }
  }
}

/// Adds a share of ways to the places.
template <std::size_t D>
void advance(typename PairPoints<D>::Places& x, double share, const typename PairPoints<D>::Places& ways) {
  const auto move = [&](std::vector<Vec<D>>& places, const std::vector<Vec<D>>& own) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = places[i] + share * own[i];
  };
  move(x.secondary, ways.secondary);
  move(x.primary, ways.primary);
}

}  // namespace

template <std::size_t D>
PairApproach<D>::PairApproach(const PairPoints<D>& points, double margin) : points_(points), margin_(margin) {
  for (const auto* surface : {&points.secondary(), &points.primary()})
    for (const SurfacePatch<D>& patch : surface->patches)
      for (const int neighbour : patch.neighbours) is_closed_ = is_closed_ && neighbour >= 0;
}

template <std::size_t D>
LowestPoint PairApproach<D>::lowest_point(const Places& x, const Places* start) const {
  LowestPoint lowest;
  if (!points_.is_positive()) lower_to_points(x, lowest);
  if (points_.visibility() != nullptr) {
    lower_to_itself(x, lowest);
    return lowest;
  }
  lower_both(x, lowest);
  found_ = is_closed_ && x.is_finite() ? std::max(lowest.gap, 0.0) : 0;
  looked_ = x;
  if (start != nullptr) lower_on_the_way(*start, x, lowest);
  return lowest;
}

/// The bound holds between two places if it holds at both.
template <std::size_t D>
bool PairApproach<D>::is_clear(const Places& x, const Places* start) const {
  if (found_ == 0 || !x.is_finite()) return false;
  const PairSearch<D>& search = points_.search();
  return search.motion(looked_, x) < found_ && (start == nullptr || search.motion(looked_, *start) < found_);
}

template <std::size_t D>
void PairApproach<D>::lower_both(const Places& x, LowestPoint& lowest) const {
  const PlacedSurface<D> secondary(points_.secondary().patches, x.secondary),
      primary(points_.primary().patches, x.primary);
  lower(points_.secondary(), x.secondary, secondary, primary, lowest);
  lower(points_.primary(), x.primary, primary, secondary, lowest);
}

template <std::size_t D>
void PairApproach<D>::lower_to_points(const Places& x, LowestPoint& lowest) const {
  memory_.part.assign(1, x);
  const auto times = points_.contacts(memory_.part, PairPoints<D>::Share::Forces);
  for (const Contact& c : times->front().all)
    if (c.projection.patch >= 0) lower_to<D>(c.place, c.projection.gap, lowest);
}

template <std::size_t D>
void PairApproach<D>::lower_to_itself(const Places& x, LowestPoint& lowest) const {
  const PlacedSurface<D> surface(points_.secondary().patches, x.secondary);
  for (std::size_t p = 0; p < points_.secondary().patches.size(); ++p)
    for (std::size_t i = 0; i < (D == 2 ? 3 : 9); ++i) {
      [[maybe_unused]] const std::size_t row = i / 3;
      PatchParameters<D> xi{0.5 * static_cast<double>(i % 3)};
      if constexpr (D == 3) xi[1] = 0.5 * static_cast<double>(row);
      const Vec<D> place = surface.patch(static_cast<int>(p)).at(xi);
      lower_to<D>(place, points_.nearest_seen(surface, p, place).gap, lowest);
    }
}

template <std::size_t D>
void PairApproach<D>::lower_on_the_way(const Places& from, const Places& to, LowestPoint& lowest) const {
  Places ways = to;
  advance<D>(ways, -1, from);
  const double count = static_cast<double>(ways.secondary.size() + ways.primary.size());
  Vec<D> mean{};
  for (const auto* own : {&ways.secondary, &ways.primary})
    for (const Vec<D>& way : *own) mean = mean + 1 / count * way;
  double motion = 0;
  for (const auto* own : {&ways.secondary, &ways.primary})
    for (const Vec<D>& way : *own) motion = std::max(motion, 2 * length(way - mean));
  const double side = std::max(longest_side(points_.secondary().patches, from.secondary),
                               longest_side(points_.primary().patches, from.primary));
  if (!(motion > side)) return;
  const int looks = static_cast<int>(std::min(1e4, motion / side));
  for (int k = 1; k <= looks; ++k) {
    Places between = from;
    advance<D>(between, k / (looks + 1.0), ways);
    lower_both(between, lowest);
  }
}

template <std::size_t D>
Vec<D> PairApproach<D>::interpolate(const Contact& contact, const std::vector<Vec<D>>& values) const {
  const SurfacePatch<D>& patch = points_.secondary().patches[contact.patch];
  Vec<D> result{};
  for (std::size_t a = 0; a < patch.count; ++a)
    result = result + points_.weights(contact)[a] * values[static_cast<std::size_t>(patch.nodes[a])];
  return result;
}

template <std::size_t D>
double PairApproach<D>::free_step(const std::vector<Places>& times, const Places& ways,
                                  const std::vector<double>& shares) const {
  std::vector<Places>& ends = memory_.ends;
  ends = times;
  for (std::size_t k = 0; k < times.size(); ++k) advance<D>(ends[k], shares[k], ways);
  const auto contacts = points_.contacts(times, PairPoints<D>::Share::Forces, -1, ends);
  std::vector<std::size_t>& order = memory_.order;
  order.resize(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The longest way restricts the step most, and the others then hardly do.
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return shares[a] > shares[b] || (shares[a] == shares[b] && a < b); });
  double most = 1;
  for (const std::size_t k : order) {
    if (shares[k] == 0 || most == 0) break;
    Places& own = memory_.ways;
    own = ways;
    for (auto* way : {&own.secondary, &own.primary})
      for (Vec<D>& w : *way) w = (most * shares[k]) * w;
    most *= free_share((*contacts)[k], own);
  }
  return most;
}

template <std::size_t D>
double PairApproach<D>::free_share(const typename PairPoints<D>::Contacts& start, const Places& ways) const {
  if (!start.primary) return 1;  // places are no numbers, which shows in the force
  const auto least = [&](const Contact& at_start) {
    return margin_ * std::min(at_start.projection.gap, points_.law().equilibrium_gap());
  };
  double room = std::numeric_limits<double>::infinity();
  for (const Contact& c : start.all) room = std::min(room, gap_of(c) - least(c));
  // The places at which contacts must hold: the start and the end.
  memory_.covered.resize(2);
  memory_.covered[0] = start.places;
  Places& end = memory_.covered[1];
  end = start.places;
  advance<D>(end, 1, ways);
  if (points_.search().motion(start.places, end) <= room) return 1;
  const auto* contacts = &start;
  std::shared_ptr<const typename PairPoints<D>::Times> later;
  const auto [fastest_secondary, fastest_primary] = points_.search().fastest(ways);
  double done = 0;
  for (int part = 0; part < 8; ++part) {
    double own = 1 - done;
    for (const Contact& c : contacts->all) {
      const Contact* const before = start.find(c.patch, c.point);
      if (before == nullptr) continue;  // it acts on no node of this rank, and another rank looks at it
      const double gap = least(*before), room_of_point = gap_of(c) - gap;
      if (room_of_point >= own * (fastest_secondary + fastest_primary)) continue;
      const Vec<D> way = interpolate(c, ways.secondary);
      if (room_of_point >= own * (length(way) + fastest_primary)) continue;
      own = std::min(own, contacts->primary->free_share(c.place, way, ways.primary, gap, contacts->candidates(c)));
    }
    done += own;
    if (own <= 0.01 * done || done >= 1) break;  // further parts are not worth their searches
    memory_.part.resize(1);
    memory_.part[0] = start.places;
    advance<D>(memory_.part[0], done, ways);
    later = points_.contacts(memory_.part, PairPoints<D>::Share::Forces, -1, memory_.covered);
    contacts = &later->front();
  }
  return std::min(done, 1.0);
}

template class PairApproach<2>;
template class PairApproach<3>;

}  // namespace ixos

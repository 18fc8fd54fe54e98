#include "geometry/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace ixos {
namespace {

template <std::size_t D>
double largest_amplification(const SurfacePatches<D>& surface) {
  double result = 1;
  for (const SurfacePatch<D>& patch : surface.patches) result = std::max(result, patch.amplification());
  return result;
}

/// Returns centre and radius of a ball that holds the patch.
template <std::size_t D>
std::pair<Vec<D>, double> ball_around(const PlacedPatch<D>& patch) {
  const auto hull = patch.hull();
  Vec<D> center{};
  for (const Vec<D>& x : hull) center = center + 1 / static_cast<double>(hull.size()) * x;
  double radius = 0;
  for (const Vec<D>& x : hull) radius = std::max(radius, length(x - center));
  return {center, radius};
}

/// The primary patches that points of a secondary one can have closest points on, and whether these points can be deep.
struct Near {
  std::vector<int> patches;
  bool deep = false;
};

/// Returns the neighbours of the secondary patches that have some; find(primary surface, secondary patch) returns them.
template <std::size_t D, class Find>
std::shared_ptr<const PairNeighbours> neighbours_of(const PairSurfaces<D>& surfaces, const PairPlaces<D>& places,
                                                    const Find& find) {
  const PlacedSurface<D> primary(surfaces.primary.patches, places.primary);
  auto result = std::make_shared<PairNeighbours>();
  std::vector<int> together;
  for (std::size_t s = 0; s < surfaces.secondary.patches.size(); ++s) {
    const SurfacePatch<D>& patch = surfaces.secondary.patches[s];
    Near near = find(primary, patch.placed(patch.among(places.secondary)));
    if (near.patches.empty()) continue;
    together.insert(together.end(), near.patches.begin(), near.patches.end());
    result->secondary.push_back(s);
    result->primary.push_back(std::move(near.patches));
    result->deep.push_back(near.deep ? 1 : 0);
  }
  if (std::none_of(result->deep.begin(), result->deep.end(), [](char deep) { return deep != 0; })) result->deep.clear();
  std::sort(together.begin(), together.end());
  together.erase(std::unique(together.begin(), together.end()), together.end());
  result->together = patch_subset(std::move(together), surfaces.primary.patches.size());
  return result;
}

/// Returns all secondary patches with the primary ones that can hold the closest points of their points, and those that
/// are farther by no more than the slack [L0].
template <std::size_t D>
std::shared_ptr<const PairNeighbours> find_nearest(const PairSurfaces<D>& surfaces, const PairPlaces<D>& places,
                                                   double slack) {
  return neighbours_of(surfaces, places, [&](const PlacedSurface<D>& primary, const PlacedPatch<D>& patch) {
    const auto [center, radius] = ball_around(patch);
    return Near{primary.reduced(center, radius, HUGE_VAL, slack)};
  });
}

/// Returns the primary patches on which points of the secondary patch can have closest points that overlap by more than
/// `overlap.least`, while gaps change by no more than `motion`; none if there are surely no such points. Below a free
/// rim the sign of a gap jumps: before an open surface, a closest point at a kink or a rim is no proof of a gap.
template <std::size_t D>
std::vector<int> projections_of_overlaps(const PlacedSurface<D>& primary, const PlacedPatch<D>& patch,
                                         const PairOverlap<D>& overlap, double motion) {
  const bool closed = std::isinf(overlap.depth);
  const double open_from = motion - overlap.least;  // a greater gap stays above -overlap.least
  const auto [center, radius] = ball_around(patch);
  const SurfaceProjection<D> middle = primary.nearest(center, overlap.depth + radius + motion);
  if (middle.patch < 0 || (closed && middle.gap > radius + open_from)) return {};
  const auto may_be_deep = [&](const PatchParameters<D>& xi) {
    const SurfaceProjection<D> projection = primary.nearest(patch.at(xi), overlap.depth + motion, {middle.patch, {}});
    if (projection.patch < 0) return false;
    const bool may_jump =
        !closed && std::any_of(projection.fixed.begin(), projection.fixed.end(), [](bool fixed) { return fixed; });
    return projection.gap <= open_from || may_jump;
  };
  if (std::none_of(overlap.points.begin(), overlap.points.end(), may_be_deep)) return {};
  return primary.reduced(center, radius, HUGE_VAL, 2 * motion + overlap.clearance);
}

/// Returns the mean radius of balls around the patches.
template <std::size_t D>
double mean_radius(const SurfacePatches<D>& surface, const std::vector<Vec<D>>& x) {
  double sum = 0;
  for (const SurfacePatch<D>& patch : surface.patches) sum += ball_around(patch.placed(patch.among(x))).second;
  return sum / static_cast<double>(surface.patches.size());
}

/// The sum of the displacements of nodes.
template <std::size_t D>
Vec<D> sum_of_ways(const std::vector<Vec<D>>& from, const std::vector<Vec<D>>& to) {
  Vec<D> sum{};
  for (std::size_t k = 0; k < from.size(); ++k) sum = sum + (to[k] - from[k]);
  return sum;
}

/// Returns the largest displacement of a node less the mean one.
template <std::size_t D>
double largest_way(const std::vector<Vec<D>>& from, const std::vector<Vec<D>>& to, const Vec<D>& mean) {
  double square = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Vec<D> way = to[k] - from[k] - mean;
    square = std::max(square, inner(way, way));
  }
  return std::sqrt(square);
}

}  // namespace

template <std::size_t D>
bool PairPlaces<D>::is_finite() const {
  double sum = 0;
  for (const auto* x : {&secondary, &primary})
    for (const Vec<D>& place : *x)
      for (const double component : place) sum += 0 * component;
  return sum == 0;
}

std::shared_ptr<const PatchSubset> patch_subset(std::vector<int> patches, std::size_t count) {
  auto result = std::make_shared<PatchSubset>();
  result->slots.assign(count, -1);
  for (std::size_t k = 0; k < patches.size(); ++k)
    result->slots[static_cast<std::size_t>(patches[k])] = static_cast<int>(k);
  result->patches = std::move(patches);
  return result;
}

template <std::size_t D>
std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<D>& surfaces, const PairPlaces<D>& places,
                                                      double range, const PairOverlap<D>& overlap, double motion) {
  return neighbours_of(surfaces, places, [&](const PlacedSurface<D>& primary, const PlacedPatch<D>& patch) {
    Near near{primary.near(patch.hull(), range)};
    if (overlap.depth == 0) return near;
    const std::vector<int> below = projections_of_overlaps(primary, patch, overlap, motion);
    if (below.empty()) return near;
    Near all{{}, true};
    std::set_union(near.patches.begin(), near.patches.end(), below.begin(), below.end(),
                   std::back_inserter(all.patches));
    return all;
  });
}

template <std::size_t D>
PairSearch<D>::PairSearch(const PairSurfaces<D>& surfaces, double clearance, PairOverlap<D> overlap)
    : surfaces_(surfaces),
      clearance_(clearance),
      overlap_(std::move(overlap)),
      secondary_amplification_(largest_amplification(surfaces.secondary)),
      primary_amplification_(largest_amplification(surfaces.primary)) {
  auto all = std::make_shared<PairNeighbours>();
  all->secondary.resize(surfaces.secondary.patches.size());
  std::iota(all->secondary.begin(), all->secondary.end(), std::size_t{0});
  all->primary.resize(all->secondary.size());
  all_ = std::move(all);
  overlap_.clearance = clearance;
  overlap_.least = std::numeric_limits<double>::infinity();
}

template <std::size_t D>
double PairSearch<D>::motion(const PairPlaces<D>& from, const PairPlaces<D>& to) const {
  const Vec<D> sum = sum_of_ways(from.secondary, to.secondary) + sum_of_ways(from.primary, to.primary);
  const Vec<D> mean = 1 / static_cast<double>(from.secondary.size() + from.primary.size()) * sum;
  return secondary_amplification_ * largest_way(from.secondary, to.secondary, mean) +
         primary_amplification_ * largest_way(from.primary, to.primary, mean);
}

template <std::size_t D>
std::array<double, 2> PairSearch<D>::fastest(const PairPlaces<D>& ways) const {
  const auto largest = [](const std::vector<Vec<D>>& own) {
    double square = 0;
    for (const Vec<D>& way : own) square = std::max(square, inner(way, way));
    return std::sqrt(square);
  };
  return {secondary_amplification_ * largest(ways.secondary), primary_amplification_ * largest(ways.primary)};
}

template <std::size_t D>
std::shared_ptr<const PairNeighbours> PairSearch<D>::cover(const std::vector<const PairPlaces<D>*>& times,
                                                           double range) {
  if (!std::all_of(times.begin(), times.end(), [](const PairPlaces<D>* places) { return places->is_finite(); }))
    return all_;
  const auto farthest = [&](const PairPlaces<D>& from) {
    double result = 0;
    for (const PairPlaces<D>* places : times) result = std::max(result, motion(from, *places));
    return result;
  };
  if (overlap_.depth > 0 && range < overlap_.least) {
    overlap_.least = range;
    last_ = nullptr;  // it can lack closest points of overlaps that are deeper than this range
  }
  if (last_) {
    const double motion = farthest(places_);
    if (std::isfinite(reach_) ? range + motion <= reach_ : motion <= skin_) return last_;
  }
  ++searches_;
  last_ = nullptr;
  places_ = *times[times.size() / 2];
  const bool bounded = std::isfinite(range);
  const double usual = bounded ? range / 4 : mean_radius(surfaces_.secondary, places_.secondary);
  skin_ = std::max(usual, 2 * farthest(places_));
  is_wide_ = skin_ > 4 * usual;
  reach_ = range + skin_;
  if (bounded)
    last_ = find_neighbours(surfaces_, places_, reach_, overlap_, reach_ - overlap_.least);
  else
    last_ = find_nearest(surfaces_, places_, 2 * skin_ + clearance_);
  return last_;
}

template <std::size_t D>
std::vector<char> patches_with_own_nodes(const SurfacePatches<D>& surface, const LocalMesh& mesh) {
  std::vector<char> result;
  for (const SurfacePatch<D>& patch : surface.patches) {
    const auto end = patch.nodes.begin() + static_cast<std::ptrdiff_t>(patch.count);
    result.push_back(std::any_of(patch.nodes.begin(), end,
                                 [&](int a) { return mesh.has_row(surface.nodes[static_cast<std::size_t>(a)]); })
                         ? 1
                         : 0);
  }
  return result;
}

template <std::size_t D>
std::vector<char> acting_patches(const PairSurfaces<D>& surfaces, const LocalMesh& mesh) {
  const std::vector<int>& nodes = surfaces.primary.nodes;
  if (std::any_of(nodes.begin(), nodes.end(), [&](int node) { return mesh.has_row(node); }))
    return std::vector<char>(surfaces.secondary.patches.size(), 1);
  return patches_with_own_nodes(surfaces.secondary, mesh);
}

template std::vector<char> patches_with_own_nodes(const SurfacePatches<2>&, const LocalMesh&);
template std::vector<char> patches_with_own_nodes(const SurfacePatches<3>&, const LocalMesh&);
template std::vector<char> acting_patches(const PairSurfaces<2>&, const LocalMesh&);
template std::vector<char> acting_patches(const PairSurfaces<3>&, const LocalMesh&);
template std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<2>&, const PairPlaces<2>&, double,
                                                               const PairOverlap<2>&, double);
template std::shared_ptr<const PairNeighbours> find_neighbours(const PairSurfaces<3>&, const PairPlaces<3>&, double,
                                                               const PairOverlap<3>&, double);
template struct PairPlaces<2>;
template struct PairPlaces<3>;
template class PairSearch<2>;
template class PairSearch<3>;

}  // namespace ixos

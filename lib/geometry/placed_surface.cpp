#include "geometry/placed_surface.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace ixos {
namespace {

namespace bg = boost::geometry;

template <std::size_t D>
using TreePoint = bg::model::point<double, D, bg::cs::cartesian>;
template <std::size_t D>
using TreeBox = bg::model::box<TreePoint<D>>;

TreePoint<2> point(const Vec<2>& x) { return {x[0], x[1]}; }
TreePoint<3> point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

template <std::size_t D>
Vec<D> shifted(Vec<D> x, double by) {
  for (double& component : x) component += by;
  return x;
}

template <std::size_t D>
TreeBox<D> grown(const Vec<D>& low, const Vec<D>& high, double by) {
  return {point(shifted(low, -by)), point(shifted(high, by))};
}

}  // namespace

template <std::size_t D>
struct PlacedSurface<D>::Tree {
  using Entry = std::pair<TreeBox<D>, int>;
  explicit Tree(const std::vector<PlacedPatch<D>>& placed) : index(entries(placed)) {}
  static std::vector<Entry> entries(const std::vector<PlacedPatch<D>>& placed) {
    std::vector<Entry> result;
    result.reserve(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Box box(placed[i].hull());
      result.emplace_back(grown(box.low, box.high, 0), static_cast<int>(i));
    }
    return result;
  }
  bg::index::rtree<Entry, bg::index::quadratic<8>> index;
};

template <std::size_t D>
PlacedSurface<D>::PlacedSurface(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x)
    : patches_(patches) {
  std::vector<int> all(patches.size());
  std::iota(all.begin(), all.end(), 0);
  place(x, all);
  tree_ = std::make_unique<Tree>(placed_);
}

template <std::size_t D>
PlacedSurface<D>::PlacedSurface(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x,
                                std::shared_ptr<const PatchSubset> subset)
    : patches_(patches), subset_(std::move(subset)) {
  place(x, subset_->patches);
}

template <std::size_t D>
void PlacedSurface<D>::move(const std::vector<Vec<D>>& x, std::shared_ptr<const PatchSubset> subset) {
  subset_ = std::move(subset);
  tree_.reset();
  place(x, subset_->patches);
}

template <std::size_t D>
void PlacedSurface<D>::place(const std::vector<Vec<D>>& x, const std::vector<int>& patches) {
  placed_.clear();
  bounds_.clear();
  placed_.reserve(patches.size());
  bounds_.reserve(patches.size());
  for (const int i : patches) {
    placed_.push_back(patches_[at(i)].placed(patches_[at(i)].among(x)));
    bounds_.emplace_back(placed_.back());
  }
}

template <std::size_t D>
PlacedSurface<D>::~PlacedSurface() = default;
template <std::size_t D>
PlacedSurface<D>::PlacedSurface(PlacedSurface&&) noexcept = default;

/// Makes the patch the best one if it is nearer; of two that are equally near, the one with the lower number counts.
template <std::size_t D>
void PlacedSurface<D>::look(int patch, const std::array<bool, SurfacePatch<D>::sides>& smooth, const Vec<D>& place,
                            Best& best, const std::optional<PatchParameters<D>>& start) const {
  const PatchBound<D>& bound = bounds_[slot(patch)];
  const auto is_farther = [&](double distance) {
    if (distance > best.projection.distance) best.others = std::min(best.others, distance);
    return distance > best.projection.distance;
  };
  if (is_farther(bound.distance(place))) return;
  const PlacedPatch<D>& own_patch = this->patch(patch);
  const PatchParameters<D> from = start ? *start : bound.start(place);
  if (!start && is_farther(bound.distance(place, own_patch.at(from)))) return;
  const PatchProjection<D> own = nearest_point(own_patch, smooth, place, from);
  const bool equal = own.distance == best.projection.distance && best.patch > patch;
  if (!(own.distance < best.projection.distance) && !equal) {
    best.others = std::min(best.others, own.distance);
    return;
  }
  if (best.patch >= 0) best.others = std::min(best.others, best.projection.distance);
  best.projection = own;
  best.patch = patch;
}

template <std::size_t D>
SurfaceProjection<D> PlacedSurface<D>::nearest(const Vec<D>& place, double range,
                                               const ProjectionGuess<D>& guess) const {
  namespace index = bg::index;
  Best best(range);
  const auto look_at = [&](int i) { look(i, patches_[at(i)].smooth, place, best); };
  if (guess.patch >= 0) look(guess.patch, patches_[at(guess.patch)].smooth, place, best, guess.xi);
  if (std::isfinite(best.projection.distance)) {
    const auto visit = [&](const typename Tree::Entry& entry) {
      if (entry.second != guess.patch) look_at(entry.second);
    };
    tree_->index.query(index::intersects(grown(place, place, best.projection.distance)),
                       boost::make_function_output_iterator(visit));
  } else {
    // The query yields patches in the order of the distances of their boxes.
    const auto count = static_cast<unsigned>(patches_.size());
    for (auto entry = tree_->index.qbegin(index::nearest(point(place), count)); entry != tree_->index.qend(); ++entry) {
      if (bg::distance(point(place), entry->first) > best.projection.distance) break;
      if (entry->second != guess.patch) look_at(entry->second);
    }
  }
  return complete(
      place, best, [](int) { return true; }, 0);
}

template <std::size_t D>
SurfaceProjection<D> PlacedSurface<D>::nearest_among(const std::vector<int>& patches, const Vec<D>& place, double range,
                                                     const ProjectionGuess<D>& guess, double slack) const {
  Best best(range);
  const bool helps = std::binary_search(patches.begin(), patches.end(), guess.patch);
  if (helps) look(guess.patch, patches_[at(guess.patch)].smooth, place, best, guess.xi);
  for (const int i : patches)
    if (!helps || i != guess.patch) look(i, patches_[at(i)].smooth, place, best);
  return complete(
      place, best, [](int) { return true; }, slack);
}

template <std::size_t D>
SurfaceProjection<D> PlacedSurface<D>::nearest_on(const ProjectionGuess<D>& guess, const Vec<D>& place,
                                                  double range) const {
  Best best(range);
  look(guess.patch, patches_[at(guess.patch)].smooth, place, best, guess.xi);
  return complete(
      place, best, [](int) { return true; }, 0);
}

/// From a place in the ball, the surface is not farther than from the center by more than the radius, and no patch
/// nearer.
template <std::size_t D>
void PlacedSurface<D>::reduce(const std::vector<int>& patches, const Vec<D>& center, double radius, double range,
                              double slack, std::vector<int>& result) const {
  boost::container::small_vector<double, 128> bounds;
  for (const int i : patches) bounds.push_back(bound(i, center));
  const auto first = std::min_element(bounds.begin(), bounds.end());
  Best best(range + radius);
  if (first != bounds.end()) {
    const int nearest = patches[static_cast<std::size_t>(first - bounds.begin())];
    look(nearest, patches_[at(nearest)].smooth, center, best);
  }
  const double farthest = std::min(range, best.projection.distance + radius) + radius + slack;
  result.clear();
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (bounds[k] <= farthest) result.push_back(patches[k]);
}

template <std::size_t D>
std::vector<int> PlacedSurface<D>::reduced(const Vec<D>& center, double radius, double range, double slack) const {
  const SurfaceProjection<D> projection = nearest(center, range + radius);
  const double distance = projection.patch < 0 ? range + radius : length(center - projection.frame.place);
  const double farthest = std::min(range, distance + radius) + radius + slack;
  return near(std::array<Vec<D>, 1>{center}, farthest);
}

template <std::size_t D>
SurfaceProjection<D> PlacedSurface<D>::nearest_of(const std::vector<int>& patches, const Vec<D>& place,
                                                  double range) const {
  const auto counts = [&](int other) { return std::binary_search(patches.begin(), patches.end(), other); };
  Best best(range);
  for (const int i : patches) {
    const SurfacePatch<D>& own = patches_[at(i)];
    std::array<bool, SurfacePatch<D>::sides> smooth = own.smooth;
    for (std::size_t side = 0; side < smooth.size(); ++side)
      smooth[side] = smooth[side] && counts(own.neighbours[side]);
    look(i, smooth, place, best);
  }
  return complete(place, best, counts, 0);
}

/// Returns the closest point. `counts`: whether a patch counts; beyond a side without such a neighbour is a free rim.
template <std::size_t D>
template <class Counts>
SurfaceProjection<D> PlacedSurface<D>::complete(const Vec<D>& place, const Best& best, const Counts& counts,
                                                double slack) const {
  SurfaceProjection<D> projection;
  projection.patch = best.patch;
  projection.clearance = best.clearance(slack);
  if (projection.patch < 0) return projection;
  projection.xi = best.projection.xi;
  projection.fixed = best.projection.fixed;
  projection.frame = best.projection.frame;
  const Vec<D> r = place - projection.frame.place;
  projection.normal = PlacedPatch<D>::normal(projection.frame);
  projection.gap = inner(r, projection.normal);
  if (best.projection.distance == 0 ||
      std::none_of(projection.fixed.begin(), projection.fixed.end(), [](bool fixed) { return fixed; }))
    return projection;
  bool rim = false;
  for (std::size_t side = 0; side < SurfacePatch<D>::sides; ++side)
    if (projection.fixed[side / 2] && projection.xi[side / 2] == (side % 2 == 0 ? 0 : 1))
      rim = rim || !counts(patches_[at(projection.patch)].neighbours[side]);
  projection.gap = (rim || is_outside(r, projection) ? 1 : -1) * best.projection.distance;
  projection.normal = (1 / projection.gap) * r;
  return projection;
}

template <std::size_t D>
std::vector<int> PlacedSurface<D>::near(const Box& box, double range) const {
  std::vector<int> result;
  const auto add = [&](const typename Tree::Entry& entry) { result.push_back(entry.second); };
  tree_->index.query(bg::index::intersects(grown(box.low, box.high, range)), boost::make_function_output_iterator(add));
  std::sort(result.begin(), result.end());
  return result;
}

template <std::size_t D>
double PlacedSurface<D>::free_share(const Vec<D>& place, const Vec<D>& way, const std::vector<Vec<D>>& ways,
                                    double least, const std::vector<int>& patches) const {
  double share = 1;
  for (const int i : patches) {
    const SurfacePatch<D>& own = patches_[at(i)];
    auto motion = own.placed(own.among(ways)).hull();
    double relative = 0;
    for (Vec<D>& w : motion) {
      w = way - w;
      relative = std::max(relative, length(w));
    }
    if (bound(i, place) - least >= share * relative) continue;
    const PatchProjection<D> projection = nearest_point(patch(i), own.smooth, place, bounds_[slot(i)].start(place));
    if (!(projection.distance > 0)) return 0;
    const double in_any_direction = std::max(0.0, (projection.distance - least) / relative);
    const Vec<D> n = (1 / projection.distance) * (place - patch(i).at(projection.xi));
    const auto hull = patch(i).hull();
    double along_normal = 1;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const double room = inner(place - hull[k], n) - least, speed = -inner(motion[k], n);
      along_normal = room < 0 ? 0 : speed > 0 ? std::min(along_normal, room / speed) : along_normal;
      if (room < 0) break;
    }
    share = std::min(share, std::max(in_any_direction, along_normal));
  }
  return share;
}

template class PlacedSurface<2>;
template class PlacedSurface<3>;

}  // namespace ixos

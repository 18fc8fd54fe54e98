#include "interaction/placed_surface.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
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

/// Returns the parameters of a point of a side; `along`: the other parameter, in space.
template <std::size_t D>
PatchParameters<D> on_side(std::size_t side, double along) {
  PatchParameters<D> xi{};
  xi[side / 2] = side % 2 == 0 ? 0 : 1;
  if constexpr (D == 3) xi[1 - side / 2] = along;
  return xi;
}

/// Returns the angle of a patch at a corner, or pi inside a side.
template <std::size_t D>
double angle_at(const PlacedPatch<D>& patch, const PatchParameters<D>& xi) {
  if constexpr (D == 2) {
    return 1;
  } else {
    for (const double t : xi)
      if (t != 0 && t != 1) return M_PI;
    const auto frame = patch.frame(xi);
    const Vec<D> a = (xi[0] == 0 ? 1.0 : -1.0) * frame.tangents[0], b = (xi[1] == 0 ? 1.0 : -1.0) * frame.tangents[1];
    return std::acos(std::clamp(inner(a, b) / (length(a) * length(b)), -1.0, 1.0));
  }
}

}  // namespace

template <std::size_t D>
struct PlacedSurface<D>::Tree {
  using Entry = std::pair<TreeBox<D>, int>;
  explicit Tree(const std::vector<Box>& own) : boxes(own), index(entries(own)) {}
  static std::vector<Entry> entries(const std::vector<Box>& own) {
    std::vector<Entry> result;
    result.reserve(own.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      result.emplace_back(grown(own[i].low, own[i].high, 0), static_cast<int>(i));
    return result;
  }
  double distance(int patch, const Vec<D>& place) const {
    const Box& box = boxes[static_cast<std::size_t>(patch)];
    Vec<D> r;
    for (std::size_t i = 0; i < D; ++i) r[i] = std::max({box.low[i] - place[i], 0.0, place[i] - box.high[i]});
    return length(r);
  }
  std::vector<Box> boxes;
  bg::index::rtree<Entry, bg::index::quadratic<8>> index;
};

template <std::size_t D>
typename SurfacePatch<D>::Points PlacedSurface<D>::nodes_of(int patch, const std::vector<Vec<D>>& values) const {
  const SurfacePatch<D>& own = patches_[static_cast<std::size_t>(patch)];
  typename SurfacePatch<D>::Points result{};
  for (std::size_t a = 0; a < own.count; ++a) result[a] = values[static_cast<std::size_t>(own.nodes[a])];
  return result;
}

template <std::size_t D>
PlacedSurface<D>::PlacedSurface(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x)
    : patches_(patches) {
  std::vector<Box> boxes;
  boxes.reserve(patches.size());
  placed_.reserve(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    placed_.push_back(patches[i].placed(nodes_of(static_cast<int>(i), x)));
    boxes.emplace_back(placed_.back().hull());
  }
  tree_ = std::make_unique<Tree>(boxes);
}

template <std::size_t D>
PlacedSurface<D>::~PlacedSurface() = default;
template <std::size_t D>
PlacedSurface<D>::PlacedSurface(PlacedSurface&&) noexcept = default;

/// Goes from the foot's patch to the patches that meet it at the foot, across the sides on which the foot is.
template <std::size_t D>
bool PlacedSurface<D>::is_outside(const Vec<D>& from_foot, const SurfaceFoot<D>& foot) const {
  const Vec<D> place = patch(foot.patch).at(foot.xi);
  struct Here {
    int patch;
    PatchParameters<D> xi;
  };
  std::vector<Here> all{{foot.patch, foot.xi}};
  Vec<D> normals{};
  for (std::size_t next = 0; next < all.size(); ++next) {
    const Here here = all[next];
    const PlacedPatch<D>& own = patch(here.patch);
    normals = normals + angle_at(own, here.xi) * own.normal(here.xi);
    for (std::size_t side = 0; side < SurfacePatch<D>::sides; ++side) {
      if (here.xi[side / 2] != (side % 2 == 0 ? 0 : 1)) continue;
      const int other = patches_[static_cast<std::size_t>(here.patch)].neighbours[side];
      if (other < 0) return true;
      if (std::any_of(all.begin(), all.end(), [&](const Here& known) { return known.patch == other; })) continue;
      // Finds the point on the other patch: on the side that faces this one, in either direction.
      Here there{other, {}};
      double least = std::numeric_limits<double>::infinity();
      const double along = D == 3 ? here.xi[(1 - side / 2) % (D - 1)] : 0;
      for (std::size_t s = 0; s < SurfacePatch<D>::sides; ++s)
        for (const double t : {along, 1 - along}) {
          if (patches_[static_cast<std::size_t>(other)].neighbours[s] != here.patch) continue;
          const PatchParameters<D> xi = on_side<D>(s, t);
          const double off = length(patch(other).at(xi) - place);
          if (!(off < least)) continue;
          least = off;
          there.xi = xi;
        }
      all.push_back(there);
    }
  }
  return inner(from_foot, normals) >= 0;
}

template <std::size_t D>
SurfaceFoot<D> PlacedSurface<D>::nearest(const Vec<D>& place, double range, int guess) const {
  namespace index = bg::index;
  SurfaceFoot<D> foot;
  PatchFoot<D> best;
  best.distance = range;
  if (patches_.empty()) return foot;
  const auto look = [&](int i) {
    const PatchFoot<D> own = nearest_point(patch(i), patches_[static_cast<std::size_t>(i)].smooth, place);
    if (own.distance > best.distance || (own.distance == best.distance && (foot.patch < 0 || foot.patch <= i))) return;
    best = own;
    foot.patch = i;
  };
  if (guess >= 0) look(guess);
  if (std::isfinite(best.distance)) {
    const auto visit = [&](const typename Tree::Entry& entry) {
      if (entry.second != guess && tree_->distance(entry.second, place) <= best.distance) look(entry.second);
    };
    tree_->index.query(index::intersects(grown(place, place, best.distance)),
                       boost::make_function_output_iterator(visit));
  } else {
    // The query yields patches in the order of the distances of their boxes.
    const auto count = static_cast<unsigned>(patches_.size());
    for (auto entry = tree_->index.qbegin(index::nearest(point(place), count)); entry != tree_->index.qend(); ++entry) {
      if (tree_->distance(entry->second, place) > best.distance) break;
      look(entry->second);
    }
  }
  complete(
      place, best, [](int) { return true; }, foot);
  return foot;
}

/// Sets what follows from the foot on its patch. `counts`: whether a patch counts; beyond a side without such a
/// neighbour is a free rim.
template <std::size_t D>
template <class Counts>
void PlacedSurface<D>::complete(const Vec<D>& place, const PatchFoot<D>& best, const Counts& counts,
                                SurfaceFoot<D>& foot) const {
  if (foot.patch < 0) return;
  foot.xi = best.xi;
  foot.fixed = best.fixed;
  const PlacedPatch<D>& own = patch(foot.patch);
  const Vec<D> r = place - own.at(best.xi);
  foot.normal = own.normal(best.xi);
  foot.gap = inner(r, foot.normal);
  if (best.distance == 0 || std::none_of(best.fixed.begin(), best.fixed.end(), [](bool fixed) { return fixed; }))
    return;
  bool rim = false;
  for (std::size_t side = 0; side < SurfacePatch<D>::sides; ++side)
    if (best.fixed[side / 2] && best.xi[side / 2] == (side % 2 == 0 ? 0 : 1))
      rim = rim || !counts(patches_[static_cast<std::size_t>(foot.patch)].neighbours[side]);
  foot.gap = (rim || is_outside(r, foot) ? 1 : -1) * best.distance;
  foot.normal = (1 / foot.gap) * r;
}

template <std::size_t D>
SurfaceFoot<D> PlacedSurface<D>::nearest_of(const std::vector<int>& patches, const Vec<D>& place, double range) const {
  SurfaceFoot<D> foot;
  PatchFoot<D> best;
  best.distance = range;
  for (const int i : patches) {
    if (tree_->distance(i, place) > best.distance) continue;
    const SurfacePatch<D>& own = patches_[static_cast<std::size_t>(i)];
    std::array<bool, SurfacePatch<D>::sides> smooth = own.smooth;
    for (std::size_t side = 0; side < smooth.size(); ++side)
      smooth[side] = smooth[side] && std::binary_search(patches.begin(), patches.end(), own.neighbours[side]);
    const PatchFoot<D> found = nearest_point(patch(i), smooth, place);
    if (!(found.distance < best.distance)) continue;
    best = found;
    foot.patch = i;
  }
  complete(
      place, best, [&](int other) { return std::binary_search(patches.begin(), patches.end(), other); }, foot);
  return foot;
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
double PlacedSurface<D>::fastest(const std::vector<Vec<D>>& ways) const {
  double result = 0;
  for (std::size_t i = 0; i < patches_.size(); ++i)
    for (const Vec<D>& w : patches_[i].placed(nodes_of(static_cast<int>(i), ways)).hull())
      result = std::max(result, length(w));
  return result;
}

template <std::size_t D>
double PlacedSurface<D>::free_share(const Vec<D>& place, const Vec<D>& way, const std::vector<Vec<D>>& ways,
                                    double fastest, double least, const std::vector<int>* among) const {
  double share = 1;
  const auto look = [&](int i) {
    const SurfacePatch<D>& own = patches_[static_cast<std::size_t>(i)];
    auto motion = own.placed(nodes_of(i, ways)).hull();
    double relative = 0;
    for (Vec<D>& w : motion) {
      w = way - w;
      relative = std::max(relative, length(w));
    }
    if (tree_->distance(i, place) - least >= share * relative) return;
    const PatchFoot<D> foot = nearest_point(patch(i), own.smooth, place);
    if (!(foot.distance > 0)) {
      share = 0;
      return;
    }
    const double in_any_direction = std::max(0.0, (foot.distance - least) / relative);
    const Vec<D> n = (1 / foot.distance) * (place - patch(i).at(foot.xi));
    const auto hull = patch(i).hull();
    double along_normal = 1;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const double room = inner(place - hull[k], n) - least, speed = -inner(motion[k], n);
      along_normal = room < 0 ? 0 : speed > 0 ? std::min(along_normal, room / speed) : along_normal;
      if (room < 0) break;
    }
    share = std::min(share, std::max(in_any_direction, along_normal));
  };
  if (among != nullptr) {
    for (const int i : *among) look(i);
    return share;
  }
  const double reach = least + length(way) + fastest;
  const auto visit = [&](const typename Tree::Entry& entry) { look(entry.second); };
  tree_->index.query(bg::index::intersects(grown(place, place, reach)), boost::make_function_output_iterator(visit));
  return share;
}

template class PlacedSurface<2>;
template class PlacedSurface<3>;

}  // namespace ixos

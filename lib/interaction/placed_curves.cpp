#include "interaction/placed_curves.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <utility>

namespace ixos {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<TreePoint>;
using Entry = std::pair<Box, int>;

/// Returns the box around a segment's hull.
Box box_of(const CurveSegment& segment, const CurveSegment::Points& x) {
  const CurveSegment::Points hull = segment.hull(x);
  Planar low = hull[0], high = hull[0];
  for (const Planar& p : hull)
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return {{low[0], low[1]}, {high[0], high[1]}};
}

double distance(const Box& box, const Planar& place) {
  const double x = std::max({box.min_corner().get<0>() - place[0], 0.0, place[0] - box.max_corner().get<0>()});
  const double y = std::max({box.min_corner().get<1>() - place[1], 0.0, place[1] - box.max_corner().get<1>()});
  return std::hypot(x, y);
}

}  // namespace

struct PlacedCurves::Tree {
  explicit Tree(const std::vector<Entry>& entries) : boxes(entries), index(entries.begin(), entries.end()) {}
  std::vector<Entry> boxes;
  bg::index::rtree<Entry, bg::index::quadratic<8>> index;
};

Planar normal_of(const CurveSegment& segment, const CurveSegment::Points& x, double t) {
  const Planar tangent = segment.sum(segment.slopes(t), x);
  const double size = length(tangent);
  return {tangent[1] / size, -tangent[0] / size};
}

PlacedCurves::PlacedCurves(const std::vector<CurveSegment>& segments, const std::vector<Planar>& x)
    : segments_(segments), x_(x) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < segments.size(); ++i)
    entries.emplace_back(box_of(segments[i], points(static_cast<int>(i))), static_cast<int>(i));
  tree_ = std::make_unique<Tree>(entries);
}

PlacedCurves::~PlacedCurves() = default;
PlacedCurves::PlacedCurves(PlacedCurves&&) noexcept = default;

CurveSegment::Points PlacedCurves::points(int segment) const {
  const CurveSegment& own = segments_[static_cast<std::size_t>(segment)];
  CurveSegment::Points x{};
  for (std::size_t a = 0; a < own.count; ++a) x[a] = x_[static_cast<std::size_t>(own.nodes[a])];
  return x;
}

Planar PlacedCurves::normal_at(int segment, double t) const {
  return normal_of(segments_[static_cast<std::size_t>(segment)], points(segment), t);
}

bool PlacedCurves::is_outside(const Planar& from_end, int segment, int end) const {
  const int other = segments_[static_cast<std::size_t>(segment)].neighbours[static_cast<std::size_t>(end)];
  if (other < 0) return true;
  return dot(from_end, normal_at(segment, end) + normal_at(other, 1 - end)) >= 0;
}

SurfaceFoot PlacedCurves::nearest(const Planar& place, double range) const {
  namespace index = bg::index;
  SurfaceFoot foot;
  CurveFoot best;
  best.distance = range;
  const auto count = static_cast<unsigned>(segments_.size());
  if (count == 0) return foot;
  // The query yields segments in the order of the distances of their boxes.
  for (auto entry = tree_->index.qbegin(index::nearest(TreePoint(place[0], place[1]), count));
       entry != tree_->index.qend(); ++entry) {
    if (distance(entry->first, place) > best.distance) break;
    const int i = entry->second;
    const CurveFoot own = nearest_point(segments_[static_cast<std::size_t>(i)], points(i), place);
    if (own.distance > best.distance || (own.distance == best.distance && (foot.segment < 0 || foot.segment < i)))
      continue;
    best = own;
    foot.segment = i;
  }
  if (foot.segment < 0) return foot;
  foot.t = best.t;
  foot.end = best.end;
  const CurveSegment& segment = segments_[static_cast<std::size_t>(foot.segment)];
  const Planar r = place - segment.sum(segment.weights(best.t), points(foot.segment));
  foot.normal = normal_at(foot.segment, best.t);
  if (best.end < 0 || best.distance == 0) {
    foot.gap = dot(r, foot.normal);
    return foot;
  }
  const double sign = is_outside(r, foot.segment, best.end) ? 1 : -1;
  foot.gap = sign * best.distance;
  foot.normal = (1 / foot.gap) * r;
  return foot;
}

double PlacedCurves::free_share(const Planar& place, const Planar& way, const std::vector<Planar>& ways,
                                double least) const {
  double share = 1;
  for (const auto& [box, i] : tree_->boxes) {
    const CurveSegment& segment = segments_[static_cast<std::size_t>(i)];
    CurveSegment::Points own_ways{};
    for (std::size_t a = 0; a < segment.count; ++a) own_ways[a] = ways[static_cast<std::size_t>(segment.nodes[a])];
    CurveSegment::Points motion = segment.hull(own_ways);
    double fastest = 0;
    for (Planar& w : motion) {
      w = way - w;
      fastest = std::max(fastest, length(w));
    }
    if (distance(box, place) - least >= share * fastest) continue;
    const CurveSegment::Points x = points(i), hull = segment.hull(x);
    const CurveFoot foot = nearest_point(segment, x, place);
    const double in_any_direction = std::max(0.0, (foot.distance - least) / fastest);
    const Planar n = (1 / foot.distance) * (place - segment.sum(segment.weights(foot.t), x));
    double along_normal = 1;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const double room = dot(place - hull[k], n) - least, speed = -dot(motion[k], n);
      along_normal = room < 0 ? 0 : speed > 0 ? std::min(along_normal, room / speed) : along_normal;
      if (room < 0) break;
    }
    share = std::min(share, std::max(in_any_direction, along_normal));
  }
  return share;
}

}  // namespace ixos

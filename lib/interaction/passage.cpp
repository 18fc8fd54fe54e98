#include "interaction/passage.hpp"

#include <cmath>

namespace ixos {
namespace {

constexpr int least_samples = 32;  ///< of the gap inside

using Point = std::array<double, 3>;

PackPoint in_all_lanes(const Point& x) { return {Pack(x[0]), Pack(x[1]), Pack(x[2])}; }

/// Returns x + s d.
PackPoint along(const Point& x, const Pack& s, const Point& d) {
  return {x[0] + s * d[0], x[1] + s * d[1], x[2] + s * d[2]};
}

/// Returns the share of the way d after which a place with that gap meets the obstacle: 0 inside, 1 if it does not.
double share_until(const Obstacle& obstacle, const Point& x, const Point& d, double gap) {
  if (!(gap > 0)) return 0;
  const Pack share = obstacle.admissible_step(in_all_lanes(x), in_all_lanes(d), Pack(0.0));
  return share[0];
}

double gap_at(const Obstacle& obstacle, const Point& x) {
  const Pack gap = obstacle.gap(in_all_lanes(x));
  return gap[0];
}

}  // namespace

WayThrough way_through(const Obstacle& obstacle, const Point& x0, const Point& x1) {
  const Point d{x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]}, back{-d[0], -d[1], -d[2]};
  WayThrough way;
  way.start = gap_at(obstacle, x0);
  way.end = gap_at(obstacle, x1);
  way.length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double first = share_until(obstacle, x0, d, way.start);
  if (!(first < 1)) return way;
  const double last = 1 - share_until(obstacle, x1, back, way.end);
  if (!(last > first)) return way;
  double deepest = std::min(way.start, way.end);
  constexpr int packs = (least_samples + pack_width - 1) / pack_width;
  const Pack lane([](auto i) { return static_cast<double>(i); });
  for (int k = 0; k < packs; ++k) {
    const Pack share = (k * pack_width + 0.5 + lane) / static_cast<double>(packs * pack_width);
    deepest = std::min(deepest, least(obstacle.gap(along(x0, first + (last - first) * share, d))));
  }
  if (!std::isfinite(deepest)) return way;  // beyond the obstacle's edge
  way.deepest = deepest;
  const Pack turn = dot(obstacle.gap_and_normal(along(x0, Pack(first), d)).normal,
                        obstacle.gap_and_normal(along(x0, Pack(last), d)).normal);
  way.turn = turn[0];
  return way;
}

Pack may_pass(const Obstacle& obstacle, const PackPoint& x0, const PackPoint& x1, double scale) {
  const Pack length = length_of({x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]});
  const auto reaches = length > obstacle.gap_or_less(x1);
  if (none_of(reaches)) return 0.0;
  const Pack start = obstacle.gap(x0), end = obstacle.gap(x1);
  const Pack deepest = 0.5 * (start + end - length);  // or less
  const Pack lower = smaller(start, end), higher = start + end - lower;
  const auto can = deepest < 0.0 && (higher > 0.5 * deepest || deepest < smaller(lower, Pack(0.0)) - scale);
  return select(reaches && can, Pack(1.0), Pack(0.0));
}

}  // namespace ixos

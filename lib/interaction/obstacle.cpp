#include "interaction/obstacle.hpp"

#include "fem/quadrature.hpp"
#include "interaction/area_factor.hpp"

namespace ixos {
namespace {

/// Returns x + s d.
PackPoint along(const PackPoint& x, const Pack& s, const PackPoint& d) {
  return {x[0] + s * d[0], x[1] + s * d[1], x[2] + s * d[2]};
}

PackPoint difference(const PackPoint& x, const PackPoint& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }

/// Adds c d to the normal n in the chosen lanes, with c such that n . d = `change`, and the derivative of c d in the
/// second point to the slope. `end` is the normal at the second point, the derivative of `change`.
void correct_along(const PackPoint& d, const Pack& change, const PackPoint& end, const Pack::mask_type& chosen,
                   MeanGap& mean) {
  const Pack square = select(chosen, dot(d, d), Pack(1.0));
  const Pack c = select(chosen, Pack((change - dot(mean.normal, d)) / square), Pack(0.0));
  PackPoint slope_of_c;
  for (std::size_t j = 0; j < 3; ++j) {
    const Pack turned = d[0] * mean.slope[0][j] + d[1] * mean.slope[1][j] + d[2] * mean.slope[2][j];
    const Pack slope = (end[j] - mean.normal[j] - turned - 2.0 * c * d[j]) / square;
    slope_of_c[j] = select(chosen, slope, Pack(0.0));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    mean.normal[i] += c * d[i];
    mean.slope[i][i] += c;
    for (std::size_t j = 0; j < 3; ++j) mean.slope[i][j] += d[i] * slope_of_c[j];
  }
}

}  // namespace

std::optional<AreaFactor> Obstacle::area_factor(int /*body_dimension*/) const { return std::nullopt; }

MeanGap Obstacle::mean(const PackPoint& x0, const PackPoint& x1) const {
  static const Quadrature gauss = gauss_legendre_unit(3);
  const PackPoint d = difference(x1, x0);
  const ObstacleGap start = at(x0), end = at(x1);
  MeanGap result{};
  result.start_gap = start.gap;
  result.end_gap = end.gap;
  result.end_normal = end.normal;
  PackPoint spread;  // the mean normal by Simpson's rule minus that by Gauss points
  for (std::size_t i = 0; i < 3; ++i) spread[i] = (start.normal[i] + end.normal[i]) / 6.0;
  for (std::size_t q = 0; q < 3; ++q) {
    const double xi = gauss.points[q], weight = gauss.weights[q], simpson = q == 1 ? 4.0 / 6 : 0.0;
    const ObstacleGap found = at(along(x0, xi, d));
    for (std::size_t i = 0; i < 3; ++i) {
      result.normal[i] += weight * found.normal[i];
      spread[i] += (simpson - weight) * found.normal[i];
      for (std::size_t j = 0; j < 3; ++j) result.slope[i][j] += (weight * xi) * found.bend[i][j];
    }
  }
  // Simpson's rule has an error of order 4 in the length of the path, the Gauss points of order 6. If the rules differ
  // by less than this, the latter is exact to rounding. A correction would then add the rounding of the gaps over the
  // length of the path, which would disturb Newton's method. The second condition excludes paths too short for digits.
  constexpr double exact = 3e-10, shortest = 1e-10;
  const Pack::mask_type inexact =
      dot(spread, spread) > exact * exact && dot(d, d) > shortest * shortest * (dot(x0, x0) + dot(x1, x1));
  if (any_of(inexact)) correct_along(d, end.gap - start.gap, end.normal, inexact, result);
  return result;
}

Pack Obstacle::size_at(const PackPoint& x) const { return length_of(x); }

Pack Obstacle::least_gap(const PackPoint& x0, const PackPoint& x1) const {
  const PackPoint d = difference(x1, x0);
  const ObstacleGap start = gap_and_normal(x0), middle = gap_and_normal(along(x0, 0.5, d)), end = gap_and_normal(x1);
  const Pack half_length = 0.5 * length_of(d);
  const auto least_between = [&](const ObstacleGap& a, const ObstacleGap& b) {
    const Pack fall = -0.5 * dot(a.normal, d), rise = 0.5 * dot(b.normal, d), ends = smaller(a.gap, b.gap);
    const auto dips = fall > 0.0 && rise > 0.0;
    const Pack where_tangents_meet = (a.gap * rise + b.gap * fall - fall * rise) / select(dips, fall + rise, Pack(1.0));
    const Pack lipschitz = 0.5 * (a.gap + b.gap - half_length);
    return smaller(ends, select(dips, std::experimental::max(where_tangents_meet, lipschitz), ends));
  };
  return smaller(least_between(start, middle), least_between(middle, end));
}

Pack Obstacle::admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const {
  constexpr int rounds = 64;
  constexpr double remainder = 1e-3;
  const Pack square = dot(d, d);
  const auto moves = square > 0.0;
  const Pack length = select(moves, Pack(std::experimental::sqrt(square)), Pack(1.0));
  Pack step = select(moves, Pack(0.0), Pack(1.0)), first = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const Pack excess = free_way(along(x, step, d), least), room = select(excess > 0.0, excess, Pack(0.0));
    if (round == 0) first = room;
    step = smaller(Pack(step + room / length), Pack(1.0));
    if (everywhere(step >= 1.0 || room <= remainder * first)) break;
  }
  return step;
}

}  // namespace ixos

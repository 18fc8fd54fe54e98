#include "interaction/curve_segment.hpp"

#include <algorithm>

namespace ixos {
namespace {

using Cubic = std::array<double, 4>;

/// Adds factor * polynomial to the coefficients.
void add(Cubic& sum, double factor, const Cubic& polynomial) {
  for (std::size_t k = 0; k < 4; ++k) sum[k] += factor * polynomial[k];
}

constexpr Cubic from_start{1, 0, -3, 2}, from_end{0, 0, 3, -2};  // values of a cubic Hermite curve
constexpr Cubic start_tangent{0, 1, -2, 1}, end_tangent{0, 0, -1, 1};

/// Returns the nearest point between two bounds on t around a guess, where half the slope of the squared distance
/// changes its sign, or else the nearer bound.
double refine(const CurveSegment& segment, const CurveSegment::Points& x, const Planar& place, double low, double high,
              double t) {
  for (int i = 0; i < 60; ++i) {
    const Planar r = segment.sum(segment.weights(t), x) - place, tangent = segment.sum(segment.slopes(t), x);
    const double slope = dot(r, tangent);
    const double curvature = dot(tangent, tangent) + dot(r, segment.sum(segment.curvatures(t), x));
    (slope > 0 ? high : low) = t;
    double next = curvature > 0 ? t - slope / curvature : 2;
    if (!(next > low && next < high)) {
      // At a bound of the segment Newton's method may lead beyond: then this bound is the point.
      if (next <= 0 && low == 0)
        next = 0;
      else if (next >= 1 && high == 1 && curvature > 0)
        next = 1;
      else
        next = (low + high) / 2;
    }
    if (next == t || high - low < 1e-16 || std::abs(next - t) < 1e-16) return next;
    t = next;
  }
  return t;
}

}  // namespace

CurveSegment::Weights CurveSegment::weights(double t) const {
  Weights n{};
  for (std::size_t a = 0; a < count; ++a) {
    const auto& c = coefficients[a];
    n[a] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
  return n;
}

CurveSegment::Weights CurveSegment::slopes(double t) const {
  Weights n{};
  for (std::size_t a = 0; a < count; ++a) {
    const auto& c = coefficients[a];
    n[a] = c[1] + t * (2 * c[2] + t * 3 * c[3]);
  }
  return n;
}

CurveSegment::Weights CurveSegment::curvatures(double t) const {
  Weights n{};
  for (std::size_t a = 0; a < count; ++a) n[a] = 2 * coefficients[a][2] + 6 * t * coefficients[a][3];
  return n;
}

CurveSegment::Points CurveSegment::hull(const Points& x) const {
  Points result{};
  for (std::size_t a = 0; a < count; ++a) {
    const auto& c = coefficients[a];
    const std::array<double, 4> bernstein{c[0], c[0] + c[1] / 3, c[0] + (2 * c[1] + c[2]) / 3,
                                          c[0] + c[1] + c[2] + c[3]};
    for (std::size_t k = 0; k < 4; ++k) result[k] = result[k] + bernstein[k] * x[a];
  }
  return result;
}

CurveSegment straight_segment(int a, int b) {
  CurveSegment segment;
  segment.nodes = {a, b, 0, 0};
  segment.coefficients = {{{1, -1, 0, 0}, {0, 1, 0, 0}, {}, {}}};
  return segment;
}

CurveSegment smooth_segment(const std::array<int, 4>& nodes, const std::array<double, 3>& lengths) {
  // By place 0 to 3 along the curve.
  std::array<Cubic, 4> by_place{};
  add(by_place[1], 1, from_start);
  add(by_place[2], 1, from_end);
  const double own = lengths[1];
  const auto add_tangent = [&](const Cubic& tangent, std::size_t before, double l0, double l1) {
    // Slope at the middle node: [l1 (x_1 - x_0)/l0 + l0 (x_2 - x_1)/l1]/(l0 + l1).
    const double back = own * l1 / (l0 * (l0 + l1)), ahead = own * l0 / (l1 * (l0 + l1));
    add(by_place[before], -back, tangent);
    add(by_place[before + 1], back - ahead, tangent);
    add(by_place[before + 2], ahead, tangent);
  };
  const auto add_chord = [&](const Cubic& tangent) {
    add(by_place[1], -1, tangent);
    add(by_place[2], 1, tangent);
  };
  if (nodes[0] >= 0)
    add_tangent(start_tangent, 0, lengths[0], own);
  else
    add_chord(start_tangent);
  if (nodes[3] >= 0)
    add_tangent(end_tangent, 1, own, lengths[2]);
  else
    add_chord(end_tangent);
  CurveSegment segment;
  segment.count = 0;
  for (const std::size_t place : {1U, 2U, 0U, 3U}) {
    if (nodes[place] < 0) continue;
    segment.nodes[segment.count] = nodes[place];
    segment.coefficients[segment.count++] = by_place[place];
  }
  segment.smooth = {nodes[0] >= 0, nodes[3] >= 0};
  return segment;
}

CurveFoot nearest_point(const CurveSegment& segment, const CurveSegment::Points& x, const Planar& place) {
  CurveFoot foot;
  if (segment.count == 2) {
    const Planar side = x[1] - x[0];
    foot.t = std::clamp(dot(place - x[0], side) / dot(side, side), 0.0, 1.0);
  } else {
    // The distance may have several minima: looks near each sample that is as near as its neighbours.
    constexpr int samples = 8;
    const auto distance = [&](double t) { return length(segment.sum(segment.weights(t), x) - place); };
    std::array<double, samples + 3> sampled;
    sampled.front() = sampled.back() = HUGE_VAL;
    for (int i = 0; i <= samples; ++i) sampled[static_cast<std::size_t>(i) + 1] = distance(i / double(samples));
    double least = HUGE_VAL;
    for (std::size_t i = 1; i <= samples + 1; ++i) {
      if (sampled[i] > sampled[i - 1] || sampled[i] > sampled[i + 1]) continue;
      const double t = (static_cast<double>(i) - 1) / samples, width = 1.0 / samples;
      const double own = refine(segment, x, place, std::max(0.0, t - width), std::min(1.0, t + width), t);
      if (!(distance(own) < least)) continue;
      least = distance(own);
      foot.t = own;
    }
  }
  foot.distance = length(segment.sum(segment.weights(foot.t), x) - place);
  if (foot.t == 0 && !segment.smooth[0]) foot.end = 0;
  if (foot.t == 1 && !segment.smooth[1]) foot.end = 1;
  return foot;
}

}  // namespace ixos

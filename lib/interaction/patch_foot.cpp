#include "interaction/patch_foot.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// Returns the nearest point of a curve between two bounds on t around a guess, where half the slope of the squared
/// distance changes its sign, or else the nearer bound.
double refine(const PlacedPatch<2>& curve, const Vec<2>& place, double low, double high, double t) {
  for (int i = 0; i < 60; ++i) {
    const auto frame = curve.frame({t});
    const Vec<2> r = frame.place - place;
    const double slope = inner(r, frame.tangents[0]);
    const double curvature = inner(frame.tangents[0], frame.tangents[0]) + inner(r, frame.bends[0]);
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

PatchParameters<2> nearest_parameters(const PlacedPatch<2>& curve, const Vec<2>& place) {
  if (curve.degree == 1) {
    const Vec<2>& side = curve.coefficients[1];
    return {std::clamp(inner(place - curve.coefficients[0], side) / inner(side, side), 0.0, 1.0)};
  }
  // The distance may have several minima: looks near each sample that is as near as its neighbours.
  constexpr int samples = 8;
  const auto distance = [&](double t) { return length(curve.at({t}) - place); };
  std::array<double, samples + 3> sampled;
  sampled.front() = sampled.back() = HUGE_VAL;
  for (int i = 0; i <= samples; ++i) sampled[static_cast<std::size_t>(i) + 1] = distance(i / double(samples));
  double least = HUGE_VAL, found = 0;
  for (std::size_t i = 1; i <= samples + 1; ++i) {
    if (sampled[i] > sampled[i - 1] || sampled[i] > sampled[i + 1]) continue;
    const double t = (static_cast<double>(i) - 1) / samples, width = 1.0 / samples;
    const double own = refine(curve, place, std::max(0.0, t - width), std::min(1.0, t + width), t);
    if (!(distance(own) < least)) continue;
    least = distance(own);
    found = own;
  }
  return {found};
}

using Parameters = PatchParameters<3>;

/// Half the squared distance with its gradient and second derivatives.
struct Objective {
  double value;
  std::array<double, 2> gradient;
  double h00, h01, h11;

  Objective(const PlacedPatch<3>& patch, const Vec<3>& place, const Parameters& xi) {
    const auto frame = patch.frame(xi);
    const Vec<3> r = frame.place - place;
    const Vec<3>&a = frame.tangents[0], &b = frame.tangents[1];
    value = inner(r, r) / 2;
    gradient = {inner(r, a), inner(r, b)};
    const double m00 = inner(a, a), m01 = inner(a, b), m11 = inner(b, b);
    h00 = m00 + inner(r, frame.bends[0]);
    h01 = m01 + inner(r, frame.bends[1]);
    h11 = m11 + inner(r, frame.bends[2]);
    if (h00 > 0 && h00 * h11 - h01 * h01 > 1e-10 * m00 * m11) return;
    h00 = m00;  // Gauss and Newton's, which is positive definite
    h01 = m01;
    h11 = m11;
  }
  /// Returns the step to the minimum of the quadratic model over the parameters that are free.
  std::array<double, 2> step(const std::array<bool, 2>& held) const {
    if (held[0] && held[1]) return {0, 0};
    if (held[0]) return {0, -gradient[1] / h11};
    if (held[1]) return {-gradient[0] / h00, 0};
    const double det = h00 * h11 - h01 * h01;
    return {(h01 * gradient[1] - h11 * gradient[0]) / det, (h01 * gradient[0] - h00 * gradient[1]) / det};
  }
};

/// Minimises the distance by Newton's method, projected to the unit square.
Parameters refine(const PlacedPatch<3>& patch, const Vec<3>& place, Parameters xi) {
  int small_steps = 0;
  for (int i = 0; i < 60 && small_steps < 2; ++i) {
    const Objective here(patch, place, xi);
    std::array<bool, 2> held{};
    for (std::size_t k = 0; k < 2; ++k)
      held[k] = (xi[k] <= 0 && here.gradient[k] >= 0) || (xi[k] >= 1 && here.gradient[k] <= 0);
    if (held[0] && held[1]) return xi;
    std::array<double, 2> step = here.step(held);
    // A parameter that the step leads beyond its bound stops there; the other one takes its own best step in the next
    // iteration.
    const auto moved = [&](double s) {
      Parameters next = xi;
      for (std::size_t k = 0; k < 2; ++k) next[k] = std::clamp(xi[k] + s * step[k], 0.0, 1.0);
      return next;
    };
    Parameters next = moved(1);
    const auto change = [&] { return std::max(std::abs(next[0] - xi[0]), std::abs(next[1] - xi[1])); };
    if (change() < 1e-7) {
      ++small_steps;  // differences of the distance are rounding: Newton's method converges
      if (change() < 1e-16) return next;
      xi = next;
      continue;
    }
    double s = 1;
    while (Objective(patch, place, next).value > here.value && s > 1e-6) next = moved(s /= 2);
    if (s <= 1e-6) {  // the projected step leads uphill: along the gradient of one parameter at a time
      bool improved = false;
      for (std::size_t k = 0; k < 2 && !improved; ++k) {
        if (held[k]) continue;
        step = {0, 0};
        step[k] = -here.gradient[k] / (k == 0 ? here.h00 : here.h11);
        for (s = 1; s > 1e-6 && !improved; s /= 2) {
          next = moved(s);
          improved = Objective(patch, place, next).value < here.value;
        }
      }
      if (!improved) return xi;
    }
    xi = next;
  }
  return xi;
}

Parameters nearest_parameters(const PlacedPatch<3>& patch, const Vec<3>& place) {
  if (patch.degree == 1) return refine(patch, place, {0.5, 0.5});
  if (patch.degree < 4) {
    PlacedPatch<3> corners;
    const Vec<3> a = patch.at({0, 0}), b = patch.at({1, 0}), c = patch.at({0, 1}), d = patch.at({1, 1});
    corners.coefficients[0] = a;
    corners.coefficients[1] = b - a;
    corners.coefficients[2] = c - a;
    corners.coefficients[3] = (a - b) + (d - c);
    return refine(patch, place, refine(corners, place, {0.5, 0.5}));
  }
  Parameters best{};
  double least = HUGE_VAL;
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) {
      const Parameters xi{i / 4.0, j / 4.0};
      const double own = length(patch.at(xi) - place);
      if (!(own < least)) continue;
      least = own;
      best = xi;
    }
  return refine(patch, place, best);
}

}  // namespace

template <std::size_t D>
PatchFoot<D> nearest_point(const PlacedPatch<D>& patch, const std::array<bool, 2 * (D - 1)>& smooth,
                           const Vec<D>& place) {
  PatchFoot<D> foot;
  foot.xi = nearest_parameters(patch, place);
  foot.distance = length(patch.at(foot.xi) - place);
  for (std::size_t k = 0; k < D - 1; ++k)
    foot.fixed[k] = (foot.xi[k] == 0 && !smooth[2 * k]) || (foot.xi[k] == 1 && !smooth[2 * k + 1]);
  return foot;
}

template PatchFoot<2> nearest_point(const PlacedPatch<2>&, const std::array<bool, 2>&, const Vec<2>&);
template PatchFoot<3> nearest_point(const PlacedPatch<3>&, const std::array<bool, 4>&, const Vec<3>&);

}  // namespace ixos

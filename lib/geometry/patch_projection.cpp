#include "geometry/patch_projection.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/bernstein.hpp"

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

/// Returns whether the squared distance of the place surely is a convex function on the whole curve: all Bernstein
/// coefficients of half its second derivative, x' . x' + (x - place) . x'', are positive.
template <std::size_t Degree>
bool is_convex(const PlacedPatch<2>& curve, const Vec<2>& place) {
  constexpr std::size_t degree = 2 * Degree - 2;
  static constexpr auto shares = bernstein_shares<degree>();
  std::array<double, degree + 1> powers{};
  for (std::size_t i = 0; i <= Degree; ++i) {
    const Vec<2> r = i == 0 ? curve.coefficients[0] - place : curve.coefficients[i];
    for (std::size_t j = i == 0 ? 2 : 1; j <= Degree; ++j) {
      const auto a = static_cast<double>(i), b = static_cast<double>(j);
      powers[i + j - 2] += (a * b + b * (b - 1)) * inner(r, curve.coefficients[j]);
    }
  }
  for (std::size_t i = 0; i <= degree; ++i) {
    double coefficient = 0;
    for (std::size_t k = 0; k <= i; ++k) coefficient += shares[i][k] * powers[k];
    if (!(coefficient > 0)) return false;
  }
  return true;
}

bool is_convex(const PlacedPatch<2>& curve, const Vec<2>& place) {
  switch (curve.degree) {
    case 2:
      return is_convex<2>(curve, place);
    case 3:
      return is_convex<3>(curve, place);
    default:
      return is_convex<4>(curve, place);
  }
}

/// Returns the nearest point of a curve whose squared distance is convex, by Newton's method from t.
double descend(const PlacedPatch<2>& curve, const Vec<2>& place, double t) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const auto frame = curve.frame({t});
    const Vec<2> r = frame.place - place;
    const double slope = inner(r, frame.tangents[0]);
    if ((t == 0 && slope >= 0) || (t == 1 && slope <= 0)) return t;
    (slope > 0 ? high : low) = t;
    const double step = -slope / (inner(frame.tangents[0], frame.tangents[0]) + inner(r, frame.bends[0]));
    double next = t + step;
    // The next step would be of the order of this one's square.
    if (std::abs(step) < 1e-9 && next > 0 && next < 1) return next;
    if (!(next > low && next < high)) next = next <= 0 && low == 0 ? 0 : next >= 1 && high == 1 ? 1 : (low + high) / 2;
    t = next;
  }
  return t;
}

PatchParameters<2> nearest_parameters(const PlacedPatch<2>& curve, const Vec<2>& place,
                                      const PatchParameters<2>& start) {
  if (curve.degree == 1) {
    const Vec<2>& side = curve.coefficients[1];
    return {std::clamp(inner(place - curve.coefficients[0], side) / inner(side, side), 0.0, 1.0)};
  }
  if (is_convex(curve, place)) return {descend(curve, place, start[0])};
  // The distance may have several minima: looks near each sample that is as near as its neighbours.
  constexpr int samples = 8;
  const auto distance = [&](double t) {  // squared
    const Vec<2> r = curve.at({t}) - place;
    return inner(r, r);
  };
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
  Parameters xi;
  double value;
  std::array<double, 2> gradient;
  double h00, h01, h11;
  bool is_convex;  ///< the second derivatives are positive definite; otherwise those of Gauss and Newton, which are

  Objective(const PlacedPatch<3>& patch, const Vec<3>& place, const Parameters& at) : xi(at) {
    const auto frame = patch.frame(xi);
    const Vec<3> r = frame.place - place;
    const Vec<3>&a = frame.tangents[0], &b = frame.tangents[1];
    value = inner(r, r) / 2;
    gradient = {inner(r, a), inner(r, b)};
    const double m00 = inner(a, a), m01 = inner(a, b), m11 = inner(b, b);
    h00 = m00 + inner(r, frame.bends[0]);
    h01 = m01 + inner(r, frame.bends[1]);
    h11 = m11 + inner(r, frame.bends[2]);
    is_convex = h00 > 0 && h00 * h11 - h01 * h01 > 1e-10 * m00 * m11;
    if (is_convex) return;
    h00 = m00;
    h01 = m01;
    h11 = m11;
  }
  /// Returns by parameter whether it is at a bound that the distance holds it at.
  std::array<bool, 2> held() const {
    std::array<bool, 2> result{};
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = (xi[k] <= 0 && gradient[k] >= 0) || (xi[k] >= 1 && gradient[k] <= 0);
    return result;
  }
  /// Returns the step to the minimum of the quadratic model over the parameters that are free.
  std::array<double, 2> step(const std::array<bool, 2>& held) const {
    if (held[0]) return {0, -gradient[1] / h11};
    if (held[1]) return {-gradient[0] / h00, 0};
    const double det = h00 * h11 - h01 * h01;
    return {(h01 * gradient[1] - h11 * gradient[0]) / det, (h01 * gradient[0] - h00 * gradient[1]) / det};
  }
  /// Returns the parameters after a share of a step. Where it leads beyond a bound, the parameter stops there; the
  /// other one takes its own best step in the next iteration.
  Parameters moved(double share, const std::array<double, 2>& step) const {
    Parameters result;
    for (std::size_t k = 0; k < 2; ++k) result[k] = std::clamp(xi[k] + share * step[k], 0.0, 1.0);
    return result;
  }
};

/// Minimises the distance by Newton's method, projected to the unit square.
Parameters refine(const PlacedPatch<3>& patch, const Vec<3>& place, const Parameters& start) {
  Objective here(patch, place, start);
  for (int i = 0, small_steps = 0; i < 60; ++i) {
    const std::array<bool, 2> held = here.held();
    if (held[0] && held[1]) return here.xi;
    std::array<double, 2> step = here.step(held);
    const Parameters next = here.moved(1, step);
    const double change = std::max(std::abs(next[0] - here.xi[0]), std::abs(next[1] - here.xi[1]));
    if (change < 1e-7) {
      // Differences of the distance are rounding. Newton's next step would be of the order of this one's square, unless
      // a bound stops this one.
      const bool stopped = next[0] != here.xi[0] + step[0] || next[1] != here.xi[1] + step[1];
      if (change < (here.is_convex && !stopped ? 1e-9 : 1e-16) || ++small_steps == 2) return next;
      here = Objective(patch, place, next);
      continue;
    }
    Objective there(patch, place, next);
    double share = 1;
    while (there.value > here.value && share > 1e-6) there = Objective(patch, place, here.moved(share /= 2, step));
    if (share <= 1e-6) {  // the projected step leads uphill: along the gradient of one parameter at a time
      bool improved = false;
      for (std::size_t k = 0; k < 2 && !improved; ++k) {
        if (held[k]) continue;
        step = {0, 0};
        step[k] = -here.gradient[k] / (k == 0 ? here.h00 : here.h11);
        for (share = 1; share > 1e-6 && !improved; share /= 2) {
          there = Objective(patch, place, here.moved(share, step));
          improved = there.value < here.value;
        }
      }
      if (!improved) return here.xi;
    }
    here = there;
  }
  return here.xi;
}

Parameters nearest_parameters(const PlacedPatch<3>& patch, const Vec<3>& place, const Parameters& start) {
  if (patch.degree < 4) return refine(patch, place, start);
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
PatchProjection<D> nearest_point(const PlacedPatch<D>& patch, const std::array<bool, 2 * (D - 1)>& smooth,
                                 const Vec<D>& place, const PatchParameters<D>& start) {
  PatchProjection<D> projection;
  projection.xi = nearest_parameters(patch, place, start);
  projection.frame = patch.frame(projection.xi);
  const Vec<D> r = projection.frame.place - place;
  projection.distance = std::sqrt(inner(r, r));
  for (std::size_t k = 0; k < D - 1; ++k)
    projection.fixed[k] = (projection.xi[k] == 0 && !smooth[2 * k]) || (projection.xi[k] == 1 && !smooth[2 * k + 1]);
  return projection;
}

template PatchProjection<2> nearest_point(const PlacedPatch<2>&, const std::array<bool, 2>&, const Vec<2>&,
                                          const PatchParameters<2>&);
template PatchProjection<3> nearest_point(const PlacedPatch<3>&, const std::array<bool, 4>&, const Vec<3>&,
                                          const PatchParameters<3>&);

}  // namespace ixos

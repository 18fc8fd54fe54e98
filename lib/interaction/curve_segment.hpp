/// One side of a surface in the plane as a curve between two nodes, and its point that is nearest to a place.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace ixos {

/// A point or vector in the plane.
using Planar = std::array<double, 2>;

inline Planar operator+(const Planar& a, const Planar& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Planar operator-(const Planar& a, const Planar& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Planar operator*(double s, const Planar& a) { return {s * a[0], s * a[1]}; }
inline double dot(const Planar& a, const Planar& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double length(const Planar& a) { return std::hypot(a[0], a[1]); }

/// A curve x(t) = sum_a N_a(t) x_a, t in [0, 1], whose weights N_a are polynomials of degree 3 at most that sum to 1:
/// a straight side, or one of Catmull and Rom's (1974). Its body is on the left of the direction of growing t.
struct CurveSegment {
  static constexpr std::size_t most = 4;  ///< nodes
  using Weights = std::array<double, most>;
  using Points = std::array<Planar, most>;

  std::array<int, most> nodes{};  ///< the first `count` count
  std::size_t count = 2;
  std::array<std::array<double, 4>, most> coefficients{};  ///< by node and power of t
  /// At t = 0 and at t = 1: true if the next segment has the same direction, false at a corner or a free end.
  std::array<bool, 2> smooth{false, false};
  /// The segments that begin or end at t = 0 and at t = 1; -1 at a free end.
  std::array<int, 2> neighbours{-1, -1};

  /// Return N_a, dN_a/dt and d2N_a/dt2.
  Weights weights(double t) const;
  Weights slopes(double t) const;
  Weights curvatures(double t) const;
  /// Returns points whose convex hull contains the curve, Bernstein's.
  Points hull(const Points& x) const;

  template <class Factors>
  Planar sum(const Factors& factors, const Points& x) const {
    Planar result{};
    for (std::size_t a = 0; a < count; ++a) result = result + factors[a] * x[a];
    return result;
  }
};

/// Returns the straight segment from node a to node b.
CurveSegment straight_segment(int a, int b);

/// Returns the cubic segment from node 1 to node 2 whose tangents at its ends are those of the parabolas through three
/// nodes, x_0, x_1, x_2 and x_1, x_2, x_3, over the lengths of the sides between them in the undeformed body [L0]: with
/// equal lengths Catmull and Rom's. A negative node 0 or 3 is none: there the tangent is that of the side, as if the
/// missing node were 2 x_1 - x_2.
CurveSegment smooth_segment(const std::array<int, 4>& nodes, const std::array<double, 3>& lengths);

/// The point of a segment that is nearest to a place.
struct CurveFoot {
  double t = 0;
  double distance = 0;  ///< [L0], not negative
  /// The end that is the nearest point, 0 or 1; -1 if the point is inside, or at an end with a smooth
  /// continuation.
  int end = -1;
};

/// Returns the point of the segment at the nodes' places x that is nearest to the place.
CurveFoot nearest_point(const CurveSegment& segment, const CurveSegment::Points& x, const Planar& place);

}  // namespace ixos

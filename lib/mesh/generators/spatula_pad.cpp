#include "mesh/generators/spatula_pad.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

using Point = SpatulaPad::Point;

/// How fast the band gets deeper away from the diagonal. The core's corner there has 180 degrees less twice the angle
/// of that slope, and 120 degrees, which three cells share evenly, would need 0.58; less keeps the depths alike.
constexpr double depth_slope = 0.4;
constexpr double corner_share = 0.55;  // the band's depth on the diagonal over that at the apex
constexpr double apex_stretch = 1.25;  // length of the rows at the apex over that of the stations
constexpr double rim_share = 0.85;     // the rim's width over the mean height of the rings, at most
constexpr double most_inset = 0.45;    // the rim's width over the band's depth, at most
constexpr double neck_tilt = 0.35;     // of the band's direction where the pad widens, over the outline's slope

/// From `corner` (w = 0, with the slope above over the length) to `far` (w = 1, with no slope).
double depth(double corner, double far, double length, double w) {
  if (far <= corner) return corner + (far - corner) * w;
  const double power = std::max(1.0, depth_slope * length / (far - corner));
  return corner + (far - corner) * (1 - std::pow(1 - w, power));
}

Point mirrored(const Point& p) { return {p[0], -p[1]}; }

}  // namespace

SpatulaPad::SpatulaPad(const SpatulaShape& shape, const SpatulaDivisions& divisions)
    : shape_(shape), divisions_(divisions) {
  const double straight = shape.pad_length - shape.tip_length;
  const double arc = M_PI / 4 * std::hypot(shape.tip_length, shape.tip_width / 2) / std::sqrt(2.0);
  straight_share_ = straight / (straight + arc);
  side_length_ = straight + arc;
  tip_length_ = arc;
  const double cell = shape.pad_length / (divisions.pad + apex_stretch * divisions.tip_rows);
  apex_depth_ = std::min({apex_stretch * divisions.tip_rows * cell, 0.4 * shape.tip_length, 0.2 * shape.tip_width});
  corner_depth_ = corner_share * apex_depth_;
}

double SpatulaPad::thickness(double x) const {
  return shape_.rear_thickness + (shape_.tip_thickness - shape_.rear_thickness) * x / shape_.pad_length;
}

SpatulaPad::Edge SpatulaPad::side(double u) const {
  const double neck = shape_.neck_width / 2, widest = shape_.tip_width / 2;
  const double straight = shape_.pad_length - shape_.tip_length;
  Edge edge{{straight * std::min(u / straight_share_, 1.0), widest}, {0, 1}, 0};
  if (u < straight_share_) {
    const double s = std::min(edge.point[0] / shape_.widening_length, 1.0);
    edge.point[1] = neck + (widest - neck) * s * s * (3 - 2 * s);
    edge.outward[0] = -neck_tilt * (widest - neck) / shape_.widening_length * 6 * s * (1 - s);
  } else {
    const double angle = M_PI / 2 - M_PI / 4 * (u - straight_share_) / (1 - straight_share_);
    edge.point = {straight + shape_.tip_length * std::cos(angle), widest * std::sin(angle)};
    edge.outward = {std::cos(angle), std::sin(angle)};
  }
  // At the rear end the band's columns are as wide as the core's.
  const double far = divisions_.tip_rows * 2 * edge.point[1] / divisions_.core_cells;
  edge.depth = depth(corner_depth_, far, side_length_, 1 - u);
  const double norm = std::hypot(edge.outward[0], edge.outward[1]);
  for (double& d : edge.outward) d /= norm;
  return edge;
}

SpatulaPad::Edge SpatulaPad::tip(double w) const {
  const double widest = shape_.tip_width / 2;
  const double angle = M_PI / 4 * (1 - w);
  const Point outward{std::cos(angle), std::sin(angle)};
  return {{shape_.pad_length - shape_.tip_length * (1 - outward[0]), widest * outward[1]},
          outward,
          depth(corner_depth_, apex_depth_, tip_length_, w)};
}

/// `share` 0: the core's boundary, 1: the outline, short of it by the inset.
Point SpatulaPad::inside(const Edge& edge, double share, double inset) const {
  const double ring_height =
      thickness(edge.point[0]) * divisions_.rings / (divisions_.core_layers + 2 * divisions_.rings);
  const double rim = std::min(rim_share * ring_height, most_inset * edge.depth);
  const double inward = edge.depth - share * (edge.depth - inset * rim);
  return {edge.point[0] - inward * edge.outward[0], edge.point[1] - inward * edge.outward[1]};
}

/// Returns a point of Coons' patch within the band's inner boundary: u along, v across. The rear end is straight and
/// evenly divided, so its terms cancel. The neck's tilt moves the sides along x; this shift fades inwards, so that
/// stations on the axis stay evenly spaced.
Point SpatulaPad::core(double u, double v) const {
  const auto at_side = [this](double s) { return inside(side(s), 0, 0); };
  const auto at_tip = [this](double s) {
    const Point p = inside(tip(1 - std::abs(2 * s - 1)), 0, 0);
    return s < 0.5 ? mirrored(p) : p;
  };
  const Point corner = at_side(1), right = at_side(u), left = mirrored(right), front = at_tip(v);
  Point result;
  for (std::size_t d = 0; d < 2; ++d) {
    const double corner_d = (1 - v) * mirrored(corner)[d] + v * corner[d];
    result[d] = (1 - v) * left[d] + v * right[d] + u * (front[d] - corner_d);
  }
  if (u < straight_share_) result[0] -= (right[0] - side(u).point[0]) * 4 * v * (1 - v);
  return result;
}

Point SpatulaPad::swept(int station, int column, double inset) const {
  const int n = divisions_.core_cells, k = divisions_.tip_rows;
  if (2 * column < n) return mirrored(swept(station, n - column, inset));
  const double u = static_cast<double>(station) / divisions_.pad;
  if (column > n - k) return inside(side(u), static_cast<double>(column - n + k) / k, inset);
  Point p = core(u, static_cast<double>(column - k) / (n - 2 * k));
  if (2 * column == n) p[1] = 0;
  return p;
}

Point SpatulaPad::at_tip(int row, int column, double inset) const {
  const int n = divisions_.core_cells, k = divisions_.tip_rows;
  if (2 * column < n) return mirrored(at_tip(row, n - column, inset));
  const double w = 1 - static_cast<double>(2 * column - n) / (n - 2 * k);
  Point p = inside(tip(w), static_cast<double>(row) / k, inset);
  if (2 * column == n) p[1] = 0;
  return p;
}

}  // namespace ixos

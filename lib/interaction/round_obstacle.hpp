/// Spheres and cylinders, and cavities of these shapes.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "interaction/area_factor.hpp"
#include "interaction/obstacle.hpp"

namespace ixos {

/// The parameters of a sphere or a cylinder.
struct RoundShape {
  std::array<double, 3> center{};  ///< of the sphere, or on the axis [L0]
  std::array<double, 3> axis{};  ///< unit vector along the axis, across the plane in two dimensions; zero for a sphere
  double radius = 0;             ///< [L0]
  std::size_t dimension = 3;     ///< of space
  bool cavity = false;           ///< the space inside is free
  bool area_factor = false;      ///< see AreaFactor
};

/// The set |y| <= R, or |y| >= R as a cavity, with y = P (x - center). P is the identity, or I - a a^T with the axis a.
/// Outside: gap |y| - R, normal m = y/|y|, second derivatives (P - m m^T)/|y|; in a cavity minus these (Gilbarg and
/// Trudinger 2001, section 14.6). At the centre, where m has no direction, the normal is zero.
template <bool Axial>
class RoundObstacle final : public Obstacle {
 public:
  explicit RoundObstacle(const RoundShape& shape) : shape_(shape), sign_(shape.cavity ? -1 : 1) {
    for (std::size_t i = 0; i < shape.dimension; ++i)
      for (std::size_t j = 0; j < shape.dimension; ++j)
        projector_[i][j] = (i == j ? 1.0 : 0.0) - shape.axis[i] * shape.axis[j];
  }

  bool is_coaxial() const override {
    return shape_.center[0] == 0 && shape_.center[2] == 0 && shape_.axis[0] == 0 && shape_.axis[2] == 0;
  }

  std::optional<AreaFactor> area_factor(int body_dimension) const override {
    if (!shape_.area_factor) return std::nullopt;
    if (Axial && shape_.dimension == 2 && body_dimension == 2)
      throw InputError("an Area Factor has no meaning in front of a strip, whose sides are flat");
    return AreaFactor{sign_ * shape_.radius, !Axial && body_dimension == 3 ? 2 : 1};
  }

  [[gnu::flatten]] ObstacleGap at(const PackPoint& x) const override {
    const PackPoint y = from_center(x);
    const Pack length = length_of(y), inverse = 1.0 / positive(length), curvature = sign_ * inverse;
    ObstacleGap found;
    found.gap = sign_ * (length - shape_.radius);
    PackPoint m;
    for (std::size_t i = 0; i < 3; ++i) m[i] = y[i] * inverse;
    for (std::size_t i = 0; i < 3; ++i) found.normal[i] = sign_ * m[i];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        found.bend[i][j] = found.bend[j][i] = curvature * (projector_[i][j] - m[i] * m[j]);
    return found;
  }

  Pack gap(const PackPoint& x) const override { return sign_ * (length_of(from_center(x)) - shape_.radius); }

  /// Eight roundings: differences, squares, sums and the root.
  Pack size_at(const PackPoint& x) const override { return 8 * (length_of(from_center(x)) + length_of(x)); }

  /// Exact: n = (y0 + y1)/(|y0| + |y1|), minus this in a cavity. The force is parallel to the mean position, so it has
  /// no moment about the centre or the axis.
  MeanGap mean(const PackPoint& x0, const PackPoint& x1) const override {
    const PackPoint y0 = from_center(x0), y1 = from_center(x1);
    const Pack first = length_of(y0), last = length_of(y1);
    const Pack end = 1.0 / positive(last), sum = 1.0 / positive(first + last);
    MeanGap result;
    result.start_gap = sign_ * (first - shape_.radius);
    result.end_gap = sign_ * (last - shape_.radius);
    PackPoint m;
    for (std::size_t i = 0; i < 3; ++i) {
      m[i] = y1[i] * end;
      result.end_normal[i] = sign_ * m[i];
      result.normal[i] = (y0[i] + y1[i]) * sum;
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result.slope[i][j] = (sign_ * sum) * (projector_[i][j] - result.normal[i] * m[j]);
    for (Pack& component : result.normal) component *= sign_;
    return result;
  }

  /// Exact: outside, the gap at the point of the path that is nearest to the centre or the axis; in a cavity, where the
  /// gap is a concave function on the path, at an end.
  Pack least_gap(const PackPoint& x0, const PackPoint& x1) const override {
    const PackPoint y0 = from_center(x0);
    if (shape_.cavity) return shape_.radius - std::experimental::max(length_of(y0), length_of(from_center(x1)));
    const PackPoint d = across({x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]});
    Pack square = 0.0, approach = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      square += d[i] * d[i];
      approach -= y0[i] * d[i];
    }
    const Pack way = smaller(std::experimental::max(approach, Pack(0.0)), square);
    const Pack share = way / select(square > 0.0, square, Pack(1.0));
    PackPoint nearest;
    for (std::size_t i = 0; i < 3; ++i) nearest[i] = y0[i] + share * d[i];
    return length_of(nearest) - shape_.radius;
  }

  /// Exact: the first s with |y + s d| = R + least, in a cavity R - least.
  Pack admissible_step(const PackPoint& x, const PackPoint& direction, const Pack& least) const override {
    const PackPoint y = from_center(x), d = across(direction);
    const Pack bound = shape_.radius + sign_ * least;
    Pack a = 0.0, b = 0.0, c = -bound * bound;
    for (std::size_t i = 0; i < 3; ++i) {
      a += d[i] * d[i];
      b += y[i] * d[i];
      c += y[i] * y[i];
    }
    const Pack root = b * b - a * c;
    // Roots of a s^2 + 2 b s + c in forms without cancellation. Outside c > 0, and the path hits if b < 0: the smaller
    // root. In a cavity c < 0: the positive root.
    const auto hits = shape_.cavity ? a > 0.0 : b < 0.0 && root > 0.0;
    const Pack width = std::experimental::sqrt(select(hits && root > 0.0, root, Pack(0.0)));
    const auto outward = b > 0.0;
    const Pack inner = select(outward, Pack(-c / positive(b + width)), Pack((width - b) / positive(a)));
    const Pack outer = c / (select(hits, Pack(-b), Pack(1.0)) + width);
    return smaller(select(hits, shape_.cavity ? inner : outer, Pack(1.0)), Pack(1.0));
  }

 private:
  /// Returns the part of a vector that P keeps.
  PackPoint across(PackPoint d) const {
    if constexpr (Axial) {
      const Pack along = d[0] * shape_.axis[0] + d[1] * shape_.axis[1] + d[2] * shape_.axis[2];
      for (std::size_t i = 0; i < 3; ++i) d[i] -= along * shape_.axis[i];
    }
    return d;
  }
  PackPoint from_center(const PackPoint& x) const {
    PackPoint y;
    for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] - shape_.center[i];
    return across(y);
  }

  RoundShape shape_;
  Small<double, 3> projector_{};  ///< P, zero beyond the dimensions of space
  double sign_;
};

}  // namespace ixos

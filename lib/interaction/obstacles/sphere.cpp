#include <cmath>

#include "interaction/catalogue.hpp"

namespace ixos {
namespace {

/// A rigid ball, in two dimensions a cylinder: gap |y| - R with y = x - center, normal y/|y|, second derivatives (I - n
/// n^T)/|y| (Gilbarg and Trudinger 2001, section 14.6).
class Sphere final : public Obstacle {
 public:
  Sphere(const std::array<double, 3>& center, double radius, std::size_t dimension)
      : center_(center), radius_(radius), dimension_(dimension) {}

  Sight at(const PackPoint& x) const override {
    const PackPoint y = from_center(x);
    const Pack distance = length(y);
    Sight sight;
    sight.gap = distance - radius_;
    for (std::size_t i = 0; i < 3; ++i) sight.normal[i] = y[i] / distance;
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j)
        sight.bend[i][j] = ((i == j ? 1.0 : 0.0) - sight.normal[i] * sight.normal[j]) / distance;
    return sight;
  }

  /// Eight roundings: differences, squares, sums and the root.
  Pack size_at(const PackPoint& x) const override { return 8 * (length(from_center(x)) + length(x)); }

  /// Exact: n = (y0 + y1)/(|y0| + |y1|). The force is parallel to the mean position, so it has no moment about the
  /// centre.
  MeanSight mean(const PackPoint& x0, const PackPoint& x1) const override {
    const PackPoint y0 = from_center(x0), y1 = from_center(x1);
    const Pack end = length(y1), sum = length(y0) + end;
    MeanSight result;
    for (std::size_t i = 0; i < 3; ++i) result.normal[i] = (y0[i] + y1[i]) / sum;
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j)
        result.slope[i][j] = ((i == j ? 1.0 : 0.0) - result.normal[i] * (y1[j] / end)) / sum;
    return result;
  }

  /// Exact: the gap at the point of the path that is nearest to the centre.
  Pack least_gap(const PackPoint& x0, const PackPoint& x1) const override {
    const PackPoint y0 = from_center(x0);
    Pack square = 0.0, approach = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Pack d = x1[i] - x0[i];
      square += d * d;
      approach -= y0[i] * d;
    }
    const Pack way = smaller(std::experimental::max(approach, Pack(0.0)), square);
    const Pack share = way / select(square > 0.0, square, Pack(1.0));
    PackPoint nearest;
    for (std::size_t i = 0; i < 3; ++i) nearest[i] = y0[i] + share * (x1[i] - x0[i]);
    return length(nearest) - radius_;
  }

  /// The first s with |y + s d| = R + least.
  Pack admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const override {
    const PackPoint y = from_center(x);
    Pack a = 0.0, b = 0.0, c = -(radius_ + least) * (radius_ + least);
    for (std::size_t i = 0; i < 3; ++i) {
      a += d[i] * d[i];
      b += y[i] * d[i];
      c += y[i] * y[i];
    }
    const Pack root = b * b - a * c;
    // The smaller root (-b - sqrt(root))/a in a form without cancellation, b < 0.
    const auto hits = b < 0.0 && root > 0.0;
    const Pack step = c / (select(hits, Pack(-b), Pack(1.0)) + std::experimental::sqrt(select(hits, root, Pack(0.0))));
    return smaller(select(hits, step, Pack(1.0)), Pack(1.0));
  }

 private:
  PackPoint from_center(const PackPoint& x) const {
    PackPoint y;
    for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] - center_[i];
    return y;
  }
  static Pack length(const PackPoint& y) { return std::experimental::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]); }

  std::array<double, 3> center_;
  double radius_;
  std::size_t dimension_;
};

struct Parameters {
  std::vector<double> center;
  double radius = 0;
};

}  // namespace

ObstacleEntry sphere_obstacle() {
  Options<Parameters> options;
  options.add("Center", &Parameters::center, "Centre of the sphere [L0]. If empty, it is the origin.", any_number())
      .require("Radius", &Parameters::radius, "Radius of the sphere [L0].", greater_than(0));
  return {"Sphere", "A rigid sphere; in two dimensions a cylinder.", "Gilbarg and Trudinger 2001, section 14.6",
          options.list(), [options](const SceneNode& node, std::size_t dimension) -> std::shared_ptr<const Obstacle> {
            const auto center = node.numbers("Center", dimension, std::vector<double>(dimension, 0.0));
            std::array<double, 3> place{};
            std::copy(center.begin(), center.end(), place.begin());
            return std::make_shared<Sphere>(place, options.read(node).radius, dimension);
          }};
}

}  // namespace ixos

#include <cmath>

#include "base/vector3.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/direction.hpp"
#include "interaction/obstacle.hpp"

namespace ixos {
namespace {

/// An infinite cone, in two dimensions a wedge, that ends in a sphere with the same tangent: the tip of an atomic force
/// microscope. With y from the sphere's centre, t its part along the axis into the cone and rho the rest, the gap is
/// |y| - R in front of the sphere, and rho cos(alpha) - t sin(alpha) - R in front of the cone, where
/// t cos(alpha) + rho sin(alpha) > 0. Gap and normal are continuous; the second derivatives jump from the sphere to the
/// cone.
class Cone final : public Obstacle {
 public:
  /// `inward` is the unit vector along the axis from the tip into the cone, `angle` half the opening angle.
  Cone(const std::array<double, 3>& tip, const std::array<double, 3>& inward, double radius, double angle,
       std::size_t dimension)
      : inward_(inward), radius_(radius), cosine_(std::cos(angle)), sine_(std::sin(angle)), dimension_(dimension) {
    for (std::size_t i = 0; i < 3; ++i) center_[i] = tip[i] + radius * inward[i];
  }

  ObstacleGap at(const PackPoint& x) const override {
    const Place place(*this, x);
    const Pack length = length_of(place.y), distance = positive(length);
    ObstacleGap found;
    found.gap = select(place.before_cone, Pack(cosine_ * place.rho - sine_ * place.t), length) - radius_;
    const Pack rho = positive(place.rho);
    PackPoint radial;
    for (std::size_t i = 0; i < 3; ++i) {
      radial[i] = place.across[i] / rho;
      found.normal[i] =
          select(place.before_cone, Pack(cosine_ * radial[i] - sine_ * inward_[i]), Pack(place.y[i] / distance));
    }
    const double around = dimension_ == 3 ? cosine_ : 0.0;  // a wedge is flat there
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j) {
        const double identity = i == j ? 1.0 : 0.0;
        const Pack cone = (around / rho) * (identity - inward_[i] * inward_[j] - radial[i] * radial[j]);
        const Pack sphere = (identity - found.normal[i] * found.normal[j]) / distance;
        found.bend[i][j] = select(place.before_cone, cone, sphere);
      }
    return found;
  }

  bool is_coaxial() const override { return center_[0] == 0 && center_[2] == 0 && inward_[0] == 0 && inward_[2] == 0; }

  /// As of the sphere.
  Pack size_at(const PackPoint& x) const override {
    const Place place(*this, x);
    return 8 * (length_of(place.y) + length_of(x));
  }

  /// Newton's method from x. The gap is a convex function of s, so its tangents lie below it: no round leads beyond the
  /// place where the gap is `least`.
  Pack admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const override {
    constexpr int rounds = 32;
    Pack step = 0.0;
    for (int round = 0; round < rounds; ++round) {
      const ObstacleGap found = at({x[0] + step * d[0], x[1] + step * d[1], x[2] + step * d[2]});
      const Pack fall = -dot(found.normal, d), room = std::experimental::max(Pack(found.gap - least), Pack(0.0));
      const auto falls = fall > 0.0;
      const Pack advance = select(falls, Pack(room / select(falls, fall, Pack(1.0))), Pack(1.0));
      const Pack next = smaller(Pack(step + advance), Pack(1.0));
      const bool done = everywhere(next - step <= 1e-9 * next);
      step = next;
      if (done) break;
    }
    return step;
  }

 private:
  struct Place {
    Place(const Cone& cone, const PackPoint& x) {
      t = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        y[i] = x[i] - cone.center_[i];
        t += y[i] * cone.inward_[i];
      }
      for (std::size_t i = 0; i < 3; ++i) across[i] = y[i] - t * cone.inward_[i];
      rho = length_of(across);
      before_cone = cone.cosine_ * t + cone.sine_ * rho > 0.0;
    }
    PackPoint y, across;
    Pack t, rho;
    Pack::mask_type before_cone;
  };

  std::array<double, 3> center_{}, inward_;
  double radius_, cosine_, sine_;
  std::size_t dimension_;
};

struct Parameters {
  std::vector<double> tip, axis;
  double radius = 0, angle = 20;
};

}  // namespace

ObstacleEntry cone_obstacle() {
  Options<Parameters> options;
  options
      .add("Tip", &Parameters::tip, "Place of the tip, on the surface [L0]. If empty, it is the origin.", any_number())
      .add("Axis", &Parameters::axis,
           "Direction in which the tip points [-]. If empty, it points along the last axis, upwards.", any_number())
      .require("Radius", &Parameters::radius, "Radius of the sphere at the tip [L0].", greater_than(0))
      .add("Half Angle", &Parameters::angle, "Angle between the axis and the side of the cone [degrees].",
           greater_and_less_than(0, 90));
  return {"Cone", "A rigid cone whose tip is a sphere with the same tangent; in two dimensions a wedge.", "",
          options.list(), [options](const SceneNode& node, std::size_t dimension) -> std::shared_ptr<const Obstacle> {
            const Parameters p = options.read(node);
            const std::array<double, 3> tip = place_of(node, "Tip", dimension);
            auto inward = unit_vector(node, "Axis", dimension, last_axis(dimension), "it must point out of the tip");
            for (double& component : inward) component = -component;
            return std::make_shared<Cone>(tip, inward, p.radius, p.angle * M_PI / 180, dimension);
          }};
}

}  // namespace ixos

#include "interaction/half_space.hpp"

#include "interaction/catalogue.hpp"
#include "interaction/direction.hpp"
#include "interaction/obstacle.hpp"

namespace ixos {
namespace {

class Wall final : public Obstacle {
 public:
  explicit Wall(const HalfSpace& wall) : wall_(wall) {}
  const HalfSpace* half_space() const override { return &wall_; }
  bool is_coaxial() const override { return wall_.normal[0] == 0 && wall_.normal[2] == 0; }
  /// As in the scalar path: laws count the gap's own rounding.
  Pack size_at(const PackPoint&) const override { return 0.0; }
  ObstacleGap at(const PackPoint& x) const override {
    ObstacleGap found;
    found.gap = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      found.gap += (x[i] - wall_.point[i]) * wall_.normal[i];
      found.normal[i] = wall_.normal[i];
    }
    return found;
  }
  Pack admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const override {
    Pack change = 0.0;
    for (std::size_t i = 0; i < 3; ++i) change += d[i] * wall_.normal[i];
    const auto closes = change < 0.0;
    const Pack step = (at(x).gap - least) / select(closes, Pack(-change), Pack(1.0));
    return smaller(select(closes, step, Pack(1.0)), Pack(1.0));
  }

 private:
  HalfSpace wall_;
};

struct Parameters {
  std::vector<double> point, normal;
};

std::shared_ptr<const Obstacle> make(const SceneNode& node, std::size_t dimension) {
  HalfSpace wall;
  wall.point = place_of(node, "Point", dimension);
  wall.normal = unit_vector(node, "Normal", dimension, last_axis(dimension), "it must point out of the wall");
  return flat_wall(wall);
}

}  // namespace

std::shared_ptr<const Obstacle> flat_wall(const HalfSpace& wall) { return std::make_shared<Wall>(wall); }

ObstacleEntry half_space_obstacle() {
  Options<Parameters> options;
  options
      .add("Point", &Parameters::point,
           "Half-Space: a point on the surface of the wall [L0]. If empty, it is the origin.", any_number())
      .add("Normal", &Parameters::normal,
           "Half-Space: vector that points out of the wall [-]. If empty, it points along the last axis.",
           any_number());
  return {"Half-Space", "Half-Space is a rigid flat wall.", "", options.list(), make, true};
}

}  // namespace ixos

#include "interaction/catalogue.hpp"
#include "interaction/direction.hpp"
#include "interaction/round_obstacle.hpp"

namespace ixos {
namespace {

struct Parameters : RoundShape {
  std::vector<double> place, direction;
};

std::shared_ptr<const Obstacle> make(const Options<Parameters>& options, const SceneNode& node, std::size_t dimension) {
  const Parameters p = options.read(node);
  RoundShape shape = p;
  shape.dimension = dimension;
  shape.center = place_of(node, "Center", dimension);
  shape.axis = {0.0, 0.0, 1.0};
  if (dimension == 2 && p.direction.empty()) return std::make_shared<RoundObstacle<false>>(shape);
  shape.axis = unit_vector(node, "Axis", dimension, shape.axis);
  return std::make_shared<RoundObstacle<true>>(shape);
}

}  // namespace

ObstacleEntry cylinder_obstacle() {
  Options<Parameters> options;
  options.add("Center", &Parameters::place, "A point on the axis [L0]. If empty, it is the origin.", any_number())
      .add("Axis", &Parameters::direction,
           "Direction of the axis [-]. If empty, it is the third axis, in two dimensions across the plane. An axis in "
           "the "
           "plane of two dimensions makes the section of a cylinder: the strip between two lines.",
           any_number())
      .require("Radius", &Parameters::radius, "Radius of the cylinder [L0].", greater_than(0))
      .add("Cavity", &Parameters::cavity, "Whether the space inside the cylinder is free, and all outside is rigid.")
      .add("Area Factor", &Parameters::area_factor, area_factor_text);
  return {"Cylinder", "A rigid cylinder of infinite length.", "Gilbarg and Trudinger 2001, section 14.6",
          options.list(),
          [options](const SceneNode& node, std::size_t dimension) { return make(options, node, dimension); }};
}

}  // namespace ixos

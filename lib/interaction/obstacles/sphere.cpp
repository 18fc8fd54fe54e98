#include "interaction/catalogue.hpp"
#include "interaction/direction.hpp"
#include "interaction/round_obstacle.hpp"

namespace ixos {
namespace {

struct Parameters : RoundShape {
  std::vector<double> place;
};

}  // namespace

ObstacleEntry sphere_obstacle() {
  Options<Parameters> options;
  options.add("Center", &Parameters::place, "Centre of the sphere [L0]. If empty, it is the origin.", any_number())
      .require("Radius", &Parameters::radius, "Radius of the sphere [L0].", greater_than(0))
      .add("Cavity", &Parameters::cavity, "Whether the space inside the sphere is free, and all outside is rigid.")
      .add("Area Factor", &Parameters::area_factor, area_factor_text);
  return {"Sphere", "A rigid sphere; in plane strain a cylinder.", "Gilbarg and Trudinger 2001, section 14.6",
          options.list(), [options](const SceneNode& node, std::size_t dimension) -> std::shared_ptr<const Obstacle> {
            RoundShape shape = options.read(node);
            shape.dimension = dimension;
            shape.center = place_of(node, "Center", dimension);
            return std::make_shared<RoundObstacle<false>>(shape);
          }};
}

}  // namespace ixos

#include "support/rigid_scene.hpp"

#include <vector>

#include "support/scene_text.hpp"

namespace ixos::test {

std::string ball_on_block_lists(const RigidScene& options) {
  const bool solid = options.dimension == 3;
  const auto upright = [&](double height, double x) {
    return solid ? std::vector<double>{x, x, height} : std::vector<double>{x, height};
  };
  const std::string box = list(
      "Mesh", word("Type", "Box") +
                  list("Box", count("Dimension", options.dimension) +
                                  numbers("Lengths", solid ? std::vector<double>{4, 4, 2} : std::vector<double>{8, 4}) +
                                  counts("Divisions", solid ? std::vector<int>{4, 4, 2} : std::vector<int>{16, 8})));
  const double radius = 2, top = solid ? 2 : 4;
  const std::vector<double> centre = upright(top + options.gap + radius, solid ? 2.2 : 4.3);
  const std::string inertia = solid ? numbers("Inertia", {1.1 * options.mass, 1.5 * options.mass, 1.9 * options.mass})
                                    : numbers("Inertia", {1.7 * options.mass});
  const std::string motion =
      numbers("Velocity", solid ? std::vector<double>{0.2, -0.1, -0.5} : std::vector<double>{0.2, -0.5}) +
      numbers("Spin", solid ? std::vector<double>{0.3, -0.2, 0.4} : std::vector<double>{0.3});
  const std::string body = list("Ball", number("Mass", options.mass) + inertia + numbers("Centre", centre) +
                                            (options.ball_rests ? "" : motion) + options.body);
  const std::string wall =
      list("Wall", word("Side Set", "top") + word("Obstacle", "Sphere") +
                       list("Sphere", number("Radius", radius) + numbers("Center", centre)) +
                       word("Rigid Body", "Ball") + number("Gamma W", 25) + number("Gamma L", 2.5));
  const std::string plate =
      options.plate == 0
          ? ""
          : list("Plate", number("Mass", options.plate) + numbers("Centre", upright(-0.5, solid ? 2 : 4)) +
                              numbers("Inertia", solid ? std::vector<double>{2 * options.plate, 3 * options.plate,
                                                                             4 * options.plate}
                                                       : std::vector<double>{5 * options.plate}));
  const std::string grips =
      plate.empty() ? "" : list("Grips", list("Glue", word("Node Set", "bottom") + word("Rigid Body", "Plate")));
  const std::string floor = options.held ? list("Boundary Conditions", list("Floor", word("Node Set", "bottom"))) : "";
  return box + list("Materials", list("Block", number("Density", 1.0))) + list("Rigid Bodies", body + plate) +
         list("Interactions", wall) + floor + grips + options.more;
}

Teuchos::ParameterList ball_on_block(const RigidScene& options) {
  return scene(ball_on_block_lists(options) +
               time_integrator(options.scheme, options.step, 100 * options.step, options.settings));
}

}  // namespace ixos::test

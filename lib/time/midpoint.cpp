#include "time/schemes.hpp"

namespace ixos {

Table midpoint() {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = 2 * du - velocity(0);
  stage.acceleration = 4 * du - 4 * velocity(0) - acceleration(0);
  stage.inertia = stage.velocity - velocity(0);
  stage.damping = du;
  stage.elastic = point_rule({0.5}, {1.0});
  stage.interaction = point_rule({0.5}, {1.0});
  stage.load = {{0.5, 1.0}};
  return {"Midpoint", {stage}, Closing::Collocate, {WorkSum::Form::Increment, {}}, Predictor::LastDisplacement};
}

}  // namespace ixos

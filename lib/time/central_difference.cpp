#include "time/schemes.hpp"

namespace ixos {

Table central_difference(double safety) {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = velocity(0) + acceleration(0);  // what the damping at the end is computed from
  stage.acceleration = acceleration(0);
  stage.inertia = 2 * du - 2 * velocity(0);
  stage.damping = velocity(0);
  stage.elastic = point_rule({0.0}, {1.0});
  stage.interaction = point_rule({0.0}, {1.0});
  stage.load = {{0.0, 1.0}};
  Table table{
      "Central Difference", {stage}, Closing::Explicit, {WorkSum::Form::EndMean, {}}, Predictor::LastDisplacement};
  table.mass = Inertia::Lumped;
  table.safety = safety;
  table.error_constant = 1.0 / 6;
  return table;
}

}  // namespace ixos

#include "time/schemes.hpp"

namespace ixos {

Table newmark(double beta, double gamma) {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = (gamma / beta) * du + (1 - gamma / beta) * velocity(0) + (1 - gamma / (2 * beta)) * acceleration(0);
  stage.acceleration = (1 / beta) * du - (1 / beta) * velocity(0) - (1 / (2 * beta) - 1) * acceleration(0);
  stage.inertia = stage.acceleration;
  stage.damping = stage.velocity;
  stage.elastic = end_rule();
  stage.interaction = end_rule();
  stage.load = {{1.0, 1.0}};
  Table table{"Newmark", {stage}, Closing::Kinematic, {WorkSum::Form::EndMean, {}}, Predictor::Nearest};
  table.error_constant = beta - 1.0 / 6;
  return table;
}

}  // namespace ixos

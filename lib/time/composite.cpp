#include "time/schemes.hpp"

namespace ixos {

Table gautam_sauer_composite(double beta, double gamma, int interaction_points, Path path) {
  const Table kinematics = newmark(beta, gamma);
  Stage stage;
  stage.velocity = kinematics.stages[0].velocity;
  stage.acceleration = kinematics.stages[0].acceleration;
  stage.inertia = stage.velocity - velocity(0);              // M (v - v_n)/dt
  stage.damping = unknown_displacement() - displacement(0);  // C (u - u_n)/dt
  stage.rate_form = RateForm::Middle;
  stage.elastic = point_rule({0.0, 1.0}, {0.5, 0.5});
  stage.interaction = mean_rule(interaction_points, path);
  stage.load = gauss_times(interaction_points);
  Table table{
      "Gautam-Sauer Composite", {stage}, Closing::Collocate, {WorkSum::Form::Increment, {}}, Predictor::Nearest};
  table.error_constant = beta / (2 * gamma) - 1.0 / 6;
  table.interaction_points = path == Path::Linear ? interaction_points : 0;
  return table;
}

}  // namespace ixos

#include "time/schemes.hpp"

namespace ixos {
namespace {

/// Newmark's kinematics; inertia weighted by 1 - a_m and a_m between the end and the start of the step, all other
/// forces by 1 - a_f and a_f.
Table weighted(const char* name, double a_m, double a_f, double beta, double gamma) {
  Stage stage = newmark(beta, gamma).stages[0];
  stage.inertia = (1 - a_m) * stage.acceleration + a_m * acceleration(0);
  stage.damping = (1 - a_f) * stage.velocity + a_f * velocity(0);
  stage.rate_start = a_f;
  stage.elastic = point_rule({0.0, 1.0}, {a_f, 1 - a_f});
  stage.interaction = stage.elastic;
  stage.load = {{0.0, a_f}, {1.0, 1 - a_f}};
  Table table{name, {stage}, Closing::Kinematic, {WorkSum::Form::Increment, {}}, Predictor::Nearest, DrivenRates::Own};
  table.error_constant = beta - 1.0 / 6 + (a_m - a_f) / 2;  // a_n stands for the acceleration at t_n + (a_m - a_f) dt
  return table;
}

}  // namespace

Table generalized_alpha(double rho) {
  const double a_m = (2 * rho - 1) / (rho + 1);
  const double a_f = rho / (rho + 1);
  const double shift = 1 - a_m + a_f;
  return weighted("Generalized-Alpha", a_m, a_f, shift * shift / 4, shift - 0.5);
}

Table hht_alpha(double alpha) { return weighted("HHT-Alpha", 0.0, -alpha, (1 - alpha) * (1 - alpha) / 4, 0.5 - alpha); }

}  // namespace ixos

#include <cmath>

#include "time/schemes.hpp"

namespace ixos {

double bathe_default_split(double rho) { return 2 / (2 + std::sqrt(2 + 2 * rho)); }

Table bathe_composite(double rho, double split) {
  const double g = split;
  const double q1 = (rho + 1) / (2 * g * (rho - 1) + 4);
  const double q0 = (g - 1) * q1 + 0.5;
  const double q2 = 0.5 - g * q1;

  Stage trapezoid;
  trapezoid.end = g;
  trapezoid.velocity = (2 / g) * (unknown_displacement() - displacement(0)) - velocity(0);
  trapezoid.acceleration = (2 / g) * (trapezoid.velocity - velocity(0)) - acceleration(0);

  Stage backward;
  backward.end = 1;
  backward.velocity = (unknown_displacement() - displacement(0) - q0 * velocity(0) - q1 * velocity(1)) / q2;
  backward.acceleration = (backward.velocity - velocity(0) - q0 * acceleration(0) - q1 * acceleration(1)) / q2;

  for (Stage* stage : {&trapezoid, &backward}) {
    stage->inertia = stage->acceleration;
    stage->damping = stage->velocity;
    stage->elastic = end_rule();
    stage->interaction = end_rule();
    stage->load = {{stage->end, 1.0}};
  }
  Table table{"Bathe Composite",
              {trapezoid, backward},
              Closing::Kinematic,
              {WorkSum::Form::Stages, {q0, q1, q2}},
              Predictor::ConstantAcceleration};
  table.error_constant = (q1 * g * g + q2) / 2 - 1.0 / 6;
  return table;
}

}  // namespace ixos

// The incremental potential of a stage.
#include <algorithm>
#include <cmath>

#include "base/dot.hpp"
#include "base/phase_timer.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

Potential StageProblem::potential(const Vector& x) {
  const TimedScope timed(Phase::Residual);
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::vector<double> u(u_.size()), bracket(u_.size()), product(u_.size());
  std::copy(u_.begin() + model_.space().first_global(), u_.end(), u.begin() + model_.space().first_global());
  model_.space().import(x, u.data());
  model_.carry(u.data());
  BalancePoint at = point();
  for (Segment* segment : {&at.elastic, &at.interaction}) {
    segment->from = start_->u.data();
    segment->to = u.data();
  }
  Potential sum = balance_.potential(at);
  const auto add = [&sum](double value) {
    sum.value += value;
    sum.magnitude += std::abs(value);
  };
  if (has_mass_) {
    inertia_bracket(u, bracket);
    model_.mass()->multiply(bracket.data(), product.data());
    add(dot(bracket, product, owned) / (2 * stage_->inertia.unknown * dt_ * dt_));
  }
  if (balance_.sums().has_rates()) add(balance_.sums().rate_potential(at.elastic.end()));
  for (std::size_t i = 0; i < owned; ++i) product[i] = u[i] - start_->u[i];
  add(dot(kept_, product, owned));
  if (bodies_) {
    const Potential globals = globals_potential(u, bracket);
    sum.value += globals.value;
    sum.magnitude += globals.magnitude;
  }
  double sums[2] = {sum.value, sum.magnitude};
  model_.space().sum(sums, 2);
  return {sums[0], sums[1]};
}

}  // namespace ixos

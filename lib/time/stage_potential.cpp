// The incremental potential of a stage.
#include <algorithm>
#include <cmath>

#include "base/dot.hpp"
#include "base/phase_timer.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

Potential StageProblem::rule_potential(Part part, const Rule& rule, const std::vector<double>& u) const {
  Potential sum;
  if (part == Part::Interaction) {
    sum.value = model_.local_mean_potential({from_->data(), nullptr, u.data(), step_time_, stage_->end * dt_}, rule);
    sum.magnitude = std::abs(sum.value);
  }
  std::vector<double> at(u.size());
  for (const RulePoint& point : rule.points) {
    for (std::size_t i = 0; i < u.size(); ++i) at[i] = point.to * u[i];
    if (point.from != 0)
      for (std::size_t i = 0; i < u.size(); ++i) at[i] += point.from * (*from_)[i];
    if (point.velocity != 0)
      for (std::size_t i = 0; i < u.size(); ++i) at[i] += point.velocity * path_velocity_[i];
    model_.set_time(step_time_ + point.time * stage_->end * dt_);
    const double energy = model_.local_potential(part, rule, at.data());
    sum.value += point.weight / point.to * energy;
    sum.magnitude += point.weight / point.to * std::abs(energy);
  }
  model_.set_time(step_time_);
  return sum;
}

Potential StageProblem::potential(const Vector& x) {
  const TimedScope timed(Phase::Residual);
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::vector<double> u(u_.size()), bracket(u_.size()), product(u_.size());
  model_.space().import(x, u.data());
  Potential sum = rule_potential(Part::Elastic, stage_->elastic, u);
  const auto add = [&sum](double value) {
    sum.value += value;
    sum.magnitude += std::abs(value);
  };
  if (model_.has_interactions()) {
    const Potential interaction = rule_potential(Part::Interaction, stage_->interaction, u);
    sum.value += interaction.value;
    sum.magnitude += interaction.magnitude;
  }
  if (has_mass_) {
    inertia_bracket(u, bracket);
    model_.mass()->multiply(bracket.data(), product.data());
    add(dot(bracket, product, owned) / (2 * stage_->inertia.unknown * dt_ * dt_));
  }
  if (model_.has_rates()) add(model_.local_rate_potential(u.data()));
  for (std::size_t i = 0; i < owned; ++i) bracket[i] = u[i] - (*from_)[i];
  add(dot(kept_, bracket, owned));
  double sums[2] = {sum.value, sum.magnitude};
  model_.space().sum(sums, 2);
  return {sums[0], sums[1]};
}

}  // namespace ixos

#include "balance/balance.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

Balance::Balance(const Model& model) : model_(model), sums_(model) {
  const auto local = static_cast<std::size_t>(model.space().local());
  inertia_.resize(local);
  elastic_.resize(local);
  if (model.has_interactions()) interaction_.resize(local);
  globals_.resize(static_cast<std::size_t>(model.space().globals().numbers));
}

bool Balance::evaluate(Part part, const Segment& segment, const Rule& rule, KeptForces* kept) {
  std::vector<double>& f = part == Part::Elastic ? elastic_ : interaction_;
  f.resize(inertia_.size());  // an interaction may have come later
  return kept == nullptr ? sums_.force(part, segment, rule, f.data())
                         : sums_.force_and_keep(part, segment, rule, *kept, f.data());
}

void Balance::evaluate_inertia(const BalancePoint& at) {
  if (at.acceleration == nullptr) return;
  model_.mass()->multiply(at.acceleration, inertia_.data());
  if (at.mass == 1) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.space().owned()); ++i) inertia_[i] *= at.mass;
}

bool Balance::evaluate(const BalancePoint& at, KeptForces* kept) {
  evaluate_inertia(at);
  const bool admissible = evaluate(Part::Elastic, at.elastic, *at.elastic_rule, kept);
  if (!model_.has_interactions()) return admissible;
  return evaluate(Part::Interaction, at.interaction, *at.interaction_rule, kept) && admissible;
}

void Balance::sum(const BalancePoint& at, const double* fixed, double* out) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const bool interacts = model_.has_interactions(), has_inertia = at.acceleration != nullptr;
  for (std::size_t i = 0; i < owned; ++i) {
    double sum = elastic_[i];
    if (fixed != nullptr) sum += fixed[i];
    if (has_inertia) sum += inertia_[i];
    if (interacts) sum += interaction_[i];
    out[i] = sum;
  }
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  for (std::size_t i = 0; i < globals_.size(); ++i)
    globals_[i] =
        elastic_[first + i] + (interacts ? interaction_[first + i] : 0.0) + (fixed != nullptr ? fixed[first + i] : 0.0);
  if (at.rates == Rates::None || !sums_.has_rates()) return;
  rates_.resize(elastic_.size());
  std::copy_n(out, owned, rates_.data());  // terms add to local arrays
  std::copy(globals_.begin(), globals_.end(), rates_.begin() + static_cast<std::ptrdiff_t>(first));
  if (at.rates == Rates::Stage)
    sums_.add_rate_force(at.elastic.end(), rates_.data());
  else
    sums_.add_rate_force_at(1.0, at.elastic.to, at.velocity, rates_.data());
  std::copy_n(rates_.data(), owned, out);
  std::copy_n(rates_.data() + first, globals_.size(), globals_.data());
}

void Balance::tangent(const BalancePoint& at, const TangentWeights& weights, Tangent kind, const KeptForces* kept,
                      double* values) const {
  if (model_.mass() != nullptr && weights.mass != 0)
    model_.mass()->set(weights.mass, values);
  else
    std::fill_n(values, model_.pattern().matrix_values(), 0.0);
  if (at.rates == Rates::Stage) sums_.add_rate_tangent(at.elastic.end(), values);
  if (at.rates == Rates::State)
    sums_.add_rate_tangent_at(weights.damping, weights.stiffness, at.elastic.to, at.velocity, values);
  const auto add = [&](Part part, const Segment& segment, const Rule& rule, Tangent own) {
    if (kept != nullptr)
      sums_.add_kept_tangent(part, segment, rule, own, *kept, values);
    else
      sums_.add_tangent(part, segment, rule, own, values);
  };
  if (weights.stiffness != 0) add(Part::Elastic, at.elastic, *at.elastic_rule, Tangent::Exact);
  if (weights.stiffness != 0) add(Part::Interaction, at.interaction, *at.interaction_rule, kind);
  model_.pattern().condense(values);
  if (weights.shift != 0) add_to_diagonal(model_.pattern(), model_.mesh().dimension, weights.shift, values);
}

Potential Balance::rule_potential(Part part, const Segment& segment, const Rule& rule) const {
  Potential sum;
  if (part == Part::Interaction) {
    sum.value = sums_.mean_potential(segment, rule);
    sum.magnitude = std::abs(sum.value);
  }
  std::vector<double> at(elastic_.size());
  for (const RulePoint& point : rule.points) {
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = point.to * segment.to[i];
    if (point.from != 0)
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += point.from * segment.from[i];
    if (point.velocity != 0)
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += point.velocity * segment.velocity[i];
    const double energy =
        sums_.potential(part, rule, {at.data(), segment.time(point), segment.histories, segment.step});
    sum.value += point.weight / point.to * energy;
    sum.magnitude += point.weight / point.to * std::abs(energy);
  }
  return sum;
}

Potential Balance::potential(const BalancePoint& at) const {
  Potential sum = rule_potential(Part::Elastic, at.elastic, *at.elastic_rule);
  if (!model_.has_interactions()) return sum;
  const Potential interaction = rule_potential(Part::Interaction, at.interaction, *at.interaction_rule);
  return {sum.value + interaction.value, sum.magnitude + interaction.magnitude};
}

}  // namespace ixos

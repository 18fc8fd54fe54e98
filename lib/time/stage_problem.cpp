#include "time/stage_problem.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/phase_timer.hpp"
#include "time/row_on_states.hpp"

namespace ixos {
namespace {

double square_sum(const std::vector<double>& x, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += x[i] * x[i];
  return sum;
}

}  // namespace

StageProblem::StageProblem(const Model& model, const Stage& stage) : model_(model), stage_(stage) {
  const auto local = static_cast<std::size_t>(model.space().local());
  const bool path_velocity = stage.elastic.uses_velocity() || stage.interaction.uses_velocity();
  path_velocity_.resize(path_velocity ? local : 0);
  for (std::vector<double>* array : {&known_inertia_, &u_, &bracket_, &inertia_, &elastic_, &direction_, &kept_})
    array->resize(local);
  if (model.damping() != nullptr) known_damping_.resize(local);
  if (model.has_interactions()) interaction_.resize(local);
}

void StageProblem::set_constraints(std::vector<double>& u) const {
  for (const Constraint& c : model_.constraints())
    u[static_cast<std::size_t>(c.dof)] = c.displacement + c.velocity * stage_time_;
}

Segment StageProblem::segment(const Rule& rule) const {
  const bool from = std::any_of(rule.points.begin(), rule.points.end(), [](const RulePoint& p) { return p.from != 0; });
  return {from ? from_->data() : nullptr, rule.uses_velocity() ? path_velocity_.data() : nullptr, u_.data()};
}

void StageProblem::arm(const std::vector<State>& known, double time, double dt) {
  dt_ = dt;
  stage_time_ = time + stage_.end * dt;
  from_ = &known[0].u;
  evaluate_known(stage_.inertia, known, dt, known_inertia_);
  if (model_.damping() != nullptr) evaluate_known(stage_.damping, known, dt, known_damping_);
  for (std::size_t i = 0; i < path_velocity_.size(); ++i) path_velocity_[i] = stage_.end * dt * known[0].v[i];

  bool admissible = true;
  std::fill(kept_.begin(), kept_.end(), 0.0);
  const auto keep = [&](const Rule& rule, std::vector<double>& force, const auto& evaluate_force) {
    if (rule.kept_weight == 0) return;
    admissible = evaluate_force(Segment{nullptr, nullptr, from_->data()}, end_rule(), force.data()) && admissible;
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] += rule.kept_weight * force[i];
  };
  keep(stage_.elastic, elastic_, [&](auto&&... args) { return model_.elastic_force(args...); });
  if (model_.has_interactions())
    keep(stage_.interaction, interaction_, [&](auto&&... args) { return model_.interaction_force(args...); });
  if (model_.space().minimum(admissible ? 1 : 0) == 0) throw std::logic_error("the start of the step is inadmissible");

  const double coefficient = stage_.inertia.unknown / (dt * dt);
  rounding_ = rounding_force(known[0], coefficient);
  diagonal_ = coefficient * model_.mass_scale() + model_.elastic_scale();
}

double StageProblem::rounding_force(const State& start, double coefficient) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  double squares[3] = {0, 0, square_sum(start.u, owned)};
  model_.mass().multiply(start.u.data(), inertia_.data());
  squares[0] = square_sum(inertia_, owned);
  model_.mass().multiply(start.v.data(), inertia_.data());
  squares[1] = square_sum(inertia_, owned);
  model_.space().sum(squares, 3);
  // u_s is rounded, and so is the difference s (u_s - u_0) - s dt v - ... that makes the inertia.
  return 2 * std::numeric_limits<double>::epsilon() *
         (coefficient * (std::sqrt(squares[0]) + 2 * dt_ * std::sqrt(squares[1])) +
          model_.elastic_scale() * std::sqrt(squares[2]));
}

void StageProblem::clip(const std::vector<double>& base, std::vector<double>& guess) const {
  set_constraints(guess);
  if (!model_.has_interactions()) return;
  for (std::size_t i = 0; i < guess.size(); ++i) direction_[i] = guess[i] - base[i];
  const Segment at_base{nullptr, nullptr, base.data()};
  const double step = model_.admissible_step(at_base, end_rule(), direction_.data());
  if (step < 1)
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] = base[i] + step * direction_[i];
  set_constraints(guess);
}

bool StageProblem::residual(const Vector& x, Vector& f) {
  const TimedScope timed(Phase::Residual);
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  model_.space().import(x, u_.data());
  const double inverse = 1 / dt_;
  evaluate(stage_.inertia, u_, *from_, known_inertia_, bracket_);
  model_.mass().multiply(bracket_.data(), inertia_.data());
  for (std::size_t i = 0; i < owned; ++i) inertia_[i] *= inverse * inverse;

  bool admissible = model_.elastic_force(segment(stage_.elastic), stage_.elastic, elastic_.data());
  // Norms of the three parts and the number of ranks where some part is inadmissible.
  double sums[4] = {square_sum(inertia_, owned), square_sum(elastic_, owned), 0, 0};
  if (model_.has_interactions()) {
    admissible =
        model_.interaction_force(segment(stage_.interaction), stage_.interaction, interaction_.data()) && admissible;
    sums[2] = square_sum(interaction_, owned);
  }
  sums[3] = admissible ? 0 : 1;
  model_.space().sum(sums, 4);
  if (sums[3] > 0 || !std::isfinite(sums[0] + sums[1] + sums[2])) return false;
  scale_ = std::sqrt(std::max({sums[0], sums[1], sums[2]}));

  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  double* out = view.data();
  for (std::size_t i = 0; i < owned; ++i) out[i] = inertia_[i] + elastic_[i] + kept_[i];
  if (model_.has_interactions())
    for (std::size_t i = 0; i < owned; ++i) out[i] += interaction_[i];
  if (model_.damping() != nullptr) {
    evaluate(stage_.damping, u_, *from_, known_damping_, bracket_);
    model_.damping()->multiply_add(inverse, bracket_.data(), out);
  }
  for (const Constraint& c : model_.constraints()) {
    const auto dof = static_cast<std::size_t>(c.dof);
    if (dof < owned) out[dof] = diagonal_ * (u_[dof] - c.displacement - c.velocity * stage_time_);
  }
  return true;
}

void StageProblem::tangent(const Vector& x, CrsMatrix& w) {
  const TimedScope timed(Phase::Tangent);
  model_.space().import(x, u_.data());
  const auto matrix = w.getLocalMatrixHost();
  double* values = matrix.values.data();
  std::fill_n(values, matrix.values.extent(0), 0.0);
  model_.mass().add_to(stage_.inertia.unknown / (dt_ * dt_), values);
  if (model_.damping() != nullptr) model_.damping()->add_to(stage_.damping.unknown / dt_, values);
  model_.add_elastic_tangent(segment(stage_.elastic), stage_.elastic, values);
  model_.add_interaction_tangent(segment(stage_.interaction), stage_.interaction, values);
  model_.constrain_matrix(diagonal_, values);
}

double StageProblem::admissible_step(const Vector& x, const Vector& direction) {
  if (!model_.has_interactions()) return 1.0;
  model_.space().import(x, u_.data());
  model_.space().import(direction, direction_.data());
  return model_.admissible_step(segment(stage_.interaction), stage_.interaction, direction_.data());
}

double StageProblem::convergence_bound(double relative_tolerance) const {
  return std::max(relative_tolerance * scale_, rounding_);
}

}  // namespace ixos

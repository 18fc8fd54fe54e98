// The tangent of a stage's residual.
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>

#include "base/phase_timer.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

void StageProblem::relax_tangent(int level) {
  if (level != relaxation_) tangent_at_.clear();
  relaxation_ = level;
}

void StageProblem::assemble(double* values) const {
  const auto d = static_cast<std::size_t>(model_.mesh().dimension);
  if (has_mass_)
    model_.mass()->set(stage_->inertia.unknown / (dt_ * dt_), values);
  else
    std::fill_n(values, static_cast<std::size_t>(model_.pattern().pairs()) * d * d, 0.0);
  model_.add_rate_tangent(u_.data(), values);
  const auto add = [&](Part part, const Rule& rule, Tangent kind) {
    if (kept_of_ == stage_)
      model_.add_kept_tangent(part, segment(rule), rule, kind, kept_points_, values);
    else
      model_.add_tangent(part, segment(rule), rule, kind, values);
  };
  add(Part::Elastic, stage_->elastic, Tangent::Exact);
  add(Part::Interaction, stage_->interaction, tangent_kind());
  if (relaxation_ > 1) model_.add_to_diagonal(shift(), values);
}

Tangent StageProblem::tangent_kind() const { return relaxation_ == 0 ? Tangent::Exact : Tangent::Convex; }

double StageProblem::shift() const {
  return relaxation_ > 1 ? model_.elastic_scale() * std::pow(10.0, relaxation_ - 8) : 0;
}

void StageProblem::linearize() {
  TangentPoint point;
  point.elastic = segment(stage_->elastic);
  point.interaction = segment(stage_->interaction);
  point.elastic_rule = &stage_->elastic;
  point.interaction_rule = &stage_->interaction;
  point.kind = tangent_kind();
  point.mass = has_mass_ ? stage_->inertia.unknown / (dt_ * dt_) : 0;
  point.damping = stage_->damping.unknown / dt_;
  point.shift = shift();
  point.constrained_diagonal = diagonal_;
  matrix_free_->linearize(point);
}

Teuchos::RCP<Operator> StageProblem::create_operator() {
  if (nonnull(matrix_free_)) return matrix_free_;
  return model_.pattern().create_matrix(model_.space());
}

/// Returns whether u_ is x, on all ranks, so that its ghosts need no exchange.
bool StageProblem::is_at(const Vector& x) const {
  if (imported_for_ != stage_) return false;
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  bool same = true;
  for (std::size_t i = 0; i < view.extent(0); ++i) same = same && view(i, 0) == u_[i];
  return model_.space().minimum(same ? 1 : 0) > 0;
}

void StageProblem::tangent(const Vector& x, Operator& w) {
  const TimedScope timed(Phase::Tangent);
  if (!is_at(x)) {
    model_.space().import(x, u_.data());
    residual_of_ = kept_of_ = imported_for_ = nullptr;
  }
  const bool known = u_ == tangent_at_;
  if (nonnull(matrix_free_)) {
    if (!known) linearize();
    tangent_at_ = u_;
    return;
  }
  const auto matrix = dynamic_cast<CrsMatrix&>(w).getLocalMatrixHost();
  double* values = matrix.values.data();
  if (known) {
    std::copy(values_.begin(), values_.end(), values);
  } else {
    assemble(values);
  }
  model_.constrain_matrix(diagonal_, values);
}

}  // namespace ixos

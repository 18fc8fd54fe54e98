// The tangent of a stage's residual.
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/phase_timer.hpp"
#include "solve/bordered/bordered_operator.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

void StageProblem::relax_tangent(int level) { relaxation_ = level; }

void StageProblem::assemble(double* values) const {
  balance_.tangent(tangent_point(), weights(), tangent_kind(), at_u_.kept == arm_ ? &kept_points_ : nullptr, values);
}

void StageProblem::begin_solve() {
  if (!mixed_) return;
  iterates_ = {};
  iterates_.last = start_->u;
  tangent_at_ = {};
}

/// Takes u_ as Newton's iterate.
void StageProblem::take_iterate() {
  const bool same = iterates_.number > 0 && iterates_.last == u_;
  iterates_.is_last = true;
  if (model_.space().minimum(same ? 1 : 0) == 0) {
    iterates_.before = std::exchange(iterates_.last, u_);
    ++iterates_.number;
  }
  iterates_.are_used = tangent_point().elastic.iterate != nullptr;
}

void StageProblem::leave_mixed_steps(bool again) {
  iterates_ = {};
  iterates_.number = 2;
  iterates_.are_left = !again;
  tangent_at_ = {};
}

/// Returns where the tangent of the stage is taken. A strongly relaxed tangent is that of the force alone.
BalancePoint StageProblem::tangent_point() const {
  BalancePoint at = point();
  if (!mixed_ || iterates_.are_left || relaxation_ > 1) return at;
  // On the way to prescribed values, residual() takes a tangent before Newton's method does.
  const std::vector<double>& before = iterates_.is_last ? iterates_.before : iterates_.last;
  if (before.empty()) return at;
  at.elastic.iterate = before.data();
  if (iterates_.number == (iterates_.is_last ? 1 : 0)) at.elastic.way = 0;
  return at;
}

Tangent StageProblem::tangent_kind() const { return relaxation_ == 0 ? Tangent::Exact : Tangent::Convex; }

double StageProblem::shift() const {
  return relaxation_ > 1 ? model_.scales().elastic * std::pow(10.0, relaxation_ - 8) : 0;
}

bool StageProblem::has_tangent() const {
  return tangent_at_.arm == arm_ && tangent_at_.relaxation == relaxation_ && tangent_at_.u == u_;
}

void StageProblem::linearize() {
  matrix_free_->linearize(tangent_point(), weights(), tangent_kind(), diagonal_);
  tangent_at_ = {u_, arm_, relaxation_};
}

Teuchos::RCP<Operator> StageProblem::create_operator() {
  Teuchos::RCP<Operator> nodal = matrix_free_;
  if (nodal.is_null()) nodal = model_.pattern().create_matrix(model_.space());
  if (!is_bordered()) return nodal;
  return Teuchos::rcp(new BorderedOperator(nodal, model_.space()));
}

/// Returns whether u_ is x, on all ranks, so that its ghosts need no exchange.
bool StageProblem::is_at(const Vector& x) const {
  if (at_u_.imported != arm_) return false;
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  bool same = true;
  for (std::size_t i = 0; i < view.extent(0); ++i) {
    if (grips_ && i < owned && grips_->carries(i)) continue;  // x has what the guess had
    same = same && view(i, 0) == (i < owned ? u_[i] : u_[model_.space().place_of_free(i - owned)]);
  }
  return model_.space().minimum(same ? 1 : 0) > 0;
}

void StageProblem::tangent(const Vector& x, Operator& w) {
  const TimedScope timed(Phase::Tangent);
  if (!is_at(x)) move_to(x);
  if (mixed_ && !iterates_.are_left) take_iterate();
  auto* const bordered = dynamic_cast<BorderedOperator*>(&w);
  if (nonnull(matrix_free_)) {
    if (!has_tangent()) linearize();
    if (bordered != nullptr) take_border(*bordered, nullptr);
    return;
  }
  Operator& nodal = bordered != nullptr ? *bordered->nodal() : w;
  const auto matrix = dynamic_cast<CrsMatrix&>(nodal).getLocalMatrixHost();
  double* values = matrix.values.data();
  if (has_tangent()) {
    std::copy(values_.begin(), values_.end(), values);
  } else {
    assemble(values);
  }
  if (bordered != nullptr) take_border(*bordered, values);
  if (!model_.constraints().empty()) model_.constrained_entries().constrain(diagonal_, values);
}

}  // namespace ixos

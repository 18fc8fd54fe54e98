// The prescribed degrees of freedom of a stage: their rows, and the way to their values.
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>

#include "time/stage_problem.hpp"

namespace ixos {

/// Returns whether a value is reached, up to the rounding errors of Newton's steps.
bool StageProblem::is_reached(std::size_t dof, double value) const {
  const double target = prescribed_[dof];
  return std::abs(value - target) <= 1e-10 * std::abs(target - start_->u[dof]) + 1e-15 * std::abs(target);
}

double StageProblem::way_left(const Vector& x) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  double sum = 0;
  for (int dof : model_.constraints().prescribed()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < owned && !is_reached(i, view(i, 0))) sum += (view(i, 0) - prescribed_[i]) * (view(i, 0) - prescribed_[i]);
  }
  model_.space().sum(&sum, 1);
  return sum;
}

void StageProblem::complete_direction(const Vector& x, Vector& direction) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto to = direction.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int dof : model_.constraints().prescribed()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < owned) to(i, 0) = prescribed_[i] - from(i, 0);
  }
  const NodePlanes& planes = model_.constraints().planes();
  planes.project(to.data(), model_.mesh().owned_nodes);
  planes.add_across(-1, from.data(), to.data(), model_.mesh().owned_nodes);
}

void StageProblem::constrain_residual(double* out) {
  if (model_.constraints().empty()) return;
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::fill(reaction_.begin(), reaction_.end(), 0.0);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    bracket_[i] = u_[i] - prescribed_[i];
    if (i < owned) reaction_[i] = out[i];
  }
  const NodePlanes& planes = model_.constraints().planes();
  planes.add_across(1, out, reaction_.data(), model_.mesh().owned_nodes);
  if (moving_) {
    if (nonnull(matrix_free_)) {
      linearize();
      matrix_free_->multiply_constrained_columns(bracket_.data(), product_.data());
    } else {
      values_.resize(model_.pattern().values());
      assemble(values_.data());
      tangent_at_ = {u_, arm_, relaxation_};
      model_.constrained_entries().multiply(values_.data(), bracket_.data(), product_.data());
    }
    for (std::size_t i = 0; i < owned; ++i) out[i] -= product_[i];
  }
  planes.project(out, model_.mesh().owned_nodes);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < owned) out[i] = diagonal_ * bracket_[i];
  }
}

}  // namespace ixos

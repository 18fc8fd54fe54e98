// The part of a stage that is no node's: the balance of rigid bodies, and the border of the tangent.
#include <algorithm>
#include <cmath>

#include "solve/bordered/bordered_operator.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

/// Sums the forces on globals over ranks, those of the last Balance::sum() and inertia, and takes them to the scale.
void StageProblem::sum_globals() {
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  const std::size_t count = globals_.size();
  const std::vector<double>& interaction = balance_.force(Part::Interaction);
  std::vector<double> sums(balance_.global_forces());
  if (!load_.empty()) bodies_->add_moments(u_.data(), load_.data(), sums.data());
  sums.resize(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!interaction.empty()) sums[count + i] = interaction[first + i];
    sums[2 * count + i] = balance_.force(Part::Elastic)[first + i];  // of springs
    if (!load_.empty()) sums[3 * count + i] = load_[first + i];
  }
  model_.space().sum(sums.data(), static_cast<int>(sums.size()));
  globals_.assign(count, 0.0);
  bodies_->add_inertia(u_.data(), bracket_.data(), globals_.data());
  double squares[4] = {};  // of inertia, and of those three
  for (const int global : model_.space().globals().free) {
    const auto i = static_cast<std::size_t>(global);
    squares[0] += globals_[i] * globals_[i];
    for (std::size_t k = 1; k < 4; ++k) squares[k] += sums[k * count + i] * sums[k * count + i];
  }
  scale_ = std::max(scale_, std::sqrt(*std::max_element(squares, squares + 4)));
  rounding_here_ += rounding_error_ * std::sqrt(squares[2]);
  for (std::size_t i = 0; i < count; ++i) globals_[i] += sums[i];
}

/// Sets the border at the last tangent, without what the constraints take out.
void StageProblem::find_border() {
  border_.clear();
  for (const NamedForceTerm& named : model_.force_terms()) named.term->add_border(border_);
  for (const RateTerm* const term : model_.rate_terms()) term->add_border(border_);
}

/// Moves the forces on globals along the last tangent to the prescribed values, as constrain_residual() does those on
/// nodes; `missing`: local, the way beyond these values.
void StageProblem::move_globals(const std::vector<double>& missing) {
  find_border();
  const std::vector<int>& free = model_.space().globals().free;
  std::vector<double> change(free.size(), 0.0);
  for (std::size_t k = 0; k < free.size(); ++k)
    for (const int dof : model_.constraints().dofs())
      change[k] += border_.rows()[k][static_cast<std::size_t>(dof)] * missing[static_cast<std::size_t>(dof)];
  model_.space().sum(change.data(), static_cast<int>(change.size()));
  for (std::size_t k = 0; k < free.size(); ++k) globals_[static_cast<std::size_t>(free[k])] -= change[k];
}

/// Returns this rank's share of the bodies' part of potential().
Potential StageProblem::globals_potential(const std::vector<double>& u, const std::vector<double>& bracket) const {
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  Potential sum;
  const auto add = [&sum](double value) {
    sum.value += value;
    sum.magnitude += std::abs(value);
  };
  for (std::size_t i = first; i < u.size(); ++i) add(kept_[i] * (u[i] - start_->u[i]));
  if (!load_.empty()) add(bodies_->moment_potential(u.data(), load_.data()));
  if (!has_mass_ || model_.space().comm()->getRank() > 0) return sum;
  std::vector<double> forces(globals_.size(), 0.0);
  bodies_->add_inertia(u.data(), bracket.data(), forces.data());
  for (std::size_t i = 0; i < forces.size(); ++i) add(forces[i] * bracket[first + i] / (2 * stage_->inertia.unknown));
  return sum;
}

/// Adds the forces on carried nodes, which are among the reactions, to those on the bodies.
void StageProblem::add_grip_forces() {
  std::vector<double> sums(globals_.size(), 0.0);
  grips_->add_forces(u_.data(), reaction_.data(), sums.data());
  model_.space().sum(sums.data(), static_cast<int>(sums.size()));
  for (std::size_t i = 0; i < sums.size(); ++i) globals_[i] += sums[i];
}

/// Sets the border at the last tangent, whose values are given before the constraints take rows and columns out.
void StageProblem::take_border(BorderedOperator& w, const double* values) {
  find_border();
  if (grips_) grips_->add_columns(u_.data(), values, border_);
  if (model_.space().comm()->getRank() == 0) bodies_->add_inertia(u_.data(), border_);
  if (!load_.empty()) bodies_->add_moments(u_.data(), load_.data(), border_);
  const NodePlanes& planes = model_.constraints().planes();
  for (std::vector<double>& column : border_.columns()) model_.space().condense(column.data());
  if (grips_) grips_->add_rows(u_.data(), reaction_.data(), values, border_);
  for (auto* const arrays : {&border_.columns(), &border_.rows()})
    for (std::vector<double>& array : *arrays) {
      planes.project(array.data(), model_.mesh().nodes());
      for (const int dof : model_.constraints().dofs()) array[static_cast<std::size_t>(dof)] = 0;
    }
  w.set_border(border_);
}

}  // namespace ixos

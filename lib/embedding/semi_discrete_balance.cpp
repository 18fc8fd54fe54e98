#include "embedding/semi_discrete_balance.hpp"

#include <Tpetra_Vector.hpp>
#include <algorithm>

#include "base/error.hpp"
#include "model/traits.hpp"

namespace ixos {

SemiDiscreteBalance::SemiDiscreteBalance(const Model& model)
    : model_(model), balance_(model), histories_(model.create_histories()) {
  if (model.space().has_globals())
    throw InputError(
        "the semi-discrete balance has no equations for rigid bodies; integrate the model with Integrator");
  const auto local = static_cast<std::size_t>(model.space().local());
  for (std::vector<double>* array : {&u_, &v_, &a_, &part_, &sum_}) array->resize(local);
}

void SemiDiscreteBalance::set(const MotionState& state) {
  state_ = state;
  has_velocity_ = has_acceleration_ = has_forces_ = has_sum_ = false;
  model_.space().import(*state.u, u_.data());
}

bool SemiDiscreteBalance::admissible() {
  const bool moved = state_.time != judged_time_ && has_moved_obstacles(model_);
  if (!has_forces_ && (u_ != judged_ || moved)) evaluate_forces();
  return model_.space().minimum(verdict_ ? 1 : 0) > 0;
}

/// Returns where the balance is taken, with the inertia and the rates that the state has.
BalancePoint SemiDiscreteBalance::point() {
  const Segment here = segment_at(place());
  BalancePoint point{here, here, &rule_, &rule_};
  if (state_.a != nullptr && model_.mass() != nullptr) point.acceleration = acceleration().data();
  if (state_.v == nullptr) return point;
  point.rates = Rates::State;
  point.velocity = velocity().data();
  return point;
}

/// Without communication: ranks come here for a u of their own.
void SemiDiscreteBalance::evaluate_forces() {
  const Segment here = segment_at({u_.data(), state_.time, &histories_});
  verdict_ = balance_.evaluate(Part::Elastic, here, rule_);
  verdict_ = balance_.evaluate(Part::Interaction, here, rule_) && verdict_;
  judged_ = u_;
  judged_time_ = state_.time;
  has_forces_ = true;
}

const std::vector<double>& SemiDiscreteBalance::acceleration() {
  if (!has_acceleration_) model_.space().import(*state_.a, a_.data());
  has_acceleration_ = true;
  return a_;
}

const std::vector<double>& SemiDiscreteBalance::velocity() {
  if (!has_velocity_ && state_.v != nullptr) model_.space().import(*state_.v, v_.data());
  if (!has_velocity_ && state_.v == nullptr) std::fill(v_.begin(), v_.end(), 0.0);
  has_velocity_ = true;
  return v_;
}

const std::vector<double>& SemiDiscreteBalance::force(NodalForce part) {
  if (part == NodalForce::Elastic || part == NodalForce::Interaction) {
    if (!has_forces_) evaluate_forces();
    return balance_.force(part == NodalForce::Elastic ? Part::Elastic : Part::Interaction);
  }
  std::fill(part_.begin(), part_.end(), 0.0);
  const TermSums& terms = balance_.sums();
  if (part == NodalForce::Inertia && state_.a != nullptr && model_.mass() != nullptr)
    model_.mass()->multiply(acceleration().data(), part_.data());
  if (part == NodalForce::External) model_.loads().add_force(state_.time, 1.0, part_.data());
  if (part == NodalForce::Damping && state_.v != nullptr)
    terms.add_rate_force_at(1.0, u_.data(), velocity().data(), part_.data());
  return part_;
}

const std::vector<double>& SemiDiscreteBalance::sum() {
  if (has_sum_) return sum_;
  if (!has_forces_) evaluate_forces();
  std::fill(part_.begin(), part_.end(), 0.0);
  model_.loads().add_force(state_.time, -1.0, part_.data());
  const BalancePoint here = point();
  balance_.evaluate_inertia(here);
  balance_.sum(here, part_.data(), sum_.data());
  has_sum_ = true;
  return sum_;
}

void SemiDiscreteBalance::residual(Vector& f) {
  const std::vector<double>& all = sum();
  model_.constraints().set(state_.time, part_.data(), nullptr, nullptr);
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(all.data(), view.extent(0), view.data());
  const NodePlanes& planes = model_.constraints().planes();
  planes.project(view.data(), model_.mesh().owned_nodes);
  planes.add_across(1, u_.data(), view.data(), model_.mesh().owned_nodes);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < view.extent(0)) view(i, 0) = u_[i] - part_[i];
  }
}

}  // namespace ixos

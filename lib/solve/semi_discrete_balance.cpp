#include "solve/semi_discrete_balance.hpp"

#include <Tpetra_Vector.hpp>
#include <algorithm>

namespace ixos {
namespace {

void add(const std::vector<double>& part, std::size_t count, std::vector<double>& sum) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += part[i];
}

}  // namespace

SemiDiscreteBalance::SemiDiscreteBalance(const Model& model) : model_(model) {
  const auto local = static_cast<std::size_t>(model.space().local());
  for (std::vector<double>* array : {&u_, &v_, &a_, &elastic_, &interaction_, &part_, &sum_}) array->resize(local);
}

void SemiDiscreteBalance::set(const MotionState& state) {
  state_ = state;
  model_.set_time(state.time);  // of the responses
  has_velocity_ = has_forces_ = has_sum_ = false;
  model_.space().import(*state.u, u_.data());
}

bool SemiDiscreteBalance::admissible() {
  const bool moved = state_.time != judged_time_ && model_.has_moved_obstacles();
  if (!has_forces_ && (u_ != judged_ || moved)) evaluate_forces();
  return model_.space().minimum(verdict_ ? 1 : 0) > 0;
}

void SemiDiscreteBalance::evaluate_forces() {
  const Segment here{nullptr, nullptr, u_.data(), state_.time};
  verdict_ = model_.force(Part::Elastic, here, end_rule(), elastic_.data());
  if (model_.has_interactions())
    verdict_ = model_.force(Part::Interaction, here, end_rule(), interaction_.data()) && verdict_;
  judged_ = u_;
  judged_time_ = state_.time;
  has_forces_ = true;
}

const std::vector<double>& SemiDiscreteBalance::velocity() {
  if (!has_velocity_ && state_.v != nullptr) model_.space().import(*state_.v, v_.data());
  if (!has_velocity_ && state_.v == nullptr) std::fill(v_.begin(), v_.end(), 0.0);
  has_velocity_ = true;
  return v_;
}

/// Sets part_ = M x; 0 without inertia.
void SemiDiscreteBalance::multiply_mass(const Vector* x) {
  std::fill(part_.begin(), part_.end(), 0.0);
  if (x == nullptr || model_.mass() == nullptr) return;
  model_.space().import(*x, a_.data());
  model_.mass()->multiply(a_.data(), part_.data());
}

const std::vector<double>& SemiDiscreteBalance::force(NodalForce part) {
  if (part == NodalForce::Elastic || part == NodalForce::Interaction) {
    if (!has_forces_) evaluate_forces();
    return part == NodalForce::Elastic ? elastic_ : interaction_;
  }
  if (part == NodalForce::Inertia) {
    multiply_mass(state_.a);
    return part_;
  }
  std::fill(part_.begin(), part_.end(), 0.0);
  if (part == NodalForce::External) model_.loads().add_force(state_.time, 1.0, part_.data());
  if (part == NodalForce::Damping && state_.v != nullptr && model_.has_rates())
    model_.add_rate_force_at(1.0, u_.data(), velocity().data(), part_.data());
  return part_;
}

const std::vector<double>& SemiDiscreteBalance::sum() {
  if (has_sum_) return sum_;
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  sum_ = force(NodalForce::Elastic);
  if (model_.has_interactions()) add(force(NodalForce::Interaction), owned, sum_);
  if (state_.a != nullptr && model_.mass() != nullptr) add(force(NodalForce::Inertia), owned, sum_);
  if (state_.v != nullptr && model_.has_rates()) add(force(NodalForce::Damping), owned, sum_);
  model_.loads().add_force(state_.time, -1.0, sum_.data());
  has_sum_ = true;
  return sum_;
}

void SemiDiscreteBalance::residual(Vector& f) {
  const std::vector<double>& all = sum();
  model_.constraints().set(state_.time, part_.data(), nullptr, nullptr);
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(all.data(), view.extent(0), view.data());
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < view.extent(0)) view(i, 0) = u_[i] - part_[i];
  }
}

}  // namespace ixos

#include "model/constraints.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"

namespace ixos {

void Constraints::check(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) const {
  if (!holds(dof)) return;
  const Entry& known = entries_[static_cast<std::size_t>(index_[dof_index(dof)])];
  if (motions_[known.motion] != motion || known.factor != factor)
    throw InputError("two conditions prescribe different motions for one degree of freedom");
}

void Constraints::add(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) {
  if (closed_)
    throw std::logic_error("a constraint is added after an integrator or an evaluator was made of the model");
  check(dof, factor, motion);
  if (holds(dof)) return;
  auto found = std::find(motions_.begin(), motions_.end(), motion);
  if (found == motions_.end()) found = motions_.insert(found, motion);
  if (index_.size() <= dof_index(dof)) index_.resize(dof_index(dof) + 1, -1);
  index_[dof_index(dof)] = static_cast<int>(entries_.size());
  dofs_.push_back(dof);
  entries_.push_back({static_cast<std::size_t>(found - motions_.begin()), factor});
  driven_ = driven_ || motion != nullptr;
}

void Constraints::set(double time, double* u, double* v, double* a) const {
  std::vector<TimeValue> values;
  values.reserve(motions_.size());
  for (const auto& motion : motions_) values.push_back(motion ? motion->at(time) : TimeValue{});
  for (std::size_t i = 0; i < dofs_.size(); ++i) {
    const TimeValue& value = values[entries_[i].motion];
    const double factor = entries_[i].factor;
    const std::size_t dof = dof_index(dofs_[i]);
    if (u != nullptr) u[dof] = factor * value.value;
    if (v != nullptr) v[dof] = factor * value.rate;
    if (a != nullptr) a[dof] = factor * value.acceleration;
  }
}

bool Constraints::are_finite(double time) const {
  return std::all_of(motions_.begin(), motions_.end(), [time](const auto& motion) {
    const TimeValue f = motion ? motion->at(time) : TimeValue{};
    return std::isfinite(f.value) && std::isfinite(f.rate) && std::isfinite(f.acceleration);
  });
}

}  // namespace ixos

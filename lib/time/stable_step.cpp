#include "time/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr int elastic_interval = 10;

}  // namespace

StableStep::StableStep(const Model& model, double safety) : model_(model), safety_(safety) {
  const auto local = static_cast<std::size_t>(model.space().local());
  elastic_.resize(local);
  sums_.resize(local);
  ahead_.resize(local);
}

/// Computes what changes slowly: the elastic row sums, and the largest quotient of rate terms and mass.
void StableStep::look_at(const std::vector<double>& u) {
  std::fill(elastic_.begin(), elastic_.end(), 0.0);
  model_.add_row_sums(Part::Elastic, {nullptr, nullptr, u.data()}, elastic_.data());
  if (!model_.has_rates()) return;
  std::fill(sums_.begin(), sums_.end(), 0.0);
  model_.add_rate_row_sums(u.data(), sums_.data());
  damping_ = model_.space().maximum(model_.mass()->largest_quotient(sums_.data()));
}

/// Returns the longest stable step [T0]; 0 if a gap is not positive.
double StableStep::limit(const std::vector<double>& u, double time) const {
  sums_ = elastic_;
  const Segment here{nullptr, nullptr, u.data(), time};
  if (!model_.add_row_sums(Part::Interaction, here, sums_.data())) return 0;
  const double w2 = model_.mass()->largest_quotient(sums_.data());
  return 2 / (std::sqrt(w2 + damping_ * damping_) + damping_);
}

void StableStep::transfer(Record& record) {
  record.number("age", age_);
  record.field("elastic row sums", elastic_, Extent::Local);
  record.number("damping quotient", damping_);
  if (!(damping_ >= 0)) throw InputError("\"damping quotient\" is less than 0");
  if (age_ < 0 || elastic_.size() != sums_.size())
    throw InputError("\"elastic row sums\" is empty, or its age is negative");
}

double StableStep::operator()(const State& state, double time, double wanted) {
  if (age_ == 0) look_at(state.u);
  age_ = (age_ + 1) % elastic_interval;
  double step = std::min(wanted, safety_ * model_.space().minimum(limit(state.u, time)));
  if (!model_.has_interactions()) return step;
  // The bound at the end of the step. A shorter step leads less far, so that bound holds for it too.
  for (int halving = 0; halving < 60; ++halving) {
    for (std::size_t i = 0; i < ahead_.size(); ++i)
      ahead_[i] = state.u[i] + step * (state.v[i] + step / 2 * state.a[i]);
    const double there = safety_ * model_.space().minimum(limit(ahead_, time + step));
    if (there >= step) return step;
    step = std::max(there, step / 2);
  }
  return step;
}

}  // namespace ixos

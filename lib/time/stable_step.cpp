#include "time/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "model/term_sums.hpp"

namespace ixos {
namespace {

constexpr int elastic_interval = 10;

}  // namespace

StableStep::StableStep(const Model& model, double safety) : model_(model), safety_(safety) {
  const auto local = static_cast<std::size_t>(model.space().local());
  const double weights = model.space().ties().largest_magnitude();
  column_bound_ = model.mesh().global_tied > 0 ? model.space().maximum(weights) : 1;
  elastic_.resize(local);
  sums_.resize(local);
  ahead_.resize(local);
}

/// Computes what changes slowly: the elastic row sums, and the largest quotient of rate terms and mass.
void StableStep::look_at(const Place& at) {
  std::fill(elastic_.begin(), elastic_.end(), 0.0);
  const TermSums terms(model_);
  terms.add_row_sums(Part::Elastic, segment_at(at), elastic_.data());
  if (!terms.has_rates()) return;
  std::fill(sums_.begin(), sums_.end(), 0.0);
  terms.add_rate_row_sums(at.u, sums_.data());
  damping_ = model_.space().maximum(model_.mass()->largest_quotient(sums_.data())) * column_bound_;
}

/// Returns the longest stable step [T0]; 0 if a gap is not positive.
double StableStep::limit(const Place& at) const {
  sums_ = elastic_;
  if (!TermSums(model_).add_row_sums(Part::Interaction, segment_at(at), sums_.data())) return 0;
  const double w2 = model_.mass()->largest_quotient(sums_.data()) * column_bound_;
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

double StableStep::operator()(const State& state, double wanted) {
  if (age_ == 0) look_at(state.place());
  age_ = (age_ + 1) % elastic_interval;
  double step = std::min(wanted, safety_ * model_.space().minimum(limit(state.place())));
  if (!model_.has_interactions()) return step;
  // The bound at the end of the step. A shorter step leads less far, so that bound holds for it too.
  for (int halving = 0; halving < 60; ++halving) {
    for (std::size_t i = 0; i < ahead_.size(); ++i)
      ahead_[i] = state.u[i] + step * (state.v[i] + step / 2 * state.a[i]);
    const double there = safety_ * model_.space().minimum(limit({ahead_.data(), state.time + step, &state.histories}));
    if (there >= step) return step;
    step = std::max(there, step / 2);
  }
  return step;
}

}  // namespace ixos

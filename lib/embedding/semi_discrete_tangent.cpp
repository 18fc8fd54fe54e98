#include "embedding/semi_discrete_tangent.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <limits>
#include <stdexcept>

namespace ixos {
namespace {

BalancePoint point_at(const Place& at, const Rule& rule) {
  const Segment here = segment_at(at);
  return {here, here, &rule, &rule, nullptr, 1, Rates::State, at.v};
}

/// Sets the values to W, whose rule has the factor of the stiffness. Without stiffness no term is asked.
void set_values(const Model& model, const TangentWeights& weights, const Place& at, double* values) {
  const Rule rule = weights.stiffness != 0 ? end_rule(weights.stiffness) : Rule{};
  Balance(model).tangent(point_at(at, rule), weights, Tangent::Exact, nullptr, values);
}

}  // namespace

void set_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const Place& at, CrsMatrix& matrix) {
  const auto local = matrix.getLocalMatrixHost();
  if (local.values.extent(0) != model.pattern().matrix_values())
    throw std::logic_error("the operator is of another version of the discretization; create another one");
  set_values(model, weights, at, local.values.data());
}

SemiDiscreteOperator::SemiDiscreteOperator(const Model& model)
    : TangentOperator(model,
                      [this, &model](double* values) {
                        // Without viscosity, which has no action, the tangent does not depend on the velocity.
                        set_values(model, weights_, {u_.data(), time_, &histories_, nullptr, u_.data()}, values);
                        if (!model.constraints().empty())
                          model.constrained_entries().constrain(weights_.constrained(), values);
                      }),
      u_(static_cast<std::size_t>(model.space().local()), 0.0),
      histories_(model.create_histories()) {}

BalancePoint SemiDiscreteOperator::point() const { return point_at({u_.data(), time_, &histories_}, rule_); }

void SemiDiscreteOperator::linearize(const TangentWeights& weights, const Place& at) {
  weights_ = weights;
  u_.assign(at.u, at.u + u_.size());
  time_ = at.time;
  if (at.histories != nullptr) histories_ = *at.histories;
  rule_ = end_rule(weights.stiffness);
  TangentOperator::linearize(point(), weights_, Tangent::Exact, weights_.constrained());
}

void SemiDiscreteOperator::invalidate() {
  std::fill(u_.begin(), u_.end(), 0.0);
  rule_ = end_rule(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TangentWeights nowhere = weights_;
  nowhere.shift = nan;
  TangentOperator::linearize(point(), nowhere, Tangent::Exact, nan);
}

}  // namespace ixos

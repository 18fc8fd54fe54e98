#include "solve/semi_discrete_tangent.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <limits>
#include <stdexcept>

namespace ixos {

void add_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const std::vector<double>& u,
                               const std::vector<double>& v, double time, double* values) {
  if (weights.stiffness != 0) {
    const Segment here{nullptr, nullptr, u.data(), time};
    const Rule rule = end_rule(weights.stiffness);
    model.add_tangent(Part::Elastic, here, rule, Tangent::Exact, values);
    model.add_tangent(Part::Interaction, here, rule, Tangent::Exact, values);
  }
  if (model.mass() != nullptr && weights.mass != 0) model.mass()->add_to(weights.mass, values);
  model.add_rate_tangent_at(weights.damping, weights.stiffness, u.data(), v.data(), values);
}

void set_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const std::vector<double>& u,
                               const std::vector<double>& v, double time, CrsMatrix& matrix) {
  const auto local = matrix.getLocalMatrixHost();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  if (local.values.extent(0) != static_cast<std::size_t>(model.pattern().pairs()) * d * d)
    throw std::logic_error("the operator is of another version of the discretization; create another one");
  std::fill_n(local.values.data(), local.values.extent(0), 0.0);
  add_semi_discrete_tangent(model, weights, u, v, time, local.values.data());
}

SemiDiscreteOperator::SemiDiscreteOperator(const Model& model)
    : TangentOperator(model,
                      [this, &model](double* values) {
                        // Without viscosity, which has no action, the tangent does not depend on the velocity.
                        add_semi_discrete_tangent(model, weights_, u_, u_, time_, values);
                        model.constrain_matrix(weights_.constrained(), values);
                      }),
      u_(static_cast<std::size_t>(model.space().local()), 0.0) {}

TangentPoint SemiDiscreteOperator::point() const {
  TangentPoint point;
  point.elastic = point.interaction = Segment{nullptr, nullptr, u_.data(), time_};
  point.elastic_rule = point.interaction_rule = &rule_;
  point.mass = weights_.mass;
  point.damping = weights_.damping;
  point.constrained_diagonal = weights_.constrained();
  return point;
}

void SemiDiscreteOperator::linearize(const TangentWeights& weights, const std::vector<double>& u, double time) {
  weights_ = weights;
  u_ = u;
  time_ = time;
  rule_ = end_rule(weights.stiffness);
  TangentOperator::linearize(point());
}

void SemiDiscreteOperator::invalidate() {
  std::fill(u_.begin(), u_.end(), 0.0);
  rule_ = end_rule(0);
  TangentPoint nowhere = point();
  nowhere.shift = nowhere.constrained_diagonal = std::numeric_limits<double>::quiet_NaN();
  TangentOperator::linearize(nowhere);
}

}  // namespace ixos

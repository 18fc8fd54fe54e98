#include "balance/tangent_operator.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>

#include "base/error.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"

namespace ixos {
namespace {

/// Sets K_ii of nodes in planes to that of P K P + factor (I - P), see NodePlanes, of a K without other entries.
void project_diagonal(const Model& model, double factor, double* diagonal) {
  const NodePlanes& planes = model.constraints().planes();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  planes.for_each([&](int node) {
    if (node >= model.mesh().owned_nodes) return;
    double* const k = diagonal + static_cast<std::size_t>(node) * d;
    Vec<3> result{};
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) {
        double across = 0;
        for (const Vec<3>& normal : planes.normals(node)) across += normal[i] * normal[j];
        const double inside = (i == j ? 1 : 0) - across;
        result[i] += inside * inside * k[j] + (i == j ? factor * across : 0);
      }
    std::copy_n(result.begin(), d, k);
  });
}

}  // namespace

TangentOperator::TangentOperator(const Model& model, std::function<void(double*)> assemble)
    : model_(model),
      assemble_(std::move(assemble)),
      elastic_(TermSums(model).actions(Part::Elastic)),
      interactions_(TermSums(model).actions(Part::Interaction)),
      mass_in_elastic_(model.mass() != nullptr && !model.mass()->is_lumped()) {
  bool possible = TermSums(model).has_diagonal_rates();
  for (const auto* actions : {&elastic_, &interactions_})
    possible = possible && std::all_of(actions->begin(), actions->end(), [](const auto& action) { return !!action; });
  if (!possible)
    throw InputError(
        "Linear Solver/Operator: \"Matrix-Free\" is not offered for the model's viscosity, element formulation, "
        "axial symmetry or friction with a current threshold; use \"Assembled\"");
  for (const auto& action : elastic_) mass_in_elastic_ = mass_in_elastic_ && action->applies_mass();
  for (std::vector<double>* array : {&x_, &result_, &part_})
    array->resize(static_cast<std::size_t>(model.space().local()));
}

void TangentOperator::linearize(const BalancePoint& at, const TangentWeights& weights, Tangent kind,
                                double constrained) {
  std::vector<LinearPart> linear = TermSums(model_).linear_parts(weights.mass, weights.damping);
  linear.resize(elastic_.size());  // springs have none
  for (std::size_t i = 0; i < elastic_.size(); ++i) {
    if (!mass_in_elastic_) linear[i].inertia = 0;
    elastic_[i]->linearize(at.elastic, *at.elastic_rule, kind, linear[i]);
  }
  for (const auto& action : interactions_) action->linearize(at.interaction, *at.interaction_rule, kind, {});
  mass_ = weights.mass;
  damping_ = weights.damping;
  rates_ = TermSums(model_).rate_diagonal(damping_);
  shift_ = weights.shift;
  constrained_diagonal_ = constrained;
  assembled_ = false;
}

void TangentOperator::multiply(const double* x) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::fill(result_.begin(), result_.end(), 0.0);
  for (const auto& action : elastic_)
    if (precision_ == Precision::Single)
      action->add_rough_product(x, result_.data());
    else
      action->add_product(x, result_.data());
  for (const auto& action : interactions_) action->add_product(x, result_.data());
  model_.space().condense(result_.data());
  if (!mass_in_elastic_) add_mass(x);
  if (shift_ != 0)
    for (std::size_t i = 0; i < owned; ++i) result_[i] += shift_ * x[i];
  if (!rates_.empty())
    for (std::size_t i = 0; i < owned; ++i) result_[i] += rates_[i] * x[i];
}

/// Adds the mass and the damping's part of it, times x, to result_.
void TangentOperator::add_mass(const double* x) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  if (model_.mass() != nullptr && mass_ != 0) {
    model_.mass()->multiply(x, part_.data());
    for (std::size_t i = 0; i < owned; ++i) result_[i] += mass_ * part_[i];
  }
  if (model_.damping() != nullptr) model_.damping()->multiply_add_mass(damping_, x, result_.data());
}

void TangentOperator::apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  for (std::size_t j = 0; j < x.getNumVectors(); ++j) {
    model_.space().import(*x.getVector(j), x_.data());
    for (int dof : model_.constraints().dofs()) x_[static_cast<std::size_t>(dof)] = 0;
    const NodePlanes& planes = model_.constraints().planes();
    planes.project(x_.data(), model_.mesh().nodes());
    if (!model_.constraints().empty()) model_.space().interpolate_tied(x_.data());
    multiply(x_.data());
    const auto from = x.getVector(j)->getLocalViewHost(Tpetra::Access::ReadOnly);
    planes.project(result_.data(), model_.mesh().owned_nodes);
    planes.add_across(constrained_diagonal_, from.data(), result_.data(), model_.mesh().owned_nodes);
    for (int dof : model_.constraints().dofs()) {
      const auto i = static_cast<std::size_t>(dof);
      if (i < owned) result_[i] = constrained_diagonal_ * from(i, 0);
    }
    const auto target = y.getVectorNonConst(j)->getLocalViewHost(Tpetra::Access::ReadWrite);
    if (beta == 0)
      for (std::size_t i = 0; i < owned; ++i) target(i, 0) = alpha * result_[i];
    else
      for (std::size_t i = 0; i < owned; ++i) target(i, 0) = alpha * result_[i] + beta * target(i, 0);
  }
}

void TangentOperator::multiply_constrained_columns(const double* x, double* result) const {
  std::fill(x_.begin(), x_.end(), 0.0);
  for (int dof : model_.constraints().dofs()) x_[static_cast<std::size_t>(dof)] = x[dof];
  model_.space().interpolate_tied(x_.data());
  multiply(x_.data());
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::copy_n(result_.begin(), owned, result);
  for (int dof : model_.constraints().dofs())
    if (static_cast<std::size_t>(dof) < owned) result[dof] = 0;
  model_.constraints().planes().project(result, model_.mesh().owned_nodes);
}

void TangentOperator::diagonal(Vector& result) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::fill(result_.begin(), result_.end(), 0.0);
  for (const auto& action : elastic_) action->add_diagonal(result_.data());
  for (const auto& action : interactions_) action->add_diagonal(result_.data());
  model_.space().ties().condense_diagonal(result_.data(), static_cast<std::size_t>(model_.mesh().dimension));
  if (model_.mass() != nullptr) model_.mass()->add_diagonal(mass_, result_.data());
  if (model_.damping() != nullptr) model_.damping()->add_mass_diagonal(damping_, result_.data());
  if (!rates_.empty())
    for (std::size_t i = 0; i < owned; ++i) result_[i] += rates_[i];
  for (std::size_t i = 0; i < owned; ++i) result_[i] += shift_;
  for (int dof : model_.constraints().dofs()) result_[static_cast<std::size_t>(dof)] = constrained_diagonal_;
  project_diagonal(model_, constrained_diagonal_, result_.data());
  const auto target = result.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < owned; ++i) target(i, 0) = result_[i];
}

Teuchos::RCP<CrsMatrix> TangentOperator::matrix() const {
  if (matrix_.is_null()) matrix_ = model_.pattern().create_matrix(model_.space());
  if (!assembled_) {
    const auto values = matrix_->getLocalMatrixHost().values;
    std::fill_n(values.data(), values.extent(0), 0.0);
    assemble_(values.data());
    assembled_ = true;
  }
  return matrix_;
}

const CoarseSpace& TangentOperator::coarse_space() const {
  if (coarse_space_) return *coarse_space_;
  const ProblemSize size = problem_size(model_);
  require_coarse_cells(size);
  require_coarse_terms(size);
  coarse_space_ = std::make_unique<CoarseSpace>(model_.mesh(), model_.space(), model_.constraints().dofs());
  return *coarse_space_;
}

Teuchos::RCP<CrsMatrix> TangentOperator::coarse_matrix() const {
  const CoarseSpace& coarse = coarse_space();
  std::fill(result_.begin(), result_.end(), 0.0);
  if (!mass_in_elastic_) {
    std::fill(x_.begin(), x_.end(), 1.0);
    add_mass(x_.data());  // its row sums
  }
  for (std::size_t i = 0; i < rates_.size(); ++i) result_[i] += rates_[i];
  for (double& entry : result_) entry += shift_;
  model_.space().update_ghosts(result_.data());
  // Tied nodes, the last ones, have no unknowns.
  if (const NodeTies& ties = model_.space().ties(); !ties.empty())
    std::fill(result_.begin() + std::ptrdiff_t{ties.first()} * model_.space().dimension(), result_.end(), 0.0);
  const auto add = [&](double* values) {
    for (const auto* actions : {&elastic_, &interactions_})
      for (const auto& action : *actions) action->add_coarse(coarse, values);
    coarse.add_diagonal(result_.data(), values);
  };
  return coarse.matrix(add, constrained_diagonal_);
}

}  // namespace ixos

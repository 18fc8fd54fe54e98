#include "solve/semi_discrete_evaluator.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <stdexcept>

namespace ixos {

using Base = Thyra::ModelEvaluatorBase;

SemiDiscreteEvaluator::SemiDiscreteEvaluator(const Model& model, Factory linear_solver)
    : model_(model), linear_solver_(std::move(linear_solver)), space_(vector_space(model.space().owned_map())) {
  Base::InArgsSetup<double> in;
  in.setModelEvalDescription("Ixos semi-discrete model");
  for (const auto argument : {Base::IN_ARG_x, Base::IN_ARG_x_dot, Base::IN_ARG_x_dot_dot, Base::IN_ARG_t,
                              Base::IN_ARG_alpha, Base::IN_ARG_beta, Base::IN_ARG_W_x_dot_dot_coeff})
    in.setSupports(argument);
  in_ = in;
  nominal_ = in_;
  const auto zero = Thyra::createMember(space_);
  Thyra::assign(zero.ptr(), 0.0);
  nominal_.set_x(zero);
  nominal_.set_x_dot(zero);
  nominal_.set_x_dot_dot(zero);
  nominal_.set_t(0.0);
  nominal_.set_alpha(0.0);
  nominal_.set_beta(1.0);
  nominal_.set_W_x_dot_dot_coeff(0.0);
  Base::OutArgsSetup<double> out;
  out.setModelEvalDescription("Ixos semi-discrete model");
  out.setSupports(Base::OUT_ARG_f);
  out.setSupports(Base::OUT_ARG_W_op);
  out_ = out;
  for (std::vector<double>* array : {&u_, &rate_, &part_, &sum_})
    array->resize(static_cast<std::size_t>(model_.space().local()));
}

Teuchos::RCP<Thyra::LinearOpBase<double>> SemiDiscreteEvaluator::create_W_op() const {
  return linear_op(model_.pattern().create_matrix(model_.space()), space_);
}

void SemiDiscreteEvaluator::evalModelImpl(const Base::InArgs<double>& in, const Base::OutArgs<double>& out) const {
  model_.space().import(*Extract::getConstTpetraVector(in.get_x()), u_.data());
  const auto f = out.get_f();
  if (nonnull(f) && !evaluate_force(in, *Extract::getTpetraVector(f))) out.setFailed();
  const auto w = out.get_W_op();
  if (nonnull(w)) evaluate_tangent(in, *Teuchos::rcp_dynamic_cast<CrsMatrix>(Extract::getTpetraOperator(w), true));
}

bool SemiDiscreteEvaluator::evaluate_force(const Base::InArgs<double>& in, Vector& f) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const Segment here{nullptr, nullptr, u_.data()};
  bool admissible = model_.force(Part::Elastic, here, end_rule(), sum_.data());
  if (model_.has_interactions()) {
    admissible = model_.force(Part::Interaction, here, end_rule(), part_.data()) && admissible;
    for (std::size_t i = 0; i < owned; ++i) sum_[i] += part_[i];
  }
  if (nonnull(in.get_x_dot_dot()) && model_.mass() != nullptr) {
    model_.space().import(*Extract::getConstTpetraVector(in.get_x_dot_dot()), rate_.data());
    model_.mass()->multiply(rate_.data(), part_.data());
    for (std::size_t i = 0; i < owned; ++i) sum_[i] += part_[i];
  }
  if (import_rate(in)) model_.add_rate_force_at(1.0, u_.data(), rate_.data(), sum_.data());
  model_.loads().add_force(in.get_t(), -1.0, sum_.data());
  model_.constraints().set(in.get_t(), part_.data(), nullptr, nullptr);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    sum_[i] = u_[i] - part_[i];
  }
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(sum_.data(), owned, view.data());
  return model_.space().minimum(admissible ? 1 : 0) > 0;
}

/// Sets rate_ to x_dot. Returns false if there is none, or no term that depends on it.
bool SemiDiscreteEvaluator::import_rate(const Base::InArgs<double>& in) const {
  if (in.get_x_dot().is_null() || !model_.has_rates()) return false;
  model_.space().import(*Extract::getConstTpetraVector(in.get_x_dot()), rate_.data());
  return true;
}

void SemiDiscreteEvaluator::evaluate_tangent(const Base::InArgs<double>& in, CrsMatrix& w) const {
  const auto matrix = w.getLocalMatrixHost();
  double* values = matrix.values.data();
  const std::size_t d = static_cast<std::size_t>(model_.mesh().dimension);
  if (matrix.values.extent(0) != static_cast<std::size_t>(model_.pattern().pairs()) * d * d)
    throw std::logic_error("W_op is of another version of the discretization; create another one");
  std::fill_n(values, matrix.values.extent(0), 0.0);
  Rule scaled = end_rule();
  scaled.points[0].weight = in.get_beta();
  const Segment here{nullptr, nullptr, u_.data()};
  model_.add_tangent(Part::Elastic, here, scaled, Tangent::Exact, values);
  model_.add_tangent(Part::Interaction, here, scaled, Tangent::Exact, values);
  if (model_.mass() != nullptr) model_.mass()->add_to(in.get_W_x_dot_dot_coeff(), values);
  if (!import_rate(in)) std::fill(rate_.begin(), rate_.end(), 0.0);
  model_.add_rate_tangent_at(in.get_alpha(), in.get_beta(), u_.data(), rate_.data(), values);
  const double diagonal = in.get_beta() != 0 ? in.get_beta() : in.get_W_x_dot_dot_coeff();
  model_.constrain_matrix(diagonal, values);
}

}  // namespace ixos

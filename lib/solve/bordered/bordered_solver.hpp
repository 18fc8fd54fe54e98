/// A solver for bordered tangents.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <utility>

#include "solve/thyra.hpp"
#include "solve/with_parameter_list.hpp"

namespace ixos {

/// Solves with a BorderedOperator by block elimination: one more solve with the nodal tangent for each column of the
/// border, kept until the next tangent, and a small dense system, whose equations are scaled. Everything that the
/// nodal solver keeps (factors, preconditioners, their history) is its own. Throws std::runtime_error if the small
/// system is singular.
class BorderedSolverFactory final : public WithParameterList<Thyra::LinearOpWithSolveFactoryBase<double>> {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;
  using Nodal = Thyra::LinearOpWithSolveFactoryBase<double>;

 public:
  explicit BorderedSolverFactory(Teuchos::RCP<const Nodal> nodal) : nodal_(std::move(nodal)) {}

  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;

 private:
  Teuchos::RCP<const Nodal> nodal_;
};

}  // namespace ixos

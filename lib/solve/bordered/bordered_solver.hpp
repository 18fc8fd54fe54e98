/// A solver for bordered tangents.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <utility>

#include "solve/thyra.hpp"

namespace ixos {

/// Solves with a BorderedOperator by block elimination: one more solve with the nodal tangent for each column of the
/// border, kept until the next tangent, and a small dense system, whose equations are scaled. Everything that the
/// nodal solver keeps (factors, preconditioners, their history) is its own. Throws std::runtime_error if the small
/// system is singular.
class BorderedSolverFactory final : public Thyra::LinearOpWithSolveFactoryBase<double> {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;
  using Nodal = Thyra::LinearOpWithSolveFactoryBase<double>;
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  explicit BorderedSolverFactory(Teuchos::RCP<const Nodal> nodal) : nodal_(std::move(nodal)) {}

  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;

  // The nodal factory is configured already.
  void setParameterList(const List& list) override { list_ = list; }
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override { return Teuchos::null; }

 private:
  Teuchos::RCP<const Nodal> nodal_;
  List list_;
};

}  // namespace ixos

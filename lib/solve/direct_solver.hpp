/// Sparse direct solvers for Thyra, with the symbolic factorisation kept.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>

namespace ixos {

/// Registered with Stratimikos as "Direct". An operator that is initialised again with the same matrix keeps its
/// symbolic factorisation and renews the numeric one. A matrix that cannot be factored throws std::runtime_error.
class DirectSolverFactory final : public Thyra::LinearOpWithSolveFactoryBase<double> {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;

  void setParameterList(const List& list) override;
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override;

 private:
  List list_;
};

}  // namespace ixos

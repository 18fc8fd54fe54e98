/// An iterative solver whose preconditioner outlives the matrix that it was made from.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_PreconditionerFactoryBase.hpp>
#include <memory>

#include "solve/linear_solver.hpp"

namespace ixos {

/// Wraps a Krylov solver and a preconditioner factory. The preconditioner is kept from solve to solve and renewed when
/// the iterations spent beyond its best solve add up to `setup_cost`, the price of a new one in iterations:
/// the rule that spends least when iterations grow steadily. It counts iterations and reads no clock, so runs repeat. A
/// solve that fails with an old preconditioner is tried once more with a new one, with `from_scratch` a new object (a
/// renewed multigrid keeps the prolongators of its first matrix); one that breaks down with a new one
/// (Belos throws where CG meets negative curvature) throws std::runtime_error.
class LaggedSolverFactory final : public Thyra::LinearOpWithSolveFactoryBase<double> {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  LaggedSolverFactory(Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> krylov,
                      Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner, double setup_cost,
                      bool from_scratch, std::shared_ptr<LinearStatistics> statistics);

  bool isCompatible(const Source& source) const override { return krylov_->isCompatible(source); }
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;

  // Everything is configured at construction.
  void setParameterList(const List& list) override { list_ = list; }
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override { return Teuchos::null; }

 private:
  Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> krylov_;
  Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner_;
  double setup_cost_;
  bool from_scratch_;
  std::shared_ptr<LinearStatistics> statistics_;
  List list_;
};

}  // namespace ixos

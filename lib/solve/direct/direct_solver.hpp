/// Sparse direct solvers for Thyra, with the symbolic factorisation kept.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>

#include "solve/direct/factorization_list.hpp"
#include "solve/kept_state.hpp"

namespace ixos {

/// Registered with Stratimikos as "Direct". An operator that is initialised again with the same matrix keeps its
/// symbolic factorisation and renews the numeric one. Throws std::runtime_error if a matrix cannot be factored.
class DirectSolverFactory final : public WithFactorizationList<Thyra::LinearOpWithSolveFactoryBase<double>>,
                                  public StateKeeper {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;

 public:
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;
};

}  // namespace ixos

/// A sparse factorisation as a preconditioner.
#pragma once
#include <Thyra_PreconditionerFactoryBase.hpp>

#include "solve/direct/factorization.hpp"
#include "solve/direct/factorization_list.hpp"

namespace ixos {

/// A preconditioner that may be a factorisation on the first rank.
class CollectedInverse {
 public:
  virtual ~CollectedInverse() = default;
  /// Returns it; null if several ranks apply it.
  virtual FirstRankFactorization* on_first_rank() const = 0;
};

/// A factory that makes the inverse of the matrix itself the preconditioner. With LaggedSolverFactory, a factorisation
/// thereby outlives Newton steps and time steps: a Krylov iteration costs a product and a triangular solve, a small
/// part of a new factorisation. The symbolic part is kept as long as the matrix is the same object. Throws
/// std::runtime_error if a matrix cannot be factored.
class DirectPreconditionerFactory final : public WithFactorizationList<Thyra::PreconditionerFactoryBase<double>> {
  using Source = Thyra::LinearOpSourceBase<double>;
  using Preconditioner = Thyra::PreconditionerBase<double>;

 public:
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Preconditioner> createPrec() const override;
  void initializePrec(const Teuchos::RCP<const Source>& source, Preconditioner* preconditioner,
                      Thyra::ESupportSolveUse use) const override;
  void uninitializePrec(Preconditioner* preconditioner, Teuchos::RCP<const Source>* source,
                        Thyra::ESupportSolveUse* use) const override;
};

}  // namespace ixos

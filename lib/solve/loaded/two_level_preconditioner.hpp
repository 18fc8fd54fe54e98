/// A cycle between fine and coarse displacements as a preconditioner.
#pragma once
#include <Thyra_PreconditionerFactoryBase.hpp>

#include "solve/with_parameter_list.hpp"

namespace ixos {

/// One cycle between the cells of an operator W and coarser linear cells, those on the corners of quadratic cells or
/// the coarse cells of linear ones (see CoarseSpace), for a CoarsenableOperator: no fine matrix is made. With
/// Chebyshev's polynomial S of W as the smoother,
///
///   I - B W = (I - S W) (I - P A^-1 P^T W) (I - S W),
///
/// where A^-1 is a preconditioner of P^T W P: MueLu or a factorisation. B is symmetric, and positive definite if W is.
/// Parameters: "Degree" and "Eigenvalue Ratio" of S, and the list "Coarse" with "Type", "MueLu" or "Direct", and the
/// list of that name: MueLu's own parameters, without null space and coordinates, or "Solver Type" (see
/// make_factorization).
class TwoLevelPreconditionerFactory final : public WithParameterList<Thyra::PreconditionerFactoryBase<double>> {
  using Source = Thyra::LinearOpSourceBase<double>;
  using Preconditioner = Thyra::PreconditionerBase<double>;

 public:
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override;
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Preconditioner> createPrec() const override;
  /// Makes everything anew from the operator's present state, or from what a checkpoint has. Throws std::runtime_error
  /// if the operator's diagonal has a zero or the coarse matrix is unfit. Collective.
  void initializePrec(const Teuchos::RCP<const Source>& source, Preconditioner* preconditioner,
                      Thyra::ESupportSolveUse use) const override;
  void uninitializePrec(Preconditioner*, Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const override {}
};

}  // namespace ixos

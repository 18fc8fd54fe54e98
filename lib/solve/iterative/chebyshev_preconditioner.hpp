/// A polynomial of the operator itself as a preconditioner.
#pragma once
#include <Thyra_PreconditionerFactoryBase.hpp>

#include "solve/with_parameter_list.hpp"

namespace ixos {

/// p(D^-1 W) D^-1, D the diagonal of W and p Chebyshev's polynomial for the upper part of the spectrum of D^-1 W (Saad
/// 2003, algorithm 12.1): the only preconditioner that never asks for a matrix. It pays if inertia dominates, at steps
/// near the time that a wave takes through an element; if many such times pass in a step, iterations grow with their
/// number. Parameters: "Degree" (applications of D^-1: one product less each time), "Eigenvalue Ratio" (at most, of the
/// largest eigenvalue to the least that p covers). Ten steps of Lanczos' method estimate both. If W outgrows the
/// estimates, p stays positive definite for odd degrees.
class ChebyshevPreconditionerFactory final : public WithParameterList<Thyra::PreconditionerFactoryBase<double>> {
  using Source = Thyra::LinearOpSourceBase<double>;
  using Preconditioner = Thyra::PreconditionerBase<double>;

 public:
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override;
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Preconditioner> createPrec() const override;
  /// Accepts an AssemblableOperator or a matrix; D has the magnitudes of its diagonal. Throws std::runtime_error if one
  /// of them is zero or not a number.
  void initializePrec(const Teuchos::RCP<const Source>& source, Preconditioner* preconditioner,
                      Thyra::ESupportSolveUse use) const override;
  void uninitializePrec(Preconditioner*, Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const override {}
};

}  // namespace ixos

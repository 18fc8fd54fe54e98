/// A preconditioner for CG that is not applied to a residual that has converged.
#pragma once
#include <Thyra_PreconditionerBase.hpp>
#include <memory>

namespace ixos {

/// Returns a preconditioner that applies the given one to a vector whose 2-norm is at least `bound`, and copies others.
/// Belos' CG applies its preconditioner to a new residual before it tests whether that has converged, and then has no
/// use for the result. With the bound just below the tolerance, the iterates are the same. `bound` may change; with 0,
/// all vectors are preconditioned. Returns a preconditioner without an operator as it is.
Teuchos::RCP<const Thyra::PreconditionerBase<double>> sparing_preconditioner(
    const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given, std::shared_ptr<const double> bound);

}  // namespace ixos

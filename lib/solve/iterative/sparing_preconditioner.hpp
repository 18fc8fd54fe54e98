/// A preconditioner for CG that is not applied to a residual that has converged.
#pragma once
#include <Thyra_PreconditionerBase.hpp>
#include <memory>

namespace ixos {

/// Returns a preconditioner that applies the given one to a vector whose 2-norm is at least `bound`, and copies others.
/// Belos' CG applies its preconditioner to a new residual before it tests whether that has converged, and then has no
/// use for the result. With a bound just below the norm at which CG ends, the tolerance times that of the right-hand
/// side, the iterates are the same. The norm is a sum over ranks. `bound` may change; with 0, all vectors are
/// preconditioned, and so are several columns. Returns a preconditioner without an operator as it is.
Teuchos::RCP<const Thyra::PreconditionerBase<double>> sparing_preconditioner(
    const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given, std::shared_ptr<const double> bound);

}  // namespace ixos

/// Operators that can make their Galerkin product on coarse cells when a preconditioner asks for it.
#pragma once
#include "base/tpetra.hpp"
#include "discretization/coarse_space.hpp"

namespace ixos {

class CoarsenableOperator {
 public:
  virtual ~CoarsenableOperator() = default;
  /// Returns the coarse displacements of the operator's mesh. Made at the first call, which is collective. Throws
  /// InputError if the mesh has linear cells that refine no coarser ones, or a term of the program offers no Galerkin
  /// product.
  virtual const CoarseSpace& coarse_space() const = 0;
  /// Returns P^T W P of the operator's present state, a new matrix in the layout of the coarse space's Pattern, with
  /// the operator's diagonal entries of constrained degrees of freedom for those that the space leaves out. Collective.
  virtual Teuchos::RCP<CrsMatrix> coarse_matrix() const = 0;
};

}  // namespace ixos

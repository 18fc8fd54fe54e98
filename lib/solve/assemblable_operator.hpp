/// Operators that can make their matrix when a preconditioner asks for one.
#pragma once
#include <Tpetra_Operator.hpp>

#include "base/tpetra.hpp"

namespace ixos {

/// The precision of an operator's products.
enum class Precision { Double, Single };

class AssemblableOperator : public Operator {
 public:
  /// Sets the precision of later products and returns the one before. Errors of Single are near 1e-7 of the forces that
  /// the differences of x in each cell exert; in a slender body that turns, these are far larger than the result.
  virtual Precision set_precision(Precision precision) const = 0;
  /// Returns the matrix of the operator's present state; its values are computed at the first request after a change.
  /// It is one object for the operator's whole life, fill-complete. Collective.
  virtual Teuchos::RCP<CrsMatrix> matrix() const = 0;
  /// Invalidates the matrix's values after a caller has overwritten them: the next request computes them anew.
  virtual void forget_values() const = 0;
  /// Computes the diagonal, by row. Collective.
  virtual void diagonal(Vector& result) const = 0;
};

}  // namespace ixos

/// Operators that can make their matrix where a preconditioner asks for one.
#pragma once
#include <Tpetra_Operator.hpp>

#include "base/tpetra.hpp"

namespace ixos {

class AssemblableOperator : public Operator {
 public:
  /// The matrix of the operator as it is now: values are computed at the first request after a change. One object for
  /// the whole life, fill-complete. Collective.
  virtual Teuchos::RCP<CrsMatrix> matrix() const = 0;
  /// Somebody has put other values into the matrix: they are computed anew at the next request.
  virtual void forget_values() const = 0;
  /// The diagonal, by row. Collective.
  virtual void diagonal(Vector& result) const = 0;
};

}  // namespace ixos

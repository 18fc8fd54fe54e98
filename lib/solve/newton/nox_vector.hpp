/// The Tpetra vector inside a NOX one. Included by lib/solve only.
#pragma once
#include <NOX_Thyra_Vector.H>

#include "solve/thyra.hpp"

namespace ixos {

inline Teuchos::RCP<const Vector> tpetra(const NOX::Abstract::Vector& vector) {
  return Extract::getConstTpetraVector(dynamic_cast<const NOX::Thyra::Vector&>(vector).getThyraRCPVector());
}

inline Teuchos::RCP<Vector> tpetra(NOX::Abstract::Vector& vector) {
  return Extract::getTpetraVector(dynamic_cast<NOX::Thyra::Vector&>(vector).getThyraRCPVector());
}

/// Returns the inner product, at a third of the cost of NOX's own for short vectors. Collective.
double inner_product(const Vector& a, const Vector& b);

}  // namespace ixos

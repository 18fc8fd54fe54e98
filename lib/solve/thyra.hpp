/// Thyra over Tpetra: the conversions, in one place. Included by lib/solve only.
#pragma once
#include <Thyra_LinearOpSourceBase.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

#include "base/tpetra.hpp"

namespace ixos {

using Node = Map::node_type;
using Extract = Thyra::TpetraOperatorVectorExtraction<double, LocalId, GlobalId, Node>;
using VectorSpace = Teuchos::RCP<const Thyra::VectorSpaceBase<double>>;

inline VectorSpace vector_space(const Teuchos::RCP<const Map>& map) {
  return Thyra::createVectorSpace<double, LocalId, GlobalId, Node>(map);
}

inline Teuchos::RCP<Thyra::LinearOpBase<double>> linear_op(const Teuchos::RCP<CrsMatrix>& matrix,
                                                           const VectorSpace& space) {
  const Teuchos::RCP<Operator> as_operator = matrix;
  return Thyra::createLinearOp<double, LocalId, GlobalId, Node>(as_operator, space, space);
}

/// The matrix behind an operator, or null where it is none.
inline Teuchos::RCP<const CrsMatrix> matrix_of(const Thyra::LinearOpSourceBase<double>& source) {
  return Teuchos::rcp_dynamic_cast<const CrsMatrix>(Extract::getConstTpetraOperator(source.getOp()));
}

}  // namespace ixos

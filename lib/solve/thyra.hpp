/// Thyra over Tpetra: the conversions, in one place.
#pragma once
#include <Thyra_LinearOpSourceBase.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

#include "base/tpetra.hpp"
#include "solve/assemblable_operator.hpp"

namespace ixos {

using Node = Map::node_type;
using Extract = Thyra::TpetraOperatorVectorExtraction<double, LocalId, GlobalId, Node>;
using VectorSpace = Teuchos::RCP<const Thyra::VectorSpaceBase<double>>;

inline VectorSpace vector_space(const Teuchos::RCP<const Map>& map) {
  return Thyra::createVectorSpace<double, LocalId, GlobalId, Node>(map);
}

inline Teuchos::RCP<Thyra::LinearOpBase<double>> linear_op(const Teuchos::RCP<Operator>& op, const VectorSpace& space) {
  return Thyra::createLinearOp<double, LocalId, GlobalId, Node>(op, space, space);
}

inline Teuchos::RCP<const Thyra::LinearOpBase<double>> const_linear_op(const Teuchos::RCP<const Operator>& op,
                                                                       const VectorSpace& space) {
  return Thyra::createConstLinearOp<double, LocalId, GlobalId, Node>(op, space, space);
}

/// Returns the matrix behind an operator. A matrix-free operator assembles it now; null if the operator has none.
inline Teuchos::RCP<const CrsMatrix> matrix_of(const Thyra::LinearOpSourceBase<double>& source) {
  const auto op = Extract::getConstTpetraOperator(source.getOp());
  const auto assemblable = Teuchos::rcp_dynamic_cast<const AssemblableOperator>(op);
  if (nonnull(assemblable)) return assemblable->matrix();
  return Teuchos::rcp_dynamic_cast<const CrsMatrix>(op);
}

}  // namespace ixos

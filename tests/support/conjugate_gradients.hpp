/// The method of conjugate gradients, for benchmarks.
#pragma once
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Tpetra_Vector.hpp>

#include "solve/operator_preconditioner.hpp"

namespace ixos::test {

/// Solves A x = b from x = 0 to |r| <= tolerance |b| with a preconditioner. Returns the number of iterations, -1 beyond
/// 500.
inline int conjugate_gradients(const Operator& a, const Thyra::LinearOpBase<double>& m, const VectorSpace& space,
                               const Vector& b, double tolerance, Vector& x) {
  x.putScalar(0);
  Vector r(b, Teuchos::Copy), z(b.getMap()), p(b.getMap()), ap(b.getMap());
  const auto precondition = [&] {
    const Teuchos::RCP<const MultiVector> known = Teuchos::rcpFromRef(r);
    const Teuchos::RCP<MultiVector> found = Teuchos::rcpFromRef(z);
    const auto from = Thyra::createConstMultiVector(known, space);
    const auto to = Thyra::createMultiVector(found, space);
    Thyra::apply<double>(m, Thyra::NOTRANS, *from, to.ptr());
  };
  const double goal = tolerance * b.norm2();
  precondition();
  p.assign(z);
  double rz = r.dot(z);
  for (int k = 1; k <= 500; ++k) {
    a.apply(p, ap);
    const double alpha = rz / p.dot(ap);
    x.update(alpha, p, 1.0);
    r.update(-alpha, ap, 1.0);
    if (r.norm2() <= goal) return k;
    precondition();
    const double next = r.dot(z);
    p.update(1.0, z, next / rz);
    rz = next;
  }
  return -1;
}

}  // namespace ixos::test

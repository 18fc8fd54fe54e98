#include "solve/newton/nox_vector.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Vector.hpp>

#include "base/dot.hpp"

namespace ixos {

double inner_product(const Vector& a, const Vector& b) {
  const auto x = a.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto y = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double mine = dot(x.data(), y.data(), x.extent(0));
  const auto& comm = *a.getMap()->getComm();
  if (comm.getSize() == 1) return mine;
  double all = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 1, &mine, &all);
  return all;
}

}  // namespace ixos

#include "solve/nox_vector.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Vector.hpp>

namespace ixos {

double inner_product(const Vector& a, const Vector& b) {
  const auto x = a.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto y = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double *p = x.data(), *q = y.data();
  const std::size_t count = x.extent(0);
  double sums[4] = {};  // in turn: one would wait for itself
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (std::size_t k = 0; k < 4; ++k) sums[k] += p[i + k] * q[i + k];
  for (; i < count; ++i) sums[0] += p[i] * q[i];
  const double mine = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  const auto& comm = *a.getMap()->getComm();
  if (comm.getSize() == 1) return mine;
  double all = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 1, &mine, &all);
  return all;
}

}  // namespace ixos

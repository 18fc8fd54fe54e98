/// Matrices for the tests of linear solvers.
#pragma once
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <utility>

#include "base/tpetra.hpp"

namespace ixos::test {

/// Returns a matrix with rows (-1 - skew, diagonal + 0.01 row, -1 + skew), on all ranks: unsymmetric unless skew is 0.
inline Teuchos::RCP<CrsMatrix> tridiagonal(int n, double diagonal, double skew, const Comm& comm) {
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(n), 0, comm));
  const auto matrix = Teuchos::rcp(new CrsMatrix(map, 3));
  for (GlobalId row = 0; row < n; ++row) {
    if (!map->isNodeGlobalElement(row)) continue;
    for (const auto& [column, value] :
         {std::pair{row - 1, -1 - skew}, std::pair{row, diagonal + 0.01 * static_cast<double>(row)},
          std::pair{row + 1, -1 + skew}})
      if (column >= 0 && column < n)
        matrix->insertGlobalValues(row, Teuchos::tuple<GlobalId>(column), Teuchos::tuple<double>(value));
  }
  matrix->fillComplete();
  return matrix;
}

}  // namespace ixos::test

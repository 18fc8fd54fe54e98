#include "base/dense_solve.hpp"

#include <Teuchos_SerialDenseMatrix.hpp>
#include <Teuchos_SerialDenseSolver.hpp>
#include <cstddef>

namespace ixos {

std::vector<double> dense_solve(const std::vector<double>& a, const std::vector<double>& b) {
  using Dense = Teuchos::SerialDenseMatrix<int, double>;
  const auto n = static_cast<int>(b.size());
  Dense matrix(n, n), rhs(n, 1), x(n, 1);
  for (int i = 0; i < n; ++i) {
    rhs(i, 0) = b[static_cast<std::size_t>(i)];
    for (int j = 0; j < n; ++j) matrix(i, j) = a[static_cast<std::size_t>(i * n + j)];
  }
  Teuchos::SerialDenseSolver<int, double> solver;
  solver.setMatrix(Teuchos::rcpFromRef(matrix));
  solver.setVectors(Teuchos::rcpFromRef(x), Teuchos::rcpFromRef(rhs));
  solver.factorWithEquilibration(true);
  double condition = 0;  // its reciprocal
  if (solver.factor() != 0 || solver.reciprocalConditionEstimate(condition) < 0 || condition < 1e-14) return {};
  if (solver.solve() != 0) return {};
  return {x.values(), x.values() + n};
}

}  // namespace ixos

#include "base/dense_solve.hpp"

#include <Teuchos_SerialDenseMatrix.hpp>
#include <Teuchos_SerialDenseSolver.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ixos {

std::vector<double> dense_solve(const std::vector<double>& a, const std::vector<double>& b) {
  using Dense = Teuchos::SerialDenseMatrix<int, double>;
  const std::size_t size = b.size();
  const auto n = static_cast<int>(size);
  // The solver's own scaling would not reach its estimate of the condition.
  std::vector<double> rows(size, 0.0), columns(size, 0.0);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) rows[i] = std::max(rows[i], std::abs(a[i * size + j]));
  if (std::any_of(rows.begin(), rows.end(), [](double row) { return !(row > 0); })) return {};
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i < size; ++i) columns[j] = std::max(columns[j], std::abs(a[i * size + j]) / rows[i]);
  if (std::any_of(columns.begin(), columns.end(), [](double column) { return !(column > 0); })) return {};
  Dense matrix(n, n), rhs(n, 1), x(n, 1);
  for (std::size_t i = 0; i < size; ++i) {
    rhs(static_cast<int>(i), 0) = b[i] / rows[i];
    for (std::size_t j = 0; j < size; ++j)
      matrix(static_cast<int>(i), static_cast<int>(j)) = a[i * size + j] / (rows[i] * columns[j]);
  }
  Teuchos::SerialDenseSolver<int, double> solver;
  solver.setMatrix(Teuchos::rcpFromRef(matrix));
  solver.setVectors(Teuchos::rcpFromRef(x), Teuchos::rcpFromRef(rhs));
  double condition = 0;  // its reciprocal
  if (solver.factor() != 0 || solver.reciprocalConditionEstimate(condition) < 0 || !(condition > 1e-14)) return {};
  if (solver.solve() != 0) return {};
  std::vector<double> result(x.values(), x.values() + n);
  for (std::size_t j = 0; j < size; ++j) result[j] /= columns[j];
  return result;
}

}  // namespace ixos

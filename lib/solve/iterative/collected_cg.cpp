#include "solve/iterative/collected_cg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ixos {
namespace {

double dot(const std::vector<double>& a, const double* b) { return std::inner_product(a.begin(), a.end(), b, 0.0); }

void multiply(CollectedMatrix& matrix, const std::vector<double>& x, std::vector<double>& y) {
  const int *starts = matrix.starts(), *columns = matrix.columns();
  const double* values = matrix.values();
  for (std::size_t row = 0; row < y.size(); ++row) {
    double sum = 0;
    for (int k = starts[row]; k < starts[row + 1]; ++k) sum += values[k] * x[static_cast<std::size_t>(columns[k])];
    y[row] = sum;
  }
}

/// Iterates on the first rank.
CollectedSolve iterate(CollectedMatrix& matrix, const std::function<const double*(const double*)>& precondition,
                       const double* b, double tolerance, int maximum_iterations, std::vector<double>& x) {
  CollectedSolve result;
  const auto size = static_cast<std::size_t>(matrix.size());
  std::vector<double> r(b, b + size), p(size, 0.0), product(size);
  x.assign(size, 0.0);
  const double scale = std::sqrt(dot(r, r.data()));
  double previous = 0;
  for (double norm = scale;; ++result.iterations) {
    result.residual = scale > 0 ? norm / scale : 0;
    result.status = !std::isfinite(norm)        ? CollectedSolve::NotFinite
                    : norm <= tolerance * scale ? CollectedSolve::Converged
                                                : CollectedSolve::Unconverged;
    if (result.status != CollectedSolve::Unconverged || result.iterations == maximum_iterations) return result;
    const double* z = precondition(r.data());
    const double weight = dot(r, z), share = result.iterations > 0 ? weight / previous : 0;
    previous = weight;
    for (std::size_t i = 0; i < size; ++i) p[i] = z[i] + share * p[i];
    multiply(matrix, p, product);
    const double curvature = dot(p, product.data());
    if (!(curvature > 0)) {
      result.status = std::isnan(curvature) ? CollectedSolve::NotFinite : CollectedSolve::NegativeCurvature;
      return result;
    }
    const double step = weight / curvature;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] += step * p[i];
      r[i] -= step * product[i];
    }
    norm = std::sqrt(dot(r, r.data()));
  }
}

}  // namespace

CollectedSolve collected_cg(CollectedMatrix& matrix, const std::function<const double*(const double*)>& precondition,
                            const MultiVector& b, MultiVector& x, double tolerance, int maximum_iterations) {
  CollectedSolve result;
  std::vector<double> solution;
  matrix.solve(b, x, [&](const std::vector<const double*>& from, const std::vector<double*>& to) {
    result = iterate(matrix, precondition, from[0], tolerance, maximum_iterations, solution);
    std::copy(solution.begin(), solution.end(), to[0]);
  });
  const std::array<double, 3> agreed =
      matrix.agreed({static_cast<double>(result.status), static_cast<double>(result.iterations), result.residual});
  return {static_cast<int>(agreed[0]), static_cast<int>(agreed[1]), agreed[2]};
}

}  // namespace ixos

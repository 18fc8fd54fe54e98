/// Products and paths for tests of tangents.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace ixos::test {

/// Returns K x, rows of owned nodes, of matrix values laid out by the model's pattern.
inline std::vector<double> matrix_product(const Model& model, const double* values, const std::vector<double>& x) {
  std::vector<double> y(static_cast<std::size_t>(model.space().owned()), 0.0);
  add_matrix_product(model.pattern(), values, 1, x.data(), y.data());
  return y;
}

/// Returns matrix values of a model's pattern, all 0.
inline std::vector<double> no_values(const Model& model) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  return std::vector<double>(static_cast<std::size_t>(model.pattern().pairs()) * d * d, 0.0);
}

/// Returns u + step direction.
inline std::vector<double> moved(const std::vector<double>& u, double step, const std::vector<double>& direction) {
  std::vector<double> result = u;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] += step * direction[k];
  return result;
}

}  // namespace ixos::test

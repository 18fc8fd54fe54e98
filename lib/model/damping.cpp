#include "model/damping.hpp"

#include <cmath>

namespace ixos {

Damping::Damping(const Pattern& pattern, int dimension)
    : pattern_(pattern),
      dimension_(dimension),
      values_(static_cast<std::size_t>(pattern.pairs() * dimension * dimension), 0.0) {}

void Damping::multiply_add(double factor, const double* x, double* y) const {
  const auto d = static_cast<std::size_t>(dimension_);
  const std::vector<int>& start = pattern_.row_start();
  const double* value = values_.data();
  for (std::size_t row = 0; row + 1 < start.size(); ++row)
    for (std::size_t i = 0; i < d; ++i) {
      double sum = 0;
      for (int p = start[row]; p < start[row + 1]; ++p) {
        const auto node = static_cast<std::size_t>(pattern_.columns()[static_cast<std::size_t>(p)]);
        for (std::size_t j = 0; j < d; ++j) sum += *value++ * x[node * d + j];
      }
      y[row * d + i] += factor * sum;
    }
}

void Damping::row_sums(double* sums) const {
  const auto d = static_cast<std::size_t>(dimension_);
  const std::vector<int>& start = pattern_.row_start();
  const double* value = values_.data();
  for (std::size_t row = 0; row + 1 < start.size(); ++row)
    for (std::size_t i = 0; i < d; ++i) {
      sums[row * d + i] = 0;
      for (std::size_t k = 0; k < d * static_cast<std::size_t>(start[row + 1] - start[row]); ++k)
        sums[row * d + i] += std::abs(*value++);
    }
}

void Damping::add_to(double factor, double* values) const {
  for (std::size_t k = 0; k < values_.size(); ++k) values[k] += factor * values_[k];
}

}  // namespace ixos

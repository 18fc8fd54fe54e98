#include "base/dense_solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace ixos {

std::vector<double> dense_solve(std::vector<double> a, std::vector<double> b) {
  const std::size_t size = b.size();
  std::vector<double> scales(size, 0.0);  // of unknowns
  for (std::size_t i = 0; i < size; ++i) {
    double* const row = &a[i * size];
    double largest = 0;
    for (std::size_t j = 0; j < size; ++j) largest = std::max(largest, std::abs(row[j]));
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    b[i] /= largest;
    for (std::size_t j = 0; j < size; ++j) {
      row[j] /= largest;
      scales[j] = std::max(scales[j], std::abs(row[j]));
    }
  }
  if (std::any_of(scales.begin(), scales.end(), [](double scale) { return !(scale > 0); })) return {};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) a[i * size + j] /= scales[j];
  std::vector<std::size_t> unknowns(size);
  std::iota(unknowns.begin(), unknowns.end(), 0);
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t row = k, column = k;
    for (std::size_t i = k; i < size; ++i)
      for (std::size_t j = k; j < size; ++j)
        if (std::abs(a[i * size + j]) > std::abs(a[row * size + column])) {
          row = i;
          column = j;
        }
    for (std::size_t j = 0; j < size; ++j) std::swap(a[k * size + j], a[row * size + j]);
    std::swap(b[k], b[row]);
    for (std::size_t i = 0; i < size; ++i) std::swap(a[i * size + k], a[i * size + column]);
    std::swap(unknowns[k], unknowns[column]);
    if (!(std::abs(a[k * size + k]) > 1e-14 * std::abs(a[0]))) return {};
    for (std::size_t i = k + 1; i < size; ++i) {
      const double factor = a[i * size + k] / a[k * size + k];
      for (std::size_t j = k; j < size; ++j) a[i * size + j] -= factor * a[k * size + j];
      b[i] -= factor * b[k];
    }
  }
  std::vector<double> result(size);
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) b[k] -= a[k * size + j] * b[j];
    b[k] /= a[k * size + k];
    result[unknowns[k]] = b[k] / scales[unknowns[k]];
  }
  return result;
}

}  // namespace ixos

#include "term/support/constrained_entries.hpp"

#include <algorithm>

namespace ixos {

ConstrainedEntries::ConstrainedEntries(const Pattern& pattern, const Constraints& constraints)
    : constraints_(constraints.dofs().size()),
      dimension_(static_cast<std::size_t>(pattern.dimension())),
      planes_(constraints.planes()),
      rows_(pattern.rows() * pattern.dimension()) {
  pattern.for_each_row([&](int row, const auto& entries) {
    const bool row_held = constraints.holds(row);
    entries([&](int column, std::size_t place) {
      const bool column_held = constraints.holds(column);
      if (row_held && row == column)
        diagonal_.push_back(place);
      else if (row_held || column_held)
        zeros_.push_back(place);
      if (column_held && !row_held) columns_.push_back({place, row, column});
    });
  });
  for (int row = 0; row < pattern.rows() && !planes_.empty(); ++row)
    pattern.for_each_block(row, [&](int column, int offset) {
      if (pattern.ties().is_tied(column)) return;
      if (!planes_.normals(row).empty() || !planes_.normals(column).empty())
        blocks_.push_back(
            {static_cast<std::size_t>(offset), static_cast<std::size_t>(pattern.stride(row)), row, column});
    });
}

void ConstrainedEntries::constrain(double diagonal, double* values) const {
  for (const std::size_t place : zeros_) values[place] = 0;
  for (const std::size_t place : diagonal_) values[place] = diagonal;
  for (const Block& block : blocks_) project(block, diagonal, values);
}

/// B becomes P B P', with the projections of both nodes; on the diagonal of the matrix `diagonal` (I - P) comes to it.
void ConstrainedEntries::project(const Block& block, double diagonal, double* values) const {
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return values[block.offset + i * block.stride + j]; };
  for (const Vec<3>& normal : planes_.normals(block.row))
    for (std::size_t j = 0; j < dimension_; ++j) {
      double along = 0;
      for (std::size_t i = 0; i < dimension_; ++i) along += normal[i] * at(i, j);
      for (std::size_t i = 0; i < dimension_; ++i) at(i, j) -= normal[i] * along;
    }
  for (const Vec<3>& normal : planes_.normals(block.column))
    for (std::size_t i = 0; i < dimension_; ++i) {
      double along = 0;
      for (std::size_t j = 0; j < dimension_; ++j) along += at(i, j) * normal[j];
      for (std::size_t j = 0; j < dimension_; ++j) at(i, j) -= along * normal[j];
    }
  if (block.row != block.column) return;
  for (const Vec<3>& normal : planes_.normals(block.row))
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j) at(i, j) += diagonal * normal[i] * normal[j];
}

void ConstrainedEntries::multiply(const double* values, const double* x, double* result) const {
  std::fill_n(result, rows_, 0.0);
  for (const Entry& entry : columns_) result[entry.row] += values[entry.place] * x[entry.column];
  planes_.project(result, rows_ / static_cast<int>(dimension_));
}

}  // namespace ixos

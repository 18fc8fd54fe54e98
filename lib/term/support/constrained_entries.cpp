#include "term/support/constrained_entries.hpp"

#include <algorithm>

namespace ixos {

ConstrainedEntries::ConstrainedEntries(const Pattern& pattern, const Constraints& constraints)
    : constraints_(constraints.dofs().size()), rows_(pattern.rows() * pattern.dimension()) {
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
}

void ConstrainedEntries::constrain(double diagonal, double* values) const {
  for (const std::size_t place : zeros_) values[place] = 0;
  for (const std::size_t place : diagonal_) values[place] = diagonal;
}

void ConstrainedEntries::multiply(const double* values, const double* x, double* result) const {
  std::fill_n(result, rows_, 0.0);
  for (const Entry& entry : columns_) result[entry.row] += values[entry.place] * x[entry.column];
}

}  // namespace ixos

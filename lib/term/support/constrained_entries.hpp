/// The matrix entries that constrained degrees of freedom meet.
#pragma once
#include <cstddef>
#include <vector>

#include "discretization/pattern.hpp"
#include "term/support/constraints.hpp"

namespace ixos {

/// The places, in matrix values of a Pattern, of all entries in a row or column of a constrained degree of freedom: a
/// few, so that nobody walks over the whole matrix.
class ConstrainedEntries {
 public:
  ConstrainedEntries(const Pattern& pattern, const Constraints& constraints);

  /// Returns the number of degrees of freedom that were constrained when it was made.
  std::size_t constraints() const { return constraints_; }
  /// Replaces the rows and columns by `diagonal` I.
  void constrain(double diagonal, double* values) const;
  /// Sets result[r] = sum of K_rp x_p over constrained columns p, for free owned rows r, 0 for constrained ones; x
  /// local.
  void multiply(const double* values, const double* x, double* result) const;

 private:
  struct Entry {
    std::size_t place;
    int row, column;
  };
  std::size_t constraints_;
  int rows_;                        ///< owned degrees of freedom
  std::vector<std::size_t> zeros_;  ///< all places but those of the diagonal
  std::vector<std::size_t> diagonal_;
  std::vector<Entry> columns_;  ///< entries of constrained columns in free rows, row by row
};

}  // namespace ixos

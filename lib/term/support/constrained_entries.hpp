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

  /// Returns whether these are the constraints that it was made of, none added since.
  bool are_of(const Constraints& constraints) const {
    return constraints_ == constraints.dofs().size() && planes_.size() == constraints.planes().size();
  }
  /// Replaces the rows and columns by `diagonal` I; of nodes in planes, those across the planes, see NodePlanes.
  void constrain(double diagonal, double* values) const;
  /// Sets result[r] = sum of K_rp x_p over constrained columns p, for free owned rows r, 0 for constrained ones; x
  /// local. Forces across planes drop out.
  void multiply(const double* values, const double* x, double* result) const;

 private:
  struct Entry {
    std::size_t place;
    int row, column;
  };
  /// A node pair of which one node, or both, are in planes.
  struct Block {
    std::size_t offset, stride;
    int row, column;
  };
  void project(const Block& block, double diagonal, double* values) const;

  std::size_t constraints_;
  std::size_t dimension_;
  NodePlanes planes_;
  std::vector<Block> blocks_;
  int rows_;                        ///< owned degrees of freedom
  std::vector<std::size_t> zeros_;  ///< all places but those of the diagonal
  std::vector<std::size_t> diagonal_;
  std::vector<Entry> columns_;  ///< entries of constrained columns in free rows, row by row
};

}  // namespace ixos

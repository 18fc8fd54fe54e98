/// L D U of a matrix with a narrow band, in SIMD.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace ixos {

/// The factors of A = L D U, where L and the transpose of U have a unit diagonal and the same band. A symmetric matrix
/// has U = L^T, for half of the work and the memory. Four columns share their last row, and no last row is above an
/// earlier one, so that the fill stays within. Without pivoting it suits matrices with a definite symmetric part, and
/// others as long as no pivot vanishes (Golub and Van Loan 2013, sections 4.1.2, 4.3.1 and 4.3.5).
class BandLdu {
 public:
  enum class Symmetry { Symmetric, None };

  BandLdu() = default;
  /// `last[j]` is the last row of column j, not above j, with an entry in A, and the last column of row j.
  explicit BandLdu(const std::vector<int>& last, Symmetry symmetry = Symmetry::Symmetric);

  /// Returns the multiplications and additions of a factorisation of a symmetric matrix, half of them each, to the
  /// order of a column's entries. Without symmetry they are twice as many.
  static double operations(const std::vector<int>& last);

  /// Sets A = 0.
  void clear();
  /// Returns the index in entries() of row i in column j. Both are within the band; j <= i if A is symmetric.
  std::size_t place(int i, int j) const;
  double* entries() { return entries_.data(); }

  /// Replaces A by its factors. Returns whether all pivots are finite and not zero.
  bool factor();
  /// Returns the least magnitude of a pivot over the largest, after factor(). A matrix without rows has 1.
  double pivot_ratio() const;
  /// Sets x = A^-1 x, after factor(), for each of several columns x, one after the other. The length of each is
  /// padded_size(), and what lies behind the end of A is zero. Columns share the passes over the factors, four by four.
  void solve(double* x, std::size_t count = 1) const;
  std::size_t padded_size() const;

 private:
  static constexpr std::size_t width = 4;                  ///< number of columns in a block
  static constexpr int columns = static_cast<int>(width);  ///< the same
  /// Columns `first` to `first` + 3 of L from row `first` on, one after the other; what lies above the diagonal is
  /// computed along and never read. Those of the transpose of U are `upper_` entries later.
  struct Block {
    int first, last;
    std::size_t start, stride;  ///< place of the first column, distance of two columns
  };
  /// The first column of a block in one of the factors, and in the other one.
  struct Columns {
    double *own, *other;
  };
  std::array<Columns, 2> both(const Block& block);
  std::size_t factors() const { return upper_ == 0 ? 1 : 2; }
  /// Columns of an earlier block that reach into the rows of a later one.
  struct Source {
    const double* rows;  ///< of the first column, from the later block's first row on
    std::size_t stride, packs;
    std::array<double, width * width> scaled;  ///< pivots times the other factor's rows at the later block's columns
  };
  bool factor(const Block& block);
  template <std::size_t n>
  void solve_columns(double* x) const;
  void subtract(std::size_t k, std::size_t first, std::size_t f);
  template <std::size_t n>
  void subtract_rows(double* target, std::size_t stride, std::size_t done, const Source* end) const;

  int size_ = 0;
  std::vector<Block> blocks_;
  std::size_t upper_ = 0;  ///< where the transpose of U begins; 0 if it is L
  std::vector<double> entries_;
  std::vector<std::array<double, width>> pivots_;
  std::vector<Source> sources_;  ///< room for those of any block
};

}  // namespace ixos

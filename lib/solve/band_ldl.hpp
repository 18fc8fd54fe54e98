/// L D L^T of a symmetric matrix with a narrow band, in SIMD.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace ixos {

/// The factors L and D of A = L D L^T, where A is symmetric and L has a unit diagonal. Four columns share their last
/// row, and no last row is above an earlier one, so that the fill stays within. Without pivoting it suits
/// definite matrices, and indefinite ones as long as no pivot vanishes (Golub and Van Loan 2013, sections 4.1.2
/// and 4.3.5).
class BandLdl {
 public:
  BandLdl() = default;
  /// `last[j]` is the last row of column j, not above j, with an entry in A.
  explicit BandLdl(const std::vector<int>& last);

  /// Returns the multiplications and additions of a factorisation, half of them each, to the order of a column's
  /// entries.
  static double operations(const std::vector<int>& last);

  /// Sets A = 0.
  void clear();
  /// Returns the index in entries() of row i in column j: j <= i <= last[j].
  std::size_t place(int i, int j) const;
  double* entries() { return entries_.data(); }

  /// Replaces A by its factors. Returns whether all pivots are finite and not zero.
  bool factor();
  /// Sets x = A^-1 x, after factor(). The length of x is padded_size(), and what lies behind the end of A is zero.
  void solve(double* x) const;
  std::size_t padded_size() const;

 private:
  static constexpr std::size_t width = 4;                  ///< number of columns in a block
  static constexpr int columns = static_cast<int>(width);  ///< the same
  /// Columns `first` to `first` + 3 from row `first` on, one after the other; what lies above the diagonal is
  /// computed along and never read.
  struct Block {
    int first, last;
    std::size_t start, stride;  ///< place of the first column, distance of two columns
  };
  bool factor(const Block& block);
  void subtract(const Block& block, const Block& from);

  int size_ = 0;
  std::vector<Block> blocks_;
  std::vector<double> entries_;
  std::vector<std::array<double, width>> pivots_;
};

}  // namespace ixos

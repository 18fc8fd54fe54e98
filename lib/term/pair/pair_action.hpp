/// The tangent of two surfaces applied without a matrix.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "term/pair/pair_block.hpp"

namespace ixos {

/// Keeps the matrix of each secondary patch and all primary ones before it, in single precision.
template <std::size_t D>
class PairAction final : public TangentAction {
 public:
  /// `blocks`: the symmetric matrices of a tangent; those of a secondary patch follow each other.
  explicit PairAction(PairBlocks blocks) : tangent_(std::move(blocks)) {}

  void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override;
  bool applies_mass() const override { return false; }
  bool has_coarse() const override { return false; }
  void add_product(const double* x, double* y) const override;
  void add_diagonal(double* d) const override;

 private:
  /// Where its rows and values begin, and the number of its rows.
  struct Block {
    std::size_t rows, values, size;
  };
  void keep_sum();

  PairBlocks tangent_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> rows_;  ///< degrees of freedom, each once in a block
  std::vector<float> values_;
  std::vector<PairBlock> parts_;  ///< of one secondary patch; the first `count_` ones count
  std::size_t count_ = 0;
  std::vector<int> nodes_;  ///< of these parts
  std::vector<std::size_t> places_;
  mutable std::vector<double> sum_;
};

extern template class PairAction<2>;
extern template class PairAction<3>;

}  // namespace ixos

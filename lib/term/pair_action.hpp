/// The tangent of two surfaces applied without a matrix.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "term/pair_points.hpp"

namespace ixos {

/// Keeps the matrix of each pair of a secondary and a primary patch, in single precision. The points must outlive it.
template <std::size_t D>
class PairAction final : public TangentAction {
 public:
  explicit PairAction(const PairPoints<D>& points) : points_(points) {}

  /// Throws std::logic_error unless the rule has points.
  void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
    if (rule.mean != Mean::Points) throw std::logic_error("the action of a pair of surfaces is for rules with points");
    blocks_.clear();
    rows_.clear();
    values_.clear();
    points_.for_each_block(segment, rule, kind, [&](const PairBlock& block) {
      blocks_.push_back({rows_.size(), values_.size(), D * block.nodes.size()});
      for (const int node : block.nodes)
        for (std::size_t i = 0; i < D; ++i) rows_.push_back(D * static_cast<std::size_t>(node) + i);
      for (const double value : block.k) values_.push_back(static_cast<float>(value));
    });
  }
  /// The matrices are symmetric: their rows stand for columns.
  void add_product(const double* x, double* y) const override {
    std::vector<double> sum;
    for (const Block& block : blocks_) {
      const std::size_t* const rows = rows_.data() + block.rows;
      sum.assign(block.size, 0.0);
      const float* column = values_.data() + block.values;
      for (std::size_t c = 0; c < block.size; ++c, column += block.size) {
        const double factor = x[rows[c]];
        for (std::size_t r = 0; r < block.size; ++r) sum[r] += factor * column[r];
      }
      for (std::size_t r = 0; r < block.size; ++r) y[rows[r]] += sum[r];
    }
  }
  /// A node can stand twice in a block.
  void add_diagonal(double* d) const override {
    for (const Block& block : blocks_) {
      const std::size_t* const rows = rows_.data() + block.rows;
      for (std::size_t r = 0; r < block.size; ++r)
        for (std::size_t c = 0; c < block.size; ++c)
          if (rows[r] == rows[c]) d[rows[r]] += values_[block.values + r * block.size + c];
    }
  }

 private:
  /// Where its rows and values begin, and the number of its rows.
  struct Block {
    std::size_t rows, values, size;
  };
  const PairPoints<D>& points_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> rows_;  ///< degrees of freedom
  std::vector<float> values_;
};

}  // namespace ixos

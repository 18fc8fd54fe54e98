/// The tangent of two surfaces applied without a matrix.
#pragma once
#include <cstddef>
#include <vector>

#include "term/pair_points.hpp"

namespace ixos {

/// Keeps the matrix of each pair of a secondary and a primary segment. The points must outlive it.
class PairAction final : public TangentAction {
 public:
  explicit PairAction(const PairPoints& points) : points_(points) {}

  void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
    blocks_.clear();
    points_.for_each_block(segment, rule, kind, [&](const PairPoints::Block& block) { blocks_.push_back(block); });
  }
  void add_product(const double* x, double* y) const override {
    for (const PairPoints::Block& block : blocks_)
      for (std::size_t r = 0; r < 2 * block.count; ++r) {
        double sum = 0;
        for (std::size_t c = 0; c < 2 * block.count; ++c) sum += block.k[r][c] * x[dof(block, c)];
        y[dof(block, r)] += sum;
      }
  }
  /// A node can stand twice in a block.
  void add_diagonal(double* d) const override {
    for (const PairPoints::Block& block : blocks_)
      for (std::size_t r = 0; r < 2 * block.count; ++r)
        for (std::size_t c = 0; c < 2 * block.count; ++c)
          if (dof(block, r) == dof(block, c)) d[dof(block, r)] += block.k[r][c];
  }

 private:
  static std::size_t dof(const PairPoints::Block& block, std::size_t r) {
    return 2 * static_cast<std::size_t>(block.nodes[r / 2]) + r % 2;
  }
  const PairPoints& points_;
  std::vector<PairPoints::Block> blocks_;
};

}  // namespace ixos

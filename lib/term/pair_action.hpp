/// The tangent of two surfaces applied without a matrix.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "term/pair_points.hpp"

namespace ixos {

/// Keeps the matrix of each pair of a secondary and a primary patch. The points must outlive it.
template <std::size_t D>
class PairAction final : public TangentAction {
 public:
  explicit PairAction(const PairPoints<D>& points) : points_(points) {}

  /// Throws std::logic_error unless the rule has points.
  void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
    if (rule.mean != Mean::Points) throw std::logic_error("the action of a pair of surfaces is for rules with points");
    blocks_.clear();
    points_.for_each_block(segment, rule, kind, [&](const PairBlock& block) { blocks_.push_back(block); });
  }
  void add_product(const double* x, double* y) const override {
    std::vector<double> own;
    for (const PairBlock& block : blocks_) {
      const std::size_t size = D * block.nodes.size();
      own.resize(size);
      for (std::size_t c = 0; c < size; ++c) own[c] = x[dof(block, c)];
      for (std::size_t r = 0; r < size; ++r) {
        const double* const row = block.k.data() + r * size;
        double sum = 0;
        for (std::size_t c = 0; c < size; ++c) sum += row[c] * own[c];
        y[dof(block, r)] += sum;
      }
    }
  }
  /// A node can stand twice in a block.
  void add_diagonal(double* d) const override {
    for (const PairBlock& block : blocks_) {
      const std::size_t size = D * block.nodes.size();
      for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = 0; c < size; ++c)
          if (dof(block, r) == dof(block, c)) d[dof(block, r)] += block.k[r * size + c];
    }
  }

 private:
  static std::size_t dof(const PairBlock& block, std::size_t r) {
    return D * static_cast<std::size_t>(block.nodes[r / D]) + r % D;
  }
  const PairPoints<D>& points_;
  std::vector<PairBlock> blocks_;
};

}  // namespace ixos

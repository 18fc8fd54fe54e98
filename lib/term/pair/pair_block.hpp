/// The matrix of a part of two surfaces.
#pragma once
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "discretization/pattern.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The matrix of a part of both surfaces: its nodes, a node may stand twice, and D nodes rows of as many numbers.
struct PairBlock {
  std::size_t secondary = 0;  ///< patch with the points
  int primary = -1;           ///< patch with the closest points
  std::vector<int> nodes;     ///< local
  std::vector<double> k;
  int next = -1;  ///< primary patch with closest points at another time, whose nodes stand here, too; -1: none
};

/// Calls a function for each matrix of a tangent.
using PairBlocks =
    std::function<void(const Segment&, const Rule&, Tangent, const std::function<void(const PairBlock&)>&)>;

/// Adds a block to matrix values of the pattern. Leaves out nodes that it does not couple.
template <std::size_t D>
void add_to_matrix(const PairBlock& block, const Pattern& pattern, double* values) {
  const std::size_t size = D * block.nodes.size();
  for (std::size_t a = 0; a < block.nodes.size(); ++a)
    for (std::size_t b = 0; b < block.nodes.size(); ++b) {
      const int offset = pattern.coupled_offset(block.nodes[a], block.nodes[b]);
      if (offset < 0) continue;
      const int stride = pattern.stride(block.nodes[a]);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          values[offset + static_cast<int>(i) * stride + static_cast<int>(j)] +=
              block.k[(D * a + i) * size + D * b + j];
    }
}

/// Adds to a local array the sum of |k_rc| over each row of a block.
template <std::size_t D>
void add_row_sums(const PairBlock& block, double* sums) {
  const std::size_t size = D * block.nodes.size();
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c < size; ++c)
      sums[D * static_cast<std::size_t>(block.nodes[r / D]) + r % D] += std::abs(block.k[r * size + c]);
}

}  // namespace ixos

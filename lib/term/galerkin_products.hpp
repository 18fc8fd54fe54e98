/// Matrices of linear cells or sides, added to a matrix of the space of their coarse cells.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/coarse_space.hpp"
#include "discretization/element_batches.hpp"

namespace ixos {

/// The prolongation from the coarse cells' corners to the N nodes of a batch of fine cells: by node and corner. It is
/// zero for fine cells that do not count on this rank.
template <std::size_t N>
using Prolongation = Small<Pack, N>;

/// Returns P^T k P for a matrix with M rows and columns for each node.
template <std::size_t N, std::size_t M>
Small<Pack, N * M> galerkin_product(const Prolongation<N>& prolongation, const Small<Pack, N * M>& k) {
  Small<Pack, N * M> half{}, result{};
  for (std::size_t r = 0; r < N * M; ++r)
    for (std::size_t e = 0; e < N; ++e)
      for (std::size_t q = 0; q < N; ++q)
        for (std::size_t j = 0; j < M; ++j) half[r][q * M + j] += k[r][e * M + j] * prolongation[e][q];
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t p = 0; p < N; ++p)
      for (std::size_t i = 0; i < M; ++i)
        for (std::size_t c = 0; c < N * M; ++c) result[p * M + i][c] += prolongation[a][p] * half[a * M + i][c];
  return result;
}

/// Adds matrices of fine cells to values of the coarse space's Pattern. owned(batch) is 1 for fine cells that this rank
/// adds, else 0; set_matrix(batch, prolongation, k) sets the batch's matrices k of the coarse cells' corners by degrees
/// of freedom. Throws std::logic_error if the nodes of a fine cell are no part of one coarse cell.
template <std::size_t N, std::size_t D, class Owned, class SetMatrix>
void add_galerkin_products(const ElementBatches<N, D>& batches, const CoarseSpace& coarse, const Owned& owned,
                           const SetMatrix& set_matrix, double* values) {
  constexpr auto width = ElementBatches<N, D>::width;
  std::vector<int> nodes;
  nodes.reserve(batches.cells() * N);
  std::vector<Prolongation<N>> all(batches.size());
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (std::size_t lane = 0; lane < width; ++lane) {
      const auto node = [&](std::size_t a) { return static_cast<std::size_t>(batches.first_dof(b, a, lane)) / D; };
      std::size_t middle = node(0);  // the node that all corners of the coarse cell move
      const auto corners = [&](std::size_t n) { return coarse.shares_end(n) - coarse.shares_begin(n); };
      for (std::size_t a = 1; a < N; ++a)
        if (corners(node(a)) > corners(middle)) middle = node(a);
      if (corners(middle) != static_cast<std::ptrdiff_t>(N))
        throw std::logic_error("a cell or side has no coarse cell");
      const auto *const first = coarse.shares_begin(middle), *const last = coarse.shares_end(middle);
      for (std::size_t a = 0; a < N; ++a) {
        for (std::size_t p = 0; p < N; ++p) all[b][a][p][lane] = 0;
        for (const auto* share = coarse.shares_begin(node(a)); share != coarse.shares_end(node(a)); ++share) {
          const auto* const corner =
              std::find_if(first, last, [&](const auto& other) { return other.corner == share->corner; });
          if (corner == last) throw std::logic_error("the nodes of a cell or side belong to several coarse cells");
          all[b][a][static_cast<std::size_t>(corner - first)][lane] = share->weight;
        }
      }
      if (lane < batches.lanes(b))
        for (const auto* corner = first; corner != last; ++corner) nodes.push_back(corner->corner);
    }
  const ElementBatches<N, D> coarse_cells(nodes, coarse.pattern());
  for (std::size_t b = 0; b < coarse_cells.size(); ++b) {
    for (auto& row : all[b])
      for (Pack& share : row) share *= owned(b);
    Small<Pack, N * D> k;
    set_matrix(b, all[b], k);
    coarse_cells.scatter_tangent(b, k, values);
  }
}

}  // namespace ixos

/// Matrices of the corners of quadratic cells or sides, added to a matrix of the coarse space.
#pragma once
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/coarse_space.hpp"
#include "discretization/element_batches.hpp"
#include "fem/corner_element.hpp"

namespace ixos {

/// Adds matrices of the first C nodes of each cell or side to values of the coarse space's Pattern. set_matrix(batch,
/// k) sets the batch's matrices k, nodes by degrees of freedom in rows and columns.
template <std::size_t C, std::size_t N, std::size_t D, class SetMatrix>
void add_corner_matrices(const ElementBatches<N, D>& batches, const CoarseSpace& coarse, const SetMatrix& set_matrix,
                         double* values) {
  std::vector<int> nodes;
  nodes.reserve(batches.cells() * C);
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (std::size_t lane = 0; lane < batches.lanes(b); ++lane)
      for (std::size_t a = 0; a < C; ++a)
        nodes.push_back(coarse.number(batches.first_dof(b, a, lane) / static_cast<int>(D)));
  const ElementBatches<C, D> corners(nodes, coarse.pattern());
  for (std::size_t b = 0; b < corners.size(); ++b) {
    Small<Pack, C * D> k;
    set_matrix(b, k);
    corners.scatter_tangent(b, k, values);
  }
}

/// Returns P^T k P of a matrix on the nodes of a quadratic element, with P its corner_shares().
template <class Element>
auto on_corners(const Small<Pack, Element::nodes>& k) {
  constexpr std::size_t C = CornerElement<Element>::type::nodes;
  static const auto shares = corner_shares<Element>();
  Small<Pack, C> result{};
  for (std::size_t a = 0; a < Element::nodes; ++a)
    for (std::size_t e = 0; e < Element::nodes; ++e)
      for (std::size_t p = 0; p < C; ++p)
        for (std::size_t q = 0; q < C; ++q) result[p][q] += (shares[a][p] * shares[e][q]) * k[a][e];
  return result;
}

}  // namespace ixos

/// The cells of a block in SIMD batches, at their quadrature points.
#pragma once
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/cell_quadrature.hpp"
#include "discretization/element_batches.hpp"
#include "discretization/pattern.hpp"
#include "mesh/local_mesh.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The data of a block that all its terms need: places for gathering and scattering, and the geometry of a kernel.
template <class Kernel>
struct BlockCells {
  using Element = typename Kernel::Shape;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  using Nodal = typename Kernel::template Nodal<Pack>;
  using CellTangent = typename Kernel::template Tangent<Pack>;
  using Geometry = typename Kernel::template Geometry<Pack>;

  /// `points`: quadrature points along an edge of a cell; 0 for the element's own number.
  BlockCells(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern, int points)
      : batches(block.nodes, pattern, node_scales(block)), table(cell_rule<Element>(block, points), block.tied) {
    geometry.reserve(batches.size());
    owned.reserve(batches.size());
    for (std::size_t b = 0; b < batches.size(); ++b) {
      geometry.push_back(Kernel::geometry(table, gathered(b, mesh.coordinates.data())));
      owned.emplace_back(
          [&](auto lane) { return lane < batches.lanes(b) && block.owned[number(b, lane)] != 0 ? 1.0 : 0.0; });
    }
  }
  BlockCells(const BlockCells&) = delete;  // geometries may refer to the table
  BlockCells& operator=(const BlockCells&) = delete;

  std::size_t size() const { return batches.size(); }
  /// Returns the number of a lane's cell in the block.
  static std::size_t number(std::size_t b, std::size_t lane) { return b * static_cast<std::size_t>(pack_width) + lane; }

  /// Returns the nodal values of a local array in a batch.
  Nodal gathered(std::size_t b, const double* local) const {
    Nodal values;
    batches.gather(b, local, values);
    return values;
  }

  /// Adds the sums of the magnitudes of a tangent's rows.
  void scatter_row_sums(std::size_t b, const CellTangent& tangent, double* sums) const {
    Nodal rows{};
    for (std::size_t r = 0; r < N * D; ++r)
      for (std::size_t c = 0; c < N * D; ++c) rows[r / D][r % D] += std::experimental::abs(tangent[r][c]);
    batches.scatter_force(b, rows, sums);
  }
  /// Adds the diagonal of a tangent.
  void scatter_diagonal(std::size_t b, const CellTangent& tangent, double* diagonal) const {
    Nodal values;
    for (std::size_t r = 0; r < N * D; ++r) values[r / D][r % D] = tangent[r][r];
    batches.scatter_diagonal(b, values, diagonal);
  }

  ElementBatches<N, D> batches;
  typename Kernel::Table table;
  std::vector<Geometry> geometry;  ///< by batch
  std::vector<Pack> owned;         ///< by batch: 1 for cells whose energy counts on this rank, else 0
};

/// A segment's arrays at one batch; absent arrays stay null.
template <class Kernel>
class GatheredSegment {
 public:
  GatheredSegment(const ElementBatches<Kernel::N, Kernel::D>& batches, std::size_t b, const Segment& segment)
      : has_from_(segment.from != nullptr),
        has_velocity_(segment.velocity != nullptr),
        has_iterate_(segment.iterate != nullptr),
        way_(segment.way) {
    batches.gather(b, segment.to, to_);
    if (has_from_) batches.gather(b, segment.from, from_);
    if (has_velocity_) batches.gather(b, segment.velocity, velocity_);
    if (has_iterate_) batches.gather(b, segment.iterate, iterate_);
  }
  typename Kernel::template Segment<Pack> segment() const {
    return {has_from_ ? &from_ : nullptr, has_velocity_ ? &velocity_ : nullptr, &to_,
            has_iterate_ ? &iterate_ : nullptr, way_};
  }

 private:
  bool has_from_, has_velocity_, has_iterate_;
  double way_;
  typename BlockCells<Kernel>::Nodal to_, from_, velocity_, iterate_;
};

}  // namespace ixos

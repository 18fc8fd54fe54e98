/// Numbers that terms keep at quadrature points from step to step.
#pragma once
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/record.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Numbers at the quadrature points of a block's local cells, in SIMD batches of cells like ElementBatches. Cells that
/// several ranks see have the same numbers on each, since each of them computes them alike. Zero at first.
class PointData {
 public:
  /// `numbers`: at each point.
  PointData(const LocalBlock& block, std::size_t points, std::size_t numbers);

  Pack& operator()(std::size_t batch, std::size_t point, std::size_t number = 0) {
    return data_[(batch * points_ + point) * numbers_ + number];
  }
  const Pack& operator()(std::size_t batch, std::size_t point, std::size_t number = 0) const {
    return data_[(batch * points_ + point) * numbers_ + number];
  }
  void clear();

  /// Writes the numbers with those of their cells in the mesh, or reads them, from another partition too: each rank
  /// then reads all cells of the block. Throws InputError if the checkpoint does not fit the block. Collective.
  void transfer(Record& record);

 private:
  std::vector<double> cell_by_cell() const;
  void set_cell(std::size_t cell, const double* values);

  std::vector<int> cells_;  ///< per local cell: its number in the block of the mesh
  int global_cells_;        ///< of the block
  std::size_t points_, numbers_;
  std::vector<Pack> data_;  ///< batches x points x numbers
};

}  // namespace ixos

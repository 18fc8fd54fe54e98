/// Numbers that terms keep at quadrature points from step to step.
#pragma once
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/record.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Numbers at the quadrature points of cells or sides, in SIMD batches like ElementBatches. Cells that several ranks
/// see have the same numbers on each, since each of them computes them alike. Zero at first.
class PointData {
 public:
  /// Those of a block's local cells; `numbers`: at each point.
  PointData(const LocalBlock& block, std::size_t points, std::size_t numbers);
  /// Those of sides of the local cells, or of a whole side set.
  PointData(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points, std::size_t numbers);

  Pack& operator()(std::size_t batch, std::size_t point, std::size_t number = 0) {
    return data_[(batch * points_ + point) * numbers_ + number];
  }
  const Pack& operator()(std::size_t batch, std::size_t point, std::size_t number = 0) const {
    return data_[(batch * points_ + point) * numbers_ + number];
  }
  bool operator==(const PointData& other) const;
  void clear() { fill(0); }
  void fill(double value);  ///< sets all numbers

  /// Writes the numbers with those of their cells in the mesh, or reads them, from another partition too: each rank
  /// then reads those of all ranks. Throws InputError if the checkpoint does not fit the cells. Collective.
  void transfer(Record& record);

 private:
  std::vector<double> cell_by_cell() const;
  void set_cell(std::size_t cell, const double* values);

  PointData(std::vector<double> cells, std::size_t points, std::size_t numbers);

  std::vector<double> cells_;  ///< per local cell or side: a number that tells it from others in the mesh
  std::size_t points_, numbers_;
  std::vector<Pack> data_;  ///< batches x points x numbers
};

}  // namespace ixos

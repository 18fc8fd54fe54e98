/// Numbers that terms keep at quadrature points from step to step.
#pragma once
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/record.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// A cell of the Mesh, or a side of it, whose points keep numbers.
struct PointOwner {
  int block = 0, cell = 0;
  int side = -1;  ///< -1: the cell itself
  int part = 0;   ///< see LocalSide
};

/// Numbers at the quadrature points of cells or sides, in SIMD batches like ElementBatches. Cells that several ranks
/// see have the same numbers on each, since each of them computes them alike. Zero at first.
class PointData {
 public:
  /// Those of a block's local cells; `numbers`: at each point.
  PointData(const LocalBlock& block, std::size_t points, std::size_t numbers);
  /// Those of sides of the local cells, or of a whole side set.
  PointData(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points, std::size_t numbers);
  /// Those of any cells or sides.
  PointData(std::vector<PointOwner> owners, std::size_t points, std::size_t numbers);

  const std::vector<PointOwner>& owners() const { return owners_; }
  std::size_t points() const { return points_; }
  std::size_t numbers() const { return numbers_; }
  /// Returns the numbers of one cell or side after the other: points x numbers.
  std::vector<double> cell_by_cell() const;
  /// Sets those of one.
  void set_cell(std::size_t cell, const double* values);

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
  std::vector<double> cells() const;

  std::vector<PointOwner> owners_;
  std::size_t points_, numbers_;
  std::vector<Pack> data_;  ///< batches x points x numbers
};

}  // namespace ixos

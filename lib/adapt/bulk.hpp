/// Where the strain changes inside the bodies.
#pragma once
#include <vector>

#include "adapt/split_mesh.hpp"

namespace ixos {

/// The jumps of the displacement gradient from cell to cell of a split mesh, as a recovered gradient shows them
/// (Zienkiewicz and Zhu 1987): at each node the mean of the cells of its block around it, less that of the cell.
class BulkStrain {
 public:
  /// `u`: displacements, nodes x dimension [L0]. `directions`: the number of axes along which cells are split. The mesh
  /// must outlive the object.
  BulkStrain(const SplitMesh& mesh, const std::vector<double>& u, int directions);

  /// Returns the jump of a cell of the mesh, or what another cell of its trees would have: jumps are in proportion to
  /// the edges, and a larger cell has that of its worst part.
  double jump(const TreeCell& cell) const;

 private:
  double in(int k, const TreeCell& cell) const;

  const SplitMesh& mesh_;
  int directions_;
  std::vector<double> jumps_;  ///< by cell of the tree; leaves only
};

}  // namespace ixos

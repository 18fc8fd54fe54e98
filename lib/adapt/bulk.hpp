/// Where the strain changes inside the bodies.
#pragma once
#include <vector>

#include "adapt/split_mesh.hpp"

namespace ixos {

/// The jumps of the displacement gradient from cell to cell of a split mesh, as a recovered gradient shows them
/// (Zienkiewicz and Zhu 1987): at each node the mean of the cells around it, less that of the cell.
class BulkStrain {
 public:
  /// `u`: displacements, nodes x dimension [L0]. The mesh must outlive the object.
  BulkStrain(const SplitMesh& mesh, const std::vector<double>& u);

  /// Returns the largest jump that a cell of the tree, or of another one, has if it is a cell of the mesh: of a smaller
  /// cell its part in proportion to the edges, of a larger one likewise more than its largest part.
  double jump(const TreeCell& cell) const;

 private:
  double in(int k, const TreeCell& cell) const;

  const SplitMesh& mesh_;
  std::vector<double> jumps_;  ///< by cell of the tree; leaves only
};

}  // namespace ixos

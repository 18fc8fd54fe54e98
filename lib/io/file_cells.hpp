/// Cells as mesh files have them.
#pragma once
#include <utility>
#include <vector>

#include "fem/cell_traits.hpp"
#include "mesh/mesh.hpp"
#include "mesh/middles.hpp"

namespace ixos {

/// A type of cells of a file.
struct FileCells {
  CellType type;           ///< whose first nodes these are; quadratic cells without nodes inside lack the rest
  std::vector<int> order;  ///< by node of the cell: its place in the file
  int nodes() const { return static_cast<int>(order.size()); }
};

/// Return the cells of that shape with so many nodes, in Exodus order, or of gmsh's type. Null for types with which
/// Ixos does not compute.
const FileCells* exodus_cells(ReferenceShape shape, int nodes);
const FileCells* gmsh_cells(int type);

/// Returns the mesh as files have it: cells with bubbles without the nodes that these add.
Mesh without_bubbles(Mesh mesh);

/// Adds cells of files to a mesh whose coordinates are known, and the nodes that some lack: 8, 20, 15 and 13 nodes
/// become 9, 27, 18 and 14.
class FileCellReader {
 public:
  explicit FileCellReader(Mesh& mesh) : mesh_(mesh), middles_(mesh) {}
  /// Appends cells with their nodes in the order of the file, numbered as in the mesh.
  void add(const FileCells& cells, const std::vector<int>& nodes, ElementBlock& block);
  /// Adds nodes that cells lacked to the node sets that hold all corners beside them. Returns what the nodes' values
  /// are sums of.
  std::vector<Middles::Sum> finish();

 private:
  Mesh& mesh_;
  Middles middles_;
};

}  // namespace ixos

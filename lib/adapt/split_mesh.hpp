/// A mesh whose cells are parts of those of another mesh.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/splitting/split_tree.hpp"

namespace ixos {

/// Returns the reference coordinates of a node of a cell, those of an enriched side included; nothing of a node that
/// stands for a derivative. The third is 0 in the plane.
std::optional<std::array<double, 3>> reference_place(CellType type, std::size_t node);

/// A whole mesh, as enrich() left it, the mesh before its cells were split, and the trees that lead from one to the
/// other.
class SplitMesh {
 public:
  /// `tree`: its leaves are the cells of `mesh`. Throws std::logic_error if they are not.
  SplitMesh(Mesh base, Mesh mesh, SplitTree tree);

  const Mesh& base() const { return base_; }
  const Mesh& mesh() const { return mesh_; }
  const SplitTree& tree() const { return tree_; }

  /// A cell of the mesh.
  struct Cell {
    int block = 0, cell = 0;
  };
  /// Returns the cell that a leaf is, and the leaf that a cell is, by its number in the tree.
  const Cell& cell_of(int leaf) const { return cells_[static_cast<std::size_t>(leaf)]; }
  int leaf_of(const Cell& cell) const;
  /// Returns the face of the unsplit cell on which a side of a cell lies, see TreeCell::faces(); one inside a box is
  /// named as if it lay outside, one inside a simplex by the number of its faces.
  int face_of(const Cell& cell, int side) const;

  /// Returns the point at reference coordinates of a cell, and the reference coordinates of a point of it.
  RootPoint root_point(const Cell& cell, const std::array<double, 3>& xi) const;
  std::array<double, 3> reference_point(const Cell& cell, const RootPoint& point) const;

  /// Returns the point of each node of the mesh; nothing of nodes that are none of a cell's own places.
  const std::vector<std::optional<RootPoint>>& places() const { return places_; }

 private:
  /// The linear map from reference coordinates of a cell to places in its root: coordinates from `first` to `first` +
  /// `length` lead from the origin along their axes.
  struct Axes {
    RootPlace origin{};
    std::array<RootPlace, 3> along{};
    double first = 0, length = 1;
  };
  Axes axes_of(const Cell& cell) const;
  void find_cells();
  void find_places();

  Mesh base_, mesh_;
  SplitTree tree_;
  std::vector<Cell> cells_;               ///< by cell of the tree; meaningful for leaves
  std::vector<std::vector<int>> leaves_;  ///< by block and cell
  std::vector<std::optional<RootPoint>> places_;
};

}  // namespace ixos

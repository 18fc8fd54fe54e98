/// Cells that are split, again and again: boxes along their own axes, simplices through the middles of edges.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/splitting/longest_edges.hpp"
#include "mesh/splitting/middle_nodes.hpp"
#include "mesh/splitting/refined_region.hpp"
#include "mesh/splitting/split_tree.hpp"
#include "mesh/splitting/tree_cell.hpp"

namespace ixos {

/// A node of a quadratic cell that stands between two others of the cell.
struct CellMiddle {
  int node, low, high;
  std::array<double, 3> place;  ///< from 0 to 1 along the cell's axes
};

/// Returns all of a quadrilateral, or of a hexahedron: edges, then faces, then the inside, each along the edges that
/// cross it: a node in the middle of a face is between two pairs of others.
const std::vector<CellMiddle>& cell_middles(int dimension);

/// Returns a vector along a cell's axis, the sum of its edges [L0]; the third component is 0 in the plane.
std::array<double, 3> direction_of(const Mesh& mesh, const TreeCell& cell, int axis);

/// The cells of a mesh as trees whose leaves are the cells of a finer one. New nodes stand where the shape functions of
/// the mesh's cells put them; those of quadratic cells are the nodes of the halves as far as they go. Prisms, pyramids
/// and the cells beside them stay whole.
class CellTree {
 public:
  /// Adds nodes to the mesh, whose cells are all linear or all quadratic, and which must outlive the tree.
  explicit CellTree(Mesh& mesh);

  /// Returns the axes along which a leaf is to be halved at once, of a simplex any one; none if it may stay.
  using Wish = std::function<std::vector<int>(const TreeCell& leaf)>;

  /// Splits leaves until the wish names no axis for any, no edge of a simplex has a corner of others, no edge of a box
  /// more than one, in its middle, and no two cross each other on a face. A leaf that is split for the others' sake
  /// alone is halved in all directions if `in_all_directions`. Around cells that stay whole the levels rise as the
  /// others allow, whatever is wished. Throws InputError if that makes more cells than `most`.
  void split(const Wish& wish, bool in_all_directions, long long most);

  /// Splits leaves until each has the halvings of the regions that it meets, and neighbours are as above. Throws
  /// InputError if that makes more cells than `most`, or a region meets no cell; `name` returns a region in words.
  void split(const std::vector<RegionSearch>& regions, const std::vector<std::string>& names, long long most);

  /// Returns about how many leaves split() makes for one region, without those around it. Splits level by level, of
  /// each level at most `sample` cells, which stand for the others. The tree is of no use then.
  double forecast(const RegionSearch& region, std::size_t sample);

  /// Keeps split(), as far as that can be, from lowering the levels that cells have in other trees of the same cells.
  void keep_levels(const SplitTree& trees);
  /// Returns the number of cells of the mesh of which split() did not split all parts that it was asked to: those
  /// beside and near prisms and pyramids.
  int bounded() const { return static_cast<int>(std::count(bounded_.begin(), bounded_.end(), 1)); }

  /// Calls visit(leaf) for the leaves of a cell of the mesh, in order.
  template <class Visit>
  void for_each_leaf(int block, int cell, const Visit& visit) const {
    visit_leaves(root(block, cell), visit);
  }
  template <class Visit>
  void for_each_leaf(const Visit& visit) const {
    for (int k = 0; k < roots_; ++k) visit_leaves(k, visit);
  }

  int dimension() const { return mesh_.dimension; }
  /// Returns a cell of the mesh.
  const TreeCell& whole(int block, int cell) const { return cells_[at(root(block, cell))]; }
  /// Returns the trees as a value.
  SplitTree trees() const { return {mesh_.dimension, cells_, first_root_}; }
  /// Returns the axes that `wanted` has more halvings along than the cell, of those the ones with the fewest.
  std::vector<int> axes_to_halve(const TreeCell& cell, const std::array<int, 3>& wanted) const;
  /// Returns the axes along which a leaf is to be halved for the regions that it meets, and notes these.
  std::vector<int> wanted_axes(const TreeCell& cell, const std::vector<RegionSearch>& regions);
  MiddleNodes& middles() { return middles_; }
  /// Returns whether the node is a corner of a leaf, or was one before it was split.
  bool is_corner(int node) const { return static_cast<std::size_t>(node) < corner_.size() && corner_[at(node)] != 0; }
  /// Returns the node in the middle of two of a leaf's nodes, made if there is none at that place.
  int middle(const TreeCell& leaf, int a, int b, const RootPlace& place);
  /// Returns the pairs of bits of a box's edges along an axis.
  const std::vector<std::array<int, 2>>& edges(int axis) const { return edges_[at(axis)]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int root(int block, int cell) const { return first_root_[at(block)] + cell; }
  template <class Visit>
  void visit_leaves(int cell, const Visit& visit) const {
    const TreeCell& own = cells_[at(cell)];
    if (!own.is_split()) return visit(own);
    visit_leaves(own.first_child, visit);
    visit_leaves(own.first_child + 1, visit);
  }
  std::vector<int> leaves() const;
  void add_roots();
  void bound_levels();
  /// Returns the largest level of the parts of each cell of the mesh.
  std::vector<int> levels_of(const std::vector<TreeCell>& cells) const;
  bool may_be_split(const TreeCell& cell) const { return cell.level() < most_[at(root(cell.block, cell.root))]; }
  void lower_bounds();
  bool grow(const Wish& wish, bool in_all_directions, long long most);
  void undo();
  void bisect_simplex(int cell);
  bool has_middle_on_an_edge(const TreeCell& cell);
  std::vector<int> axes_for_others(const TreeCell& cell, const std::set<std::array<int, 2>>& crossed,
                                   bool in_all_directions);
  void halve(int cell, const std::vector<int>& axes);
  void bisect(int cell, int axis);
  CornerBox box_of(const TreeCell& cell) const;
  std::array<int, 3> asked_halvings(const TreeCell& cell, const RegionSearch& region) const;
  bool balance(bool in_all_directions);
  void refuse_more_than(long long most) const;
  std::set<std::array<int, 2>> crossing_edges();
  bool has_one_of(const std::set<std::array<int, 2>>& edges, const TreeCell& cell, int axis) const;
  bool has_two_on_an_edge(const TreeCell& cell, int axis);

  Mesh& mesh_;
  const std::vector<ElementBlock> blocks_;  ///< as they were
  const std::size_t coordinates_;           ///< the mesh's own, as many as it had
  std::vector<int> first_root_;             ///< by block
  int roots_ = 0;
  std::vector<TreeCell> cells_;
  MiddleNodes middles_;
  const LongestEdges longest_;
  std::vector<char> corner_;  ///< by node
  std::vector<std::vector<std::array<int, 2>>> edges_;
  std::vector<char> met_;      ///< by region: some cell meets it
  std::vector<int> most_;      ///< by root: the level that its parts may have
  std::vector<int> torn_;      ///< roots that neighbours would split beyond that level
  std::vector<int> kept_;      ///< by root: the level below which that is not lowered; empty: 0
  std::vector<char> bounded_;  ///< by root: a wish was not granted
};

}  // namespace ixos

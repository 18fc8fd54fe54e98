/// Cells that are split, and their parts.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fem/cell_traits.hpp"

namespace ixos {

/// Reference coordinates of a cell of the mesh that is split, see ReferenceShape; the third is 0 in the plane.
using RootPlace = std::array<double, 3>;

/// How parts of a cell are split.
enum class TreeShape : char {
  Box,      ///< quadrilaterals and hexahedra: halved along an axis
  Simplex,  ///< triangles and tetrahedra: bisected through the middle of an edge
  Whole     ///< prisms and pyramids: never
};

/// Returns how cells of a shape are split.
TreeShape tree_shape(ReferenceShape shape);

/// The edges of a triangle or a tetrahedron that bisections follow (Arnold, Mukherjee, Pouly 2000, SIAM J. Sci. Comput.
/// 22): each face of a tetrahedron has a marked edge, that of the triangle between both is the same in both cells, so
/// that neighbours conform, and there are finitely many shapes of parts. Corners count from 0.
struct MarkedEdges {
  using Edge = std::array<std::uint8_t, 2>;
  Edge refinement{};            ///< the one that is halved next
  std::array<Edge, 4> faces{};  ///< of a tetrahedron, by the corner across the face
  bool flagged = false;         ///< of a tetrahedron whose marked edges lie in one plane: its parent's did, too

  /// Returns those of the part at one end of the refinement edge, 0 or 1. The middle takes the other end's place.
  MarkedEdges of_part(int end, int corners) const;
};

/// A cell of a mesh, or a part of one.
struct TreeCell {
  int block = 0, root = 0;  ///< the cell of the mesh
  TreeShape shape = TreeShape::Box;
  std::int8_t count = 0;  ///< of its corners
  /// Nodes. Those of a box stand in the order of bits: bit k tells the end along the cell's axis k.
  std::array<int, 8> corners{};
  std::array<int, 3> halvings{};        ///< of a box along each axis; of a simplex the number of bisections, 0 and 0
  RootPlace lower{}, upper{};           ///< of a box: its place
  int first_child = -1;                 ///< two cells, one behind the other; -1: not split
  std::array<RootPlace, 4> vertices{};  ///< of a simplex: the places of its corners
  MarkedEdges marks{};                  ///< of a simplex
  std::uint64_t path = 0;               ///< of a simplex: by bits, the ends at which it lay, the last one lowest

  int dimension() const { return shape == TreeShape::Simplex ? count - 1 : count == 4 ? 2 : 3; }
  bool is_split() const { return first_child >= 0; }
  /// Returns the halvings along the axis that has most of them, or the bisections.
  int level() const { return std::max({halvings[0], halvings[1], halvings[2]}); }
  /// Returns the place of a corner of a box or a simplex.
  RootPlace place(int corner) const;
  /// Returns the mean of the places of some corners of a box or a simplex.
  RootPlace middle_place(const std::vector<int>& some) const;
  /// Returns the least distance of a point from the faces of a box, in the coordinates of its root, the least share of
  /// a corner of a simplex in it, and 0 for others; negative outside.
  double depth(const RootPlace& point) const;
  /// Returns whether another part of the same cell of the mesh lies in this one.
  bool contains(const TreeCell& other) const;
  /// Returns whether this is the same part of the same cell of a mesh.
  bool is_same_part(const TreeCell& other) const;

  /// The faces of the cell of the mesh. Those of a box are 2 axis + end, those of a simplex the corner across.
  int faces() const { return shape == TreeShape::Simplex ? count : 2 * dimension(); }
  /// Returns the corners of a box's own face across that axis, or those of a simplex that lie on the face.
  std::vector<int> corners_on(int face) const;
  /// Returns whether the cell has a face on that face.
  bool touches(int face) const;
};

/// Returns the barycentric coordinates of a point of a cell of the mesh that is a simplex of D dimensions.
std::array<double, 4> barycentric(const RootPlace& point, int dimension);

/// The most bisections of a simplex, so that its path goes into two numbers of 31 bits.
constexpr int most_bisections = 62;

/// Returns the part of a simplex at one end of its refinement edge, 0 or 1, whose middle is that node.
TreeCell simplex_part(const TreeCell& whole, int end, int middle);

}  // namespace ixos

/// The sides of a mesh's cells, found by their corners.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// The corners of a side; if sorted, in ascending order, and -1 comes first where a side has two corners or three.
using SideCorners = std::array<int, 4>;

/// A side of a cell. Enriched and quadratic cells have the sides of linear ones.
struct CellSide {
  SideCorners corners;
  int cell;   ///< number of the cell over all blocks, from 0
  Side side;  ///< the same cell by block, and its side
  bool operator<(const CellSide& other) const { return corners < other.corners; }
};

/// A range of sides with the same corners.
using EqualSides = std::pair<std::vector<CellSide>::const_iterator, std::vector<CellSide>::const_iterator>;

/// Returns the nodes of a side of a cell: the corners, counter-clockwise seen from outside, then the others.
std::vector<int> nodes_of_side(const Mesh& mesh, const Side& side);

/// Returns the side of a quadrilateral or hexahedron that has no corner of that side. Throws std::logic_error for
/// others.
int opposite_side(CellType type, int side);

/// Returns the corners of a side in the order of a linear cell, see side_nodes(); -1 follows in place of missing ones.
SideCorners corners_of(const Mesh& mesh, const Side& side);

/// Returns how many of a side's corners are there.
std::size_t count_of(const SideCorners& corners);

/// Returns a vector along the outward normal of a side between its corners, in 3D the product of its diagonals, of
/// a triangle that of two edges: twice the area long, in 2D as long as the side. Its third component is 0 in 2D.
std::array<double, 3> outward_normal(const Mesh& mesh, const Side& side);

/// Returns the corners of a side, of 2 to 4 nodes.
SideCorners sorted_corners(const std::vector<int>& nodes);
SideCorners sorted_corners(const Mesh& mesh, const Side& side);

/// Returns the mean of the corners of a side; the third coordinate is 0 in two dimensions.
std::array<double, 3> centre_of(const Mesh& mesh, const SideCorners& corners);

/// Returns every side of every cell, sorted by corners: neighbours share theirs. Among sides with the same corners that
/// of the first cell comes first.
std::vector<CellSide> sorted_sides(const Mesh& mesh);

/// Returns the sides with these corners: none, one (on the boundary), or two.
EqualSides sides_with(const std::vector<CellSide>& sorted, const SideCorners& corners);

/// Returns the sides that only one cell has, in the order of the cells, without Mesh::hanging_sides: the boundary of
/// the mesh.
std::vector<Side> boundary_sides(const Mesh& mesh);

}  // namespace ixos

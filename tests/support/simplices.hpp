/// Meshes of triangles, tetrahedra, prisms and pyramids for tests.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos::test {

/// Returns a mesh of linear quadrilaterals or hexahedra, a grid as box() makes it, with its cells split. `kind`:
/// - "triangles", "quads and triangles": two triangles for each quadrilateral, or for those of the right half;
/// - "tetrahedra": six for each hexahedron, around its diagonal; "prisms": two; "pyramids": six around a new node;
/// - "twelve tetrahedra": around a new node, faces cut at their corner of the lowest number; not only of a grid;
/// - "hexahedra to tetrahedra": hexahedra at the left, one layer of cells with pyramids and two tetrahedra each, then
///   tetrahedra;
/// - "hexahedra and prisms": hexahedra in the left half, prisms in the right.
/// Blocks keep their names; side sets and node sets are those of the same places.
Mesh split_cells(const Mesh& cubes, const std::string& kind);

/// Moves the nodes inside the box around a mesh by up to `by` [L0], each in its own direction; those on its sides stay.
void distort(Mesh& mesh, double by);

/// Bends all edges of quadratic cells: moves every node by a smooth field of up to `by` [L0], those on the sides of the
/// box around it within them.
void bend(Mesh& mesh, double by);

}  // namespace ixos::test

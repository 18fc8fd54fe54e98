/// Meshes of quadratic cells from meshes of linear ones.
#pragma once
#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Turns the linear cells of a mesh into quadratic ones, see raised_type(): adds a node in the middle of each edge,
/// face and cell, behind the mesh's own nodes. Cells share the nodes of the edges and faces that they share, also with
/// cells that are quadratic already; those stay as they are, but with `bubbles` get the nodes that Tri7 and its like
/// have beyond Tri6, where the cell's own map puts them. The new nodes of linear cells stand at the mean of their
/// corners, so the body keeps its shape. Side sets keep their sides. A node set that has the nodes of the side set of
/// its name keeps having them; another one gets the middles of the edges and faces whose corners it all holds. Throws
/// InputError if the mesh is enriched, or would get nodes although it has ties.
void raise_order(Mesh& mesh, bool bubbles = false);

/// Does that with the quadratic cells of a mesh alone.
void add_bubbles(Mesh& mesh);

/// Puts the nodes that cells with bubbles have beyond others where the cells' quadratic maps have them: elsewhere they
/// would raise the degree of the Jacobian, and the cells would fail the patch test.
void place_bubbles(Mesh& mesh);
/// Throws InputError, with the node, if one of them stands elsewhere, by more than 1e-9 of its cell's size.
void require_placed_bubbles(const Mesh& mesh);

/// Throws InputError, with two blocks, if the mesh has linear and quadratic cells, or in space quadratic ones with
/// nodes in the middle of triangles and ones without: they do not conform.
void require_one_order(const Mesh& mesh);

/// Throws InputError, with the elements counted from 1 over all blocks, if two quadratic cells share the corners of an
/// edge or a face but not its middle node, or if a middle node is also a corner: the body would open there. Meshes that
/// raise_order() made need no check.
void require_shared_middles(const Mesh& mesh);
/// Does the same for the cells that a rank has, with the program's ids of nodes.
void require_shared_middles(const LocalMesh& mesh);

}  // namespace ixos

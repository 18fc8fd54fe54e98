/// Meshes for gmsh.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// Writes a file of gmsh's format MSH 4.1, ASCII. Each block becomes a physical group of the mesh's dimension, with
/// all cells of its name; each side set one of one dimension less; each node set one of points, unless it has the name
/// and the nodes of a side set: read_gmsh_mesh() makes it from that. Another one of that name is called <name>_nodes,
/// or <name>_nodes_2 if a set has that name. Nodes and cells keep their order but for blocks of one name, which come
/// together. Cells with bubbles are written without the nodes that these add. Throws InputError if a name has a quote
/// or a line break, or if the mesh is enriched; FileError.
void write_gmsh_mesh(const Mesh& mesh, const std::string& path);

}  // namespace ixos

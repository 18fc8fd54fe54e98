/// Meshes in files of gmsh.
#pragma once
#include <string>

#include "mesh/generators/entry.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Reads a file of gmsh's format MSH 4.1, ASCII or binary, with quadrilaterals of 4 nodes in the plane z = 0 (2D) or
/// hexahedra of 8 nodes (3D). Physical groups keep their names: those of the mesh's dimension become blocks, those of
/// one dimension less side sets and node sets, those of lower dimensions node sets. Cells without a group belong to
/// the block "body". Groups without a name are called block_<tag>, surface_<tag> and nodelist_<tag>. A side between two
/// cells counts for the first of them. Nodes that no cell has are left out with a note. Every rank may call it. Throws
/// InputError, with the file and the fault, for a file that cannot be read or is not as the format demands, for other
/// cells (the message says how gmsh recombines triangles and tetrahedra), cells in two groups, names given twice,
/// elements of a group that are no sides of cells, and groups whose elements together have more nodes than ten times
/// the file's bytes.
Mesh read_gmsh_mesh(const std::string& path);

inline constexpr const char* gmsh_mesh_name = "Gmsh";

/// Returns the entry of the catalogue of meshes. It takes drawings, too, see drawn_mesh().
MeshEntry gmsh_mesh();

/// Lets gmsh make the mesh of the drawing that a list of that entry names, if it is one, so that others find it. Throws
/// as drawn_mesh() does.
void prepare_drawing(const SceneNode& node);

}  // namespace ixos

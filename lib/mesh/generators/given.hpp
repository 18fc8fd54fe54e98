/// The entry of the catalogue of meshes for meshes that a program provides.
#pragma once
#include <string>

#include "mesh/generators/entry.hpp"

namespace ixos {

/// The entry's name, "Given".
extern const char* const given_mesh_name;

/// Returns the entry. Its parameter "Dimension" is the dimension of the program's mesh; making the mesh throws
/// InputError, because the command has none.
MeshEntry given_mesh();

/// Throws InputError, with the name of the block or set, the number and what is allowed, unless the arrays of a mesh
/// fit each other: finite coordinates of two or three dimensions; blocks of QUAD4 or HEX8 of that dimension, with at
/// least one cell and with nodes that exist; names that are not empty and not given twice; sets of sides and nodes that
/// exist, each once; no node without a cell. Reports numbers from 0, as the arrays have them.
void check_arrays(const Mesh& mesh);

}  // namespace ixos

/// Meshes in Exodus files.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Reads blocks of QUAD4 (two-dimensional files) or HEX8 (three-dimensional ones), node sets and side sets. Blocks and
/// sets without a name are called block_<id>, nodelist_<id> and surface_<id>. Every rank may call it. Throws
/// InputError, with the file and what is wrong, for a file that is not there, not Exodus, truncated or inconsistent:
/// node or element numbers out of range, ids or names given twice, nodes that belong to no cell, other element types.
/// netCDF and HDF5 are not safe against files that were made to harm: another process tries it first.
Mesh read_exodus_mesh(const std::string& path);

/// The same without that trial.
Mesh read_tried_exodus_mesh(const std::string& path);

/// Writes blocks and sets. Throws FileError.
void write_exodus_mesh(const Mesh& mesh, const std::string& path, const std::string& title);

}  // namespace ixos

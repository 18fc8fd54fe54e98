/// Meshes that a scene reads from files.
#pragma once
#include <string>

#include "mesh/generators/entry.hpp"

namespace ixos {

/// Returns an entry of the catalogue of meshes that reads a file. Its parameters are "File", a path that this process
/// can open, "Dimension" and "Length Unit". `read`: reads the mesh; throws InputError with the path of the file.
MeshEntry mesh_file_entry(const std::string& name, const std::string& sentence, Mesh (*read)(const std::string& path));

/// Returns whether the entry reads a file.
bool reads_file(const MeshEntry& entry);

}  // namespace ixos

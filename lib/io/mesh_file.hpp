/// Meshes in files.
#pragma once
#include <functional>
#include <string>

#include "mesh/generators/entry.hpp"

namespace ixos {

/// Returns an entry of the catalogue of meshes that reads a file. Its parameters are "File", a path that this process
/// can open, "Dimension" and "Length Unit", and what `declare` adds. `read`: reads the mesh, given the entry's list,
/// too; throws InputError with the path of the file.
MeshEntry mesh_file_entry(const std::string& name, const std::string& sentence,
                          const std::function<Mesh(const SceneNode& node, const std::string& path)>& read,
                          const std::function<void(Teuchos::ParameterList& list)>& declare = {});

/// Writes a file of gmsh if the path ends in .msh, see write_gmsh_mesh(), or else of Exodus, see write_exodus_mesh().
void write_mesh(const Mesh& mesh, const std::string& path, const std::string& title);

/// Returns what a file of the mesh does not say, for the user: that nodes follow others; empty if none does.
std::string lost_ties(const Mesh& mesh);

/// Returns whether the entry reads a file.
bool reads_file(const MeshEntry& entry);

}  // namespace ixos

/// Meshes in Exodus files.
#pragma once
#include <string>
#include <vector>

#include "mesh/generators/entry.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Reads blocks of cells, see cells_of(), node sets and side sets. Blocks and sets without a name are called
/// block_<id>, nodelist_<id> and surface_<id>; ids may have 64 bits. A file of three dimensions whose cells are
/// triangles and quadrilaterals in the plane z = 0 is a mesh of two dimensions. Cells that are numbered as mirror
/// images are turned, see turn_cells(). Blocks of lower dimension than the cells (points, lines, and faces beside the
/// cells of a volume) and nodes that no cell has are left out, with notes. Nodes that cells of 8, 13, 15 and 20 nodes
/// lack are added behind the others. Every rank may call it. Throws InputError, with the file and the fault, for a file
/// that does not exist, is not Exodus, or is truncated or inconsistent: node or element numbers out of range, ids or
/// names given twice, other element types, shells beside cells of a volume. netCDF and HDF5 are not safe against
/// malicious files: another process tries to read the file first.
Mesh read_exodus_mesh(const std::string& path);

/// Read as read_exodus_mesh() and read_exodus_field() do, without the trial in another process.
Mesh read_tried_exodus_mesh(const std::string& path);
std::vector<double> read_tried_exodus_field(const std::string& path, const std::string& name);

/// Returns the nodal variable of that name at the file's last time, by node of the mesh that read_exodus_mesh()
/// returns. Throws InputError likewise, and if the file has no such variable: then it names those of the file.
std::vector<double> read_exodus_field(const std::string& path, const std::string& name);

/// Writes blocks and sets under their own names, so that a scene finds them again; further blocks of a name get a
/// number. Cells with bubbles are written without the nodes that these add. Throws FileError.
void write_exodus_mesh(const Mesh& mesh, const std::string& path, const std::string& title);

/// Returns the entry of the catalogue of meshes. Its parameter "File" must be a path that this process can open.
MeshEntry exodus_mesh();

}  // namespace ixos

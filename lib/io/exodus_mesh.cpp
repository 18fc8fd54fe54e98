#include "io/exodus_mesh.hpp"

#include <numeric>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "io/mesh_file.hpp"

namespace ixos {

void write_exodus_mesh(const Mesh& mesh, const std::string& path, const std::string& title) {
  const int id = create_exodus(path);
  if (id < 0) throw FileError(path + ": cannot be written");
  ExodusHandle file(id, path);
  ExodusShare share;
  share.node_ids.resize(static_cast<std::size_t>(mesh.nodes()));
  share.cell_ids.resize(static_cast<std::size_t>(mesh.cells()));
  std::iota(share.node_ids.begin(), share.node_ids.end(), 1);
  std::iota(share.cell_ids.begin(), share.cell_ids.end(), 1);
  define_exodus_mesh(file, mesh, share, title);
  require_written(file.close(), file, "the mesh");
  sync_to_disk(path);
}

MeshEntry exodus_mesh() {
  return mesh_file_entry("Exodus", "A mesh of QUAD4 (2D) or HEX8 (3D) elements, read from an Exodus file.",
                         read_exodus_mesh);
}

}  // namespace ixos

#include "io/exodus_mesh.hpp"

#include <fmt/format.h>

#include <numeric>
#include <set>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "io/file_cells.hpp"
#include "io/mesh_file.hpp"

namespace ixos {
namespace {

/// Gives blocks of one name different names.
void name_blocks(Mesh& mesh) {
  std::set<std::string> taken, named;
  for (const ElementBlock& block : mesh.blocks) taken.insert(block.name);
  for (ElementBlock& block : mesh.blocks) {
    const std::string own = block.name;
    if (!named.insert(own).second)
      for (int k = 2; !taken.insert(block.name).second; ++k) block.name = fmt::format("{}_{}", own, k);
  }
}

}  // namespace

void write_exodus_mesh(const Mesh& given, const std::string& path, const std::string& title) {
  Mesh mesh = without_bubbles(given);
  name_blocks(mesh);
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
  return mesh_file_entry("Exodus",
                         "A mesh read from an Exodus file: triangles and quadrilaterals (2D), tetrahedra, prisms, "
                         "pyramids and hexahedra (3D), of first or second order.",
                         [](const SceneNode&, const std::string& path) { return read_exodus_mesh(path); });
}

}  // namespace ixos

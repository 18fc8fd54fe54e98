#include "io/exodus_mesh.hpp"

#include <fmt/format.h>

#include <numeric>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "mesh/soundness.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"

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
  struct Parameters {
    std::string file = required;
    int dimension = 0;
    double length_unit = 1;
  };
  Options<Parameters> options;
  options
      .add("File", &Parameters::file, "Path of the mesh file, relative to the scene's folder or to the working folder.")
      .add("Dimension", &Parameters::dimension, "Dimension that the mesh must have: 2 or 3. With 0, both are accepted.",
           between(0, 3))
      .add("Length Unit", &Parameters::length_unit,
           "Unit of the coordinates in the file [L0], for example \"1 um\". Ixos multiplies them by it.",
           greater_than(0));
  return {"Exodus", "A mesh of QUAD4 (2D) or HEX8 (3D) elements, read from an Exodus file.", "", options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            Mesh mesh = at("Mesh", [&] { return read_exodus_mesh(p.file); });
            at("Mesh: " + p.file, [&] { refuse_repeated_cells(mesh); });
            if (p.dimension != 0 && p.dimension != mesh.dimension)
              node.refuse("File", fmt::format("{} is a mesh of {} dimensions, but the scene wants {}", p.file,
                                              mesh.dimension, p.dimension));
            if (p.length_unit != 1)
              for (double& coordinate : mesh.coordinates) coordinate *= p.length_unit;
            return mesh;
          }};
}

}  // namespace ixos

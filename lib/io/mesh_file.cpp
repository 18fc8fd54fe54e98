#include "io/mesh_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "io/exodus_mesh.hpp"
#include "io/gmsh_writer.hpp"
#include "mesh/soundness.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"

namespace ixos {

MeshEntry mesh_file_entry(const std::string& name, const std::string& sentence,
                          const std::function<Mesh(const SceneNode& node, const std::string& path)>& read,
                          const std::function<void(Teuchos::ParameterList& list)>& declare) {
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
  Teuchos::ParameterList list = options.list();
  if (declare) declare(list);
  return {{name, sentence, "", list, [options, read](const SceneNode& node) {
             const Parameters p = options.read(node);
             Mesh mesh = read(node, p.file);
             at(p.file, [&] { refuse_repeated_cells(mesh); });
             if (p.dimension != 0 && p.dimension != mesh.dimension)
               node.refuse("File", fmt::format("{} is a mesh of {} dimensions, but the scene wants {}", p.file,
                                               mesh.dimension, p.dimension));
             if (p.length_unit != 1)
               for (double& coordinate : mesh.coordinates) coordinate *= p.length_unit;
             return mesh;
           }}};
}

void write_mesh(const Mesh& mesh, const std::string& path, const std::string& title) {
  if (std::filesystem::path(path).extension() == ".msh")
    write_gmsh_mesh(mesh, path);
  else
    write_exodus_mesh(mesh, path, title);
}

std::string lost_ties(const Mesh& mesh) {
  if (mesh.ties.empty()) return "";
  return fmt::format(
      "{} of the mesh's nodes follow others: they hang on coarser cells, or lie on periodic sides or tied surfaces. "
      "The "
      "file does not say so, and a program that reads it moves them freely.",
      mesh.ties.size());
}

bool reads_file(const MeshEntry& entry) { return entry.parameters.isParameter("File"); }

}  // namespace ixos

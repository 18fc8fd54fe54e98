#include "scene/scene_mesh.hpp"

#include <filesystem>

#include "io/mesh_file.hpp"
#include "mesh/quality.hpp"
#include "scene/mesh_sets.hpp"

namespace ixos {
#define ENTRY(name) MeshEntry name();
#include "scene/mesh_entries.def"
#undef ENTRY

const Catalogue<MeshEntry>& meshes() {
#define ENTRY(name) name(),
  static const Catalogue<MeshEntry> catalogue("Type",
                                              "Selects a mesh generator, or the format of a mesh file (Exodus, Gmsh).",
                                              {
#include "scene/mesh_entries.def"
                                              });
#undef ENTRY
  return catalogue;
}

Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder) {
  const SceneNode node(list, "Mesh");
  const MeshEntry& chosen = meshes().chosen(node);
  if (reads_file(chosen)) {
    std::string& path = list.sublist(chosen.name).get<std::string>("File");
    const auto beside = std::filesystem::path(scene_folder) / path;
    path = std::filesystem::absolute(std::filesystem::exists(beside) ? beside : std::filesystem::path(path))
               .lexically_normal()
               .string();
  }
  Mesh mesh = meshes().make(node);
  at("Mesh", [&] { check_cells(mesh); });
  add_sets(node.sublist("Sets"), mesh);
  return mesh;
}

}  // namespace ixos

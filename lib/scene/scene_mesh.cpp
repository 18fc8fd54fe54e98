#include "scene/scene_mesh.hpp"

#include <filesystem>

#include "io/exodus_mesh.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

void add_sets(const SceneNode& sets, Mesh& mesh) {
  for (const SceneNode& own : sets.sublists()) {
    const Region region{own.numbers("Lower"), own.numbers("Upper")};
    at(own.path(), [&] {
      if (own.text("Kind") == "Sides")
        add_side_set(mesh, own.name(), own.text("From"), region);
      else
        add_node_set(mesh, own.name(), own.text("From"), region);
    });
  }
}

}  // namespace

#define ENTRY(name) MeshEntry name();
#include "scene/mesh_entries.def"
#undef ENTRY

const Catalogue<MeshEntry>& meshes() {
#define ENTRY(name) name(),
  static const Catalogue<MeshEntry> catalogue("Type", "Selects a mesh generator, or a mesh file (Exodus).",
                                              {
#include "scene/mesh_entries.def"
                                              });
#undef ENTRY
  return catalogue;
}

Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder) {
  if (list.get<std::string>("Type") == "Exodus") {
    std::string& path = list.sublist("Exodus").get<std::string>("File");
    const auto beside = std::filesystem::path(scene_folder) / path;
    path = std::filesystem::absolute(std::filesystem::exists(beside) ? beside : std::filesystem::path(path))
               .lexically_normal()
               .string();
  }
  Mesh mesh = meshes().make(SceneNode(list, "Mesh"));
  at("Mesh", [&] { check_cells(mesh); });
  add_sets(SceneNode(list.sublist("Sets"), "Mesh/Sets"), mesh);
  return mesh;
}

}  // namespace ixos

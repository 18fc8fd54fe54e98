#include "scene/scene_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

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

std::string size_note(const Teuchos::ParameterList& list, const Mesh& mesh, const UnitSystem& units) {
  if (!reads_file(meshes().chosen(SceneNode(list, "Mesh")))) return {};
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<std::string> plain, si;
  for (std::size_t i = 0; i < d; ++i) {
    double lower = mesh.coordinates[i], upper = lower;
    for (std::size_t k = i; k < mesh.coordinates.size(); k += d) {
      lower = std::min(lower, mesh.coordinates[k]);
      upper = std::max(upper, mesh.coordinates[k]);
    }
    plain.push_back(fmt::format("{:.6g}", upper - lower));
    si.push_back(units.text(upper - lower, "L0"));
  }
  return fmt::format("the mesh spans {} L0 = {}", fmt::join(plain, " x "), fmt::join(si, " x "));
}

}  // namespace ixos

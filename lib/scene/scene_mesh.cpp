#include "scene/scene_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/mesh_file.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"
#include "parameters/validation.hpp"
#include "scene/mesh_map.hpp"
#include "scene/mesh_sets.hpp"
#include "scene/obstacle_files.hpp"
#include "scene/parameters.hpp"

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

namespace {

/// Makes the mesh with the order of cells that the list asks for.
Mesh make_mesh(const SceneNode& node, const MeshEntry& chosen) {
  if (node.count(cell_order) == 2 && chosen.make_quadratic) {
    const SceneNode own = node.sublist(chosen.name);
    return at(own.path(), [&] { return chosen.make_quadratic(own); });
  }
  return meshes().make(node);
}

/// Raises the order of the cells if the list asks for it, applies the map, checks the cells and adds the sets.
void finish(const SceneNode& node, Mesh& mesh) {
  if (node.count(cell_order) == 2) raise_order(mesh);
  at("Mesh", [&] {
    require_one_order(mesh);
    require_shared_middles(mesh);
  });
  map_nodes(node.sublist("Map"), mesh);
  at("Mesh", [&] { check_cells(mesh); });
  add_sets(node.sublist("Sets"), mesh);
}

}  // namespace

Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder) {
  const SceneNode node(list, "Mesh");
  const MeshEntry& chosen = meshes().chosen(node);
  if (reads_file(chosen)) {
    std::string& path = list.sublist(chosen.name).get<std::string>("File");
    path = path_beside(scene_folder, path);
  }
  Mesh mesh = make_mesh(node, chosen);
  mesh.axisymmetric = is_axisymmetric(list);
  finish(node, mesh);
  return mesh;
}

Mesh scene_mesh(const Teuchos::ParameterList& list, Mesh given) {
  given.axisymmetric = given.axisymmetric || is_axisymmetric(list);
  at("Mesh", [&] {
    check_arrays(given);
    refuse_repeated_cells(given);
  });
  finish(SceneNode(list, "Mesh"), given);
  return given;
}

Teuchos::ParameterList with_given_mesh(const Teuchos::ParameterList& scene, int dimension, bool axisymmetric) {
  Teuchos::ParameterList result(scene);
  if (result.isParameter("Mesh") && !result.isSublist("Mesh")) return result;  // the validation refuses it
  Teuchos::ParameterList& mesh = result.sublist("Mesh");
  mesh.set(meshes().choice(), std::string(given_mesh_name));
  discard_left_out(mesh, scene_parameters().sublist("Mesh"), meshes().choice());
  mesh.sublist(given_mesh_name).set("Dimension", dimension);
  if (axisymmetric) mesh.set(geometry_choice, std::string(axisymmetric_geometry));
  return result;
}

bool is_axisymmetric(const Teuchos::ParameterList& mesh) {
  return mesh.isType<std::string>(geometry_choice) && mesh.get<std::string>(geometry_choice) == axisymmetric_geometry;
}

bool is_from_outside(const MeshEntry& entry) { return reads_file(entry) || entry.name == given_mesh_name; }

std::string size_note(const Teuchos::ParameterList& list, const Mesh& mesh, const UnitSystem& units) {
  if (!is_from_outside(meshes().chosen(SceneNode(list, "Mesh")))) return {};
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

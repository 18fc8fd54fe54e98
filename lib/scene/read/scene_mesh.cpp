#include "scene/read/scene_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "io/gmsh_mesh.hpp"
#include "io/mesh_file.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/name_pattern.hpp"
#include "mesh/periodic_sides.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"
#include "mesh/tied_nodes.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"
#include "scene/read/mesh_parts.hpp"
#include "scene/read/mesh_refinement.hpp"
#include "scene/read/mesh_sets.hpp"
#include "scene/read/obstacle_files.hpp"
#include "scene/read/parameters.hpp"
#include "time/catalogue.hpp"

namespace ixos {
#define ENTRY(name) MeshEntry name();
#include "scene/read/mesh_entries.def"
#undef ENTRY

const Catalogue<MeshEntry>& meshes() {
#define ENTRY(name) name(),
  static const Catalogue<MeshEntry> catalogue(
      "Type", "Selects a mesh generator, the format of a mesh file (Exodus, Gmsh), or several of them (Parts, Array).",
      {
#include "scene/read/mesh_entries.def"
          parts_mesh(), array_mesh()});
#undef ENTRY
  return catalogue;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls tie(secondary, primary, tolerance) for each list of `pairs`. Throws InputError with its path.
template <class Tying>
void for_each_pair(const SceneNode& pairs, const Mesh& mesh, const Tying& tie) {
  for (const SceneNode& own : pairs.sublists()) {
    for (const char* name : {"Side Set", "Primary Side Set"})
      if (own.text(name).empty()) throw InputError(fmt::format("{} is missing; give it a side set", own.path_of(name)));
    at(own.path(), [&] {
      tie(own.text("Side Set"), own.text("Primary Side Set"), own.number("Tolerance"));
      resolved_ties(mesh);  // refuses loops
    });
  }
}

/// Checks the cells, and adds sets and ties.
void finish(const SceneNode& node, Mesh& mesh) {
  at(node.path(), [&] { check_cells(mesh); });
  add_sets(node.sublist("Sets"), mesh);
  add_pattern_sets(set_patterns(node.list()), mesh);
  for_each_pair(node.sublist("Ties"), mesh, [&](const std::string& set, const std::string& primary, double tolerance) {
    tie_surfaces(mesh, set, primary, tolerance);
  });
  if (!node.sublist("Ties").sublists().empty()) at(node.path_of("Ties"), [&] { check_cells(mesh); });  // nodes moved
  PeriodicNodes left;
  for_each_pair(node.sublist("Periodic"), mesh,
                [&](const std::string& set, const std::string& primary, double tolerance) {
                  const PeriodicNodes own = make_periodic(mesh, set, primary, tolerance);
                  left.insert(left.end(), own.begin(), own.end());
                });
  at(node.path_of("Periodic"), [&] { require_periodic(mesh, left); });
}

/// Looks for the file of the mesh of one body, if it has one.
void find_file(Teuchos::ParameterList& body, const std::string& scene_folder) {
  const MeshEntry& chosen = meshes().chosen(SceneNode(body, "Mesh"));
  if (!reads_file(chosen)) return;
  std::string& path = body.sublist(chosen.name).get<std::string>("File");
  path = path_beside(scene_folder, path);
}

/// Calls visit(list) for the list of the mesh, or of each of its parts.
template <class Visit>
void for_each_body(Teuchos::ParameterList& mesh, const Visit& visit) {
  const std::string type = mesh.get<std::string>(meshes().choice());
  if (!has_parts(type)) return visit(mesh);
  Teuchos::ParameterList& parts = mesh.sublist(type);
  for (const auto& [name, entry] : entries(parts))
    if (entry.isList()) visit(parts.sublist(name));
}

void find_files(Teuchos::ParameterList& mesh, const std::string& scene_folder) {
  for_each_body(mesh, [&](Teuchos::ParameterList& body) { find_file(body, scene_folder); });
}

}  // namespace

bool needs_bubbles(const Teuchos::ParameterList& scene) {
  for (const auto& [name, entry] : entries(scene.isSublist("Materials") ? scene.sublist("Materials") : scene)) {
    if (!entry.isList()) continue;
    const Teuchos::ParameterList& material = Teuchos::getValue<Teuchos::ParameterList>(entry);
    if (material.isType<std::string>("Element Formulation") &&
        material.get<std::string>("Element Formulation") == "Mean Dilatation")
      return true;
  }
  if (!scene.isSublist("Time Integrator")) return false;
  const Teuchos::ParameterList& integrator = scene.sublist("Time Integrator");
  const auto chosen = [&](const Scheme& scheme) {
    return integrator.isType<std::string>("Type") && integrator.get<std::string>("Type") == scheme.name;
  };
  const auto found = std::find_if(schemes().begin(), schemes().end(), chosen);
  return found != schemes().end() && found->table(found->parameters).mass == Inertia::Lumped;
}

void prepare_drawings(Teuchos::ParameterList list, const std::string& scene_folder) {
  find_files(list, scene_folder);
  for_each_body(list, [](Teuchos::ParameterList& body) {
    const SceneNode node(body, "Mesh");
    if (meshes().chosen(node).name == gmsh_mesh_name) prepare_drawing(node.sublist(gmsh_mesh_name));
  });
}

Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder, bool bubbles, Splitting splitting) {
  find_files(list, scene_folder);
  const SceneNode node(list, "Mesh");
  splitting.regions = refined_regions(node.sublist("Refine"));
  Mesh mesh = mapped_mesh(meshes(), node, node.count(cell_order), splitting);
  mesh.axisymmetric = is_axisymmetric(list);
  if (bubbles) add_bubbles(mesh);
  finish(node, mesh);
  return mesh;
}

Mesh scene_mesh(const Teuchos::ParameterList& list, Mesh given, bool bubbles, Splitting splitting) {
  given.axisymmetric = given.axisymmetric || is_axisymmetric(list);
  at("Mesh", [&] {
    check_arrays(given);
    refuse_repeated_cells(given);
  });
  const SceneNode node(list, "Mesh");
  splitting.regions = refined_regions(node.sublist("Refine"));
  apply_order_and_map(node, node.count(cell_order), splitting, given);
  if (bubbles) at("Mesh", [&] { add_bubbles(given); });
  finish(node, given);
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

bool is_from_outside(const SceneNode& list) {
  const MeshEntry& entry = meshes().chosen(list);
  return reads_file(entry) || entry.name == given_mesh_name;
}

std::string size_note(const Teuchos::ParameterList& list, const Mesh& mesh, const UnitSystem& units) {
  const std::vector<SceneNode> lists = part_lists(SceneNode(list, "Mesh"));
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<std::string> notes;
  for (const SceneNode& own : lists) {
    if (!is_from_outside(own)) continue;
    std::vector<double> lower(d, infinity), upper(d, -infinity);
    for (const ElementBlock& block : mesh.blocks)
      for (std::size_t k = 0; k < (list_of(block, lists).path() == own.path() ? block.nodes.size() * d : 0); ++k) {
        const double x = mesh.coordinates[static_cast<std::size_t>(block.nodes[k / d]) * d + k % d];
        lower[k % d] = std::min(lower[k % d], x);
        upper[k % d] = std::max(upper[k % d], x);
      }
    std::vector<std::string> plain, si;
    for (std::size_t i = 0; i < d; ++i) {
      plain.push_back(fmt::format("{:.6g}", upper[i] - lower[i]));
      si.push_back(units.text(upper[i] - lower[i], "L0"));
    }
    notes.push_back(fmt::format("the {} spans {} L0 = {}",
                                own.path() == "Mesh" ? "mesh" : "part \"" + own.name() + "\"", fmt::join(plain, " x "),
                                fmt::join(si, " x ")));
  }
  return fmt::format("{}", fmt::join(notes, "; "));
}

}  // namespace ixos

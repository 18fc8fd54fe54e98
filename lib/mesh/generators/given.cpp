#include "mesh/generators/given.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "mesh/given_sets.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

void check_coordinates(const Mesh& mesh) {
  if (mesh.dimension != 2 && mesh.dimension != 3)
    throw InputError(fmt::format("the points have {} coordinates; 2 or 3 are allowed", mesh.dimension));
  const auto d = static_cast<std::size_t>(mesh.dimension);
  if (mesh.coordinates.empty() || mesh.coordinates.size() % d != 0)
    throw InputError(
        fmt::format("{} coordinates are not those of points in {} dimensions", mesh.coordinates.size(), d));
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k)
    if (!std::isfinite(mesh.coordinates[k]))
      throw InputError(fmt::format("point {} has the coordinate {}; it must be finite", k / d, mesh.coordinates[k]));
}

void check_node(const Mesh& mesh, int node, const std::string& place) {
  if (node < 0 || node >= mesh.nodes())
    throw InputError(
        fmt::format("{} has node {}; the points are numbered from 0 to {}", place, node, mesh.nodes() - 1));
}

void check_blocks(const Mesh& mesh) {
  if (mesh.blocks.empty()) throw InputError("the mesh has no blocks; at least one is needed");
  std::vector<bool> used(static_cast<std::size_t>(mesh.nodes()), false);
  for (const ElementBlock& block : mesh.blocks) {
    const std::string place = "block \"" + block.name + "\"";
    if (cell_info(block.type).dimension != mesh.dimension || is_enriched(block.type))
      throw InputError(fmt::format(
          "{}: its cells have {} nodes; in {} dimensions cells have {}", place, nodes_per_cell(block.type),
          mesh.dimension, mesh.dimension == 2 ? "3, 4, 6, 7 or 9" : "4, 5, 6, 8, 10, 14, 15, 18, 19, 21 or 27"));
    if (block.nodes.empty() || block.nodes.size() % static_cast<std::size_t>(nodes_per_cell(block.type)) != 0)
      throw InputError(fmt::format("{}: {} node numbers are not those of cells with {} nodes", place,
                                   block.nodes.size(), nodes_per_cell(block.type)));
    for (const int node : block.nodes) {
      check_node(mesh, node, place);
      used[static_cast<std::size_t>(node)] = true;
    }
  }
  for (std::size_t node = 0; node < used.size(); ++node)
    if (!used[node]) throw InputError(fmt::format("point {} belongs to no cell; remove it", node));
}

void check_sets(const Mesh& mesh) {
  for (const NodeSet& set : mesh.node_sets) {
    std::set<int> seen;
    for (const int node : set.nodes) {
      check_node(mesh, node, "node set \"" + set.name + "\"");
      if (!seen.insert(node).second) throw InputError(fmt::format("node set \"{}\" has node {} twice", set.name, node));
    }
  }
  std::vector<SideLimits> limits;
  limits.reserve(mesh.blocks.size());
  for (const ElementBlock& block : mesh.blocks)
    limits.push_back({static_cast<std::size_t>(block.cells()), sides_per_cell(block.type)});
  for (const SideSet& set : mesh.side_sets) check_sides(set, limits);
}

}  // namespace

const char* const given_mesh_name = "Given";

MeshEntry given_mesh() {
  struct Parameters {
    int dimension = 2;
  };
  Options<Parameters> options;
  options.add("Dimension", &Parameters::dimension, "Dimension of the program's mesh: 2 or 3.", between(2, 3));
  return {{given_mesh_name,
           "A mesh from the arrays of a program that uses Ixos (C++ or Python); not for the command ixos.", "",
           options.list(), [](const SceneNode&) -> Mesh {
             throw InputError(
                 "a program provides this mesh, in C++ or Python; the command ixos has none. Run the scene "
                 "from that program, or have it write the mesh to a file and set Type to Exodus");
           }}};
}

void check_arrays(const Mesh& mesh) {
  check_coordinates(mesh);
  std::map<CellType, std::vector<ElementBlock>> alike;  // a body part has one block for each type of its cells
  for (const ElementBlock& block : mesh.blocks) alike[block.type].push_back({block.name, block.type, {}});
  for (const auto& [type, blocks] : alike) check_names(blocks, "block");
  check_names(mesh.node_sets, "node set");
  check_names(mesh.side_sets, "side set");
  check_blocks(mesh);
  check_sets(mesh);
}

}  // namespace ixos

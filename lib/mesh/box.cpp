#include <fmt/format.h>

#include <map>
#include <set>

#include "base/error.hpp"
#include "mesh/generators.hpp"

namespace ixos {
namespace {

void check(const BoxShape& shape) {
  if (shape.dimension != 2 && shape.dimension != 3)
    throw InputError(fmt::format("box: dimension {} must be 2 or 3", shape.dimension));
  for (std::size_t d = 0; d < static_cast<std::size_t>(shape.dimension); ++d) {
    if (!(shape.lengths[d] > 0)) throw InputError(fmt::format("box: length {} must be positive", shape.lengths[d]));
    if (shape.divisions[d] < 1)
      throw InputError(fmt::format("box: divisions {} must be at least 1", shape.divisions[d]));
  }
  double nodes = 1;
  for (std::size_t d = 0; d < static_cast<std::size_t>(shape.dimension); ++d) nodes *= shape.divisions[d] + 1.0;
  if (nodes > 5e7) throw InputError(fmt::format("box: divisions make {:.3g} nodes; at most 5e7 are allowed", nodes));
}

/// Returns the names of the sides, by local side number.
std::vector<std::string> side_names(int dimension) {
  if (dimension == 2) return {"bottom", "right", "top", "left"};
  return {"front", "right", "back", "left", "bottom", "top"};
}

/// Returns whether the side of cell (i, j, k) is on the boundary of the box.
bool on_boundary(const std::string& name, const std::array<int, 3>& cell, const std::array<int, 3>& n, int dimension) {
  const std::size_t last = dimension == 2 ? 1 : 2;
  if (name == "left") return cell[0] == 0;
  if (name == "right") return cell[0] == n[0] - 1;
  if (name == "front") return cell[1] == 0;
  if (name == "back") return cell[1] == n[1] - 1;
  if (name == "bottom") return cell[last] == 0;
  return cell[last] == n[last] - 1;
}

}  // namespace

Mesh box(const BoxShape& shape) {
  check(shape);
  const bool flat = shape.dimension == 2;
  const std::array<int, 3> n{shape.divisions[0], shape.divisions[1], flat ? 1 : shape.divisions[2]};
  const int layers = flat ? 1 : n[2] + 1;
  const auto node = [&n](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };

  Mesh mesh;
  mesh.dimension = shape.dimension;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const std::array<int, 3> index{i, j, k};
        for (std::size_t d = 0; d < static_cast<std::size_t>(shape.dimension); ++d)
          mesh.coordinates.push_back(shape.lower[d] + shape.lengths[d] * index[d] / n[d]);
      }

  const CellType type = flat ? CellType::Quad4 : CellType::Hex8;
  ElementBlock body{"body", type, {}};
  std::map<std::string, SideSet> side_sets;
  std::map<std::string, std::set<int>> node_sets;
  const auto names = side_names(shape.dimension);
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::vector<int> cell{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)};
        if (!flat)
          for (int corner :
               {node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)})
            cell.push_back(corner);
        for (int s = 0; s < sides_per_cell(type); ++s) {
          const std::string& name = names[static_cast<std::size_t>(s)];
          if (!on_boundary(name, {i, j, k}, n, shape.dimension)) continue;
          for (const std::string& set : {name, std::string("surface")}) {
            side_sets[set].name = set;
            side_sets[set].sides.push_back({0, body.cells(), s});
            for (int local : side_nodes(type, s)) node_sets[set].insert(cell[static_cast<std::size_t>(local)]);
          }
        }
        body.nodes.insert(body.nodes.end(), cell.begin(), cell.end());
      }
  mesh.blocks.push_back(std::move(body));
  for (auto& [name, set] : side_sets) mesh.side_sets.push_back(std::move(set));
  for (const auto& [name, nodes] : node_sets) mesh.node_sets.push_back({name, {nodes.begin(), nodes.end()}});
  return mesh;
}

}  // namespace ixos

#include <fmt/format.h>

#include <map>
#include <set>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "mesh/generators/entry.hpp"
#include "mesh/generators/shapes.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

void check(const BoxShape& shape) {
  if (shape.dimension != 2 && shape.dimension != 3)
    throw InputError(fmt::format("dimension {} must be 2 or 3", shape.dimension));
  for (std::size_t d = 0; d < static_cast<std::size_t>(shape.dimension); ++d) {
    if (!(shape.lengths[d] > 0)) throw InputError(fmt::format("length {} must be positive", shape.lengths[d]));
    if (shape.divisions[d] < 1) throw InputError(fmt::format("divisions {} must be at least 1", shape.divisions[d]));
  }
  double nodes = 1;
  for (std::size_t d = 0; d < static_cast<std::size_t>(shape.dimension); ++d) nodes *= shape.divisions[d] + 1.0;
  if (nodes > 5e7) throw InputError(fmt::format("divisions make {:.3g} nodes; at most 5e7 are allowed", nodes));
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

struct Parameters {
  int dimension = 2;
  std::vector<double> lower, lengths{1.0, 1.0};
  std::vector<int> divisions{1, 1};
};

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

  const CellType type = cube_type(shape.dimension);
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

MeshEntry box_mesh() {
  Options<Parameters> options;
  options
      .add("Dimension", &Parameters::dimension,
           "Dimension of the box. 2: quadrilaterals in plane strain; 3: hexahedra.", between(2, 3))
      .add("Lower", &Parameters::lower, "Corner with the smallest coordinates [L0]. If empty, it is the origin.",
           any_number())
      .add("Lengths", &Parameters::lengths, "Edge lengths [L0].", greater_than(0))
      .add("Divisions", &Parameters::divisions, "Number of cells along each edge.", between(1, 100000));
  return {{"Box",
           "A box. It has the block \"body\" and the side and node sets \"left\", \"right\", \"bottom\", \"top\" and "
           "\"surface\"; in 3D also \"front\" and \"back\".",
           "", options.list(), [options](const SceneNode& node) {
             const Parameters p = options.read(node);
             BoxShape shape;
             shape.dimension = p.dimension;
             copy_values(node, "Lower", p.lower, p.dimension, shape.lower);
             copy_values(node, "Lengths", p.lengths, p.dimension, shape.lengths);
             copy_values(node, "Divisions", p.divisions, p.dimension, shape.divisions);
             return box(shape);
           }}};
}

}  // namespace ixos

#include "io/output_mesh.hpp"

#include <algorithm>
#include <array>

#include "fem/with_element.hpp"
#include "io/distinct_names.hpp"

namespace ixos {
namespace {

/// Returns the number of pieces into which a cell is cut along each direction of its contact side.
int divisions(CellType type) {
  switch (type) {
    case CellType::Quad4C2:
    case CellType::Hex8C2:
      return 2;
    case CellType::Quad4C3:
    case CellType::Hex8C3:
      return 3;
    case CellType::Quad4C4:
    case CellType::Quad4CH:
    case CellType::Hex8C4:
    case CellType::Hex8CH:
      return 4;
    default:
      return 1;
  }
}

/// Returns the number of cells into which one is cut.
int pieces(CellType type) {
  const int n = divisions(type);
  return corner_type(type) == CellType::Hex8 ? n * n : n;
}

/// Returns whether piece k of a cell has a part of the cell's side. Pieces are cells of the same sides.
bool has_part(CellType type, int k, int side) {
  const int n = divisions(type), i = k % n, j = k / n;
  if (corner_type(type) == CellType::Quad4) return side % 2 == 0 || i == (side == 1 ? n - 1 : 0);
  if (side == contact_side(type) || side > 3) return true;
  return side % 2 == 0 ? j == (side == 2 ? n - 1 : 0) : i == (side == 1 ? n - 1 : 0);
}

/// Returns the point of the cell at those reference coordinates, as nodes and weights.
std::vector<std::pair<int, double>> point_of(const LocalBlock& block, int cell, const std::array<double, 3>& place) {
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    std::array<double, Element::dimension> xi;
    std::copy_n(place.begin(), xi.size(), xi.begin());
    std::array<double, Element::nodes> value;
    std::array<std::array<double, Element::dimension>, Element::nodes> gradient;
    evaluate_tied<Element>(block.tied, xi, value, gradient);
    std::vector<std::pair<int, double>> combination;
    for (int a = 0; a < Element::nodes; ++a) {
      const double weight = node_scale(block, cell, a) * value[static_cast<std::size_t>(a)];
      if (weight != 0) combination.emplace_back(block.nodes[cell_entry(cell, Element::nodes, a)], weight);
    }
    return combination;
  });
}

}  // namespace

OutputMesh::OutputMesh(const LocalMesh& local, int ranks) : number_(static_cast<std::size_t>(local.nodes()), -1) {
  mesh.dimension = local.dimension;
  description.ranks = ranks;
  description.global_nodes = local.global_nodes;
  int cell_offset = 0;
  for (const LocalBlock& block : local.blocks) {
    const int parts = pieces(block.type);
    ElementBlock here;
    here.name = parts == 1 ? block.name : block.name + "_contact";
    here.type = parts == 1 ? block.type : corner_type(block.type);
    cells.emplace_back();
    first_cell_.emplace_back(static_cast<std::size_t>(block.cells()), -1);
    for (int cell = 0; cell < block.cells(); ++cell) {
      if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
      first_cell_.back()[static_cast<std::size_t>(cell)] = here.cells();
      add_cell(local, block, cell, cell_offset, here);
      cells.back().insert(cells.back().end(), static_cast<std::size_t>(parts), cell);
    }
    cell_offset += block.global_cells * parts;
    description.global_block_cells.push_back(block.global_cells * parts);
    mesh.blocks.push_back(std::move(here));
  }
  description.global_cells = cell_offset;
  // Room for the numbers of the nodes that cutting cells adds: see add_cell.
  if (local.plain_nodes >= 0) description.global_nodes += 3 * static_cast<long long>(cell_offset);
  add_sets(local);
  make_names_distinct(mesh);  // of blocks too: tied edges split blocks of one name
}

int OutputMesh::add_node(const LocalMesh& local, Combination combination, int id) {
  const auto d = static_cast<std::size_t>(local.dimension);
  for (std::size_t i = 0; i < d; ++i) {
    double x = 0;
    for (const auto& [node, weight] : combination)
      x += weight * local.coordinates[static_cast<std::size_t>(node) * d + i];
    mesh.coordinates.push_back(x);
  }
  description.node_ids.push_back(id);
  combinations_.push_back(std::move(combination));
  return static_cast<int>(combinations_.size()) - 1;
}

int OutputMesh::own_node(const LocalMesh& local, int node) {
  int& mine = number_[static_cast<std::size_t>(node)];
  if (mine < 0) mine = add_node(local, {{node, 1.0}}, local.original_ids[static_cast<std::size_t>(node)] + 1);
  return mine;
}

void OutputMesh::add_cell(const LocalMesh& local, const LocalBlock& block, int cell, int cell_offset,
                          ElementBlock& here) {
  const int n = nodes_per_cell(block.type);
  const int parts = pieces(block.type);
  const int first_id = cell_offset + block.original_cells[static_cast<std::size_t>(cell)] * parts + 1;
  for (int k = 0; k < parts; ++k) description.cell_ids.push_back(first_id + k);
  const auto node = [&](int a) { return own_node(local, block.nodes[cell_entry(cell, n, a)]); };
  if (parts == 1) {
    for (int a = 0; a < n; ++a) here.nodes.push_back(node(a));
    return;
  }
  // Numbers beyond those of all nodes, three for each piece: more than a cell adds.
  int id = static_cast<int>(local.global_nodes) + 3 * (first_id - 1);
  const bool solid = local.dimension == 3;
  const int divided = divisions(block.type), across = solid ? divided : 0;
  std::array<std::vector<int>, 2> layers;  // on the contact side, and on the side opposite
  for (std::size_t layer = 0; layer < 2; ++layer)
    for (int j = 0; j <= across; ++j)
      for (int i = 0; i <= divided; ++i) {
        std::array<double, 3> xi{-1 + 2.0 * i / divided, -1 + 2.0 * j / divided, layer == 0 ? -1.0 : 1.0};
        if (!solid) xi[1] = xi[2];
        Combination point = point_of(block, cell, xi);
        const bool own = point.size() == 1 && point.front().second == 1;
        layers[layer].push_back(own ? own_node(local, point.front().first) : add_node(local, std::move(point), ++id));
      }
  const auto [near, far] = layers;
  const auto row = static_cast<std::size_t>(divided) + 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(parts); ++k) {
    const std::size_t a = k % (row - 1) + k / (row - 1) * row, b = a + row;
    if (solid)
      here.nodes.insert(here.nodes.end(), {near[a], near[a + 1], near[b + 1], near[b],  //
                                           far[a], far[a + 1], far[b + 1], far[b]});
    else
      here.nodes.insert(here.nodes.end(), {near[a], near[a + 1], far[a + 1], far[a]});
  }
}

void OutputMesh::add_sets(const LocalMesh& local) {
  for (std::size_t s = 0; s < local.side_sets.size(); ++s) {
    mesh.side_sets.push_back({local.side_set_names[s], {}});
    for (const LocalSide& side : local.side_sets[s]) {
      if (!side.owned) continue;
      const CellType type = local.blocks[static_cast<std::size_t>(side.block)].type;
      const int first = first_cell_[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)];
      for (int k = 0; k < pieces(type); ++k)
        if (has_part(type, k, side.side)) mesh.side_sets.back().sides.push_back({side.block, first + k, side.side});
    }
  }
  for (std::size_t s = 0; s < local.node_sets.size(); ++s) {
    mesh.node_sets.push_back({local.node_set_names[s], {}});
    for (int node : local.node_sets[s])
      if (number_[static_cast<std::size_t>(node)] >= 0)
        mesh.node_sets.back().nodes.push_back(number_[static_cast<std::size_t>(node)]);
  }
}

std::vector<double> OutputMesh::nodal(const std::vector<double>& field) const {
  std::vector<double> values;
  values.reserve(combinations_.size());
  for (const Combination& combination : combinations_) {
    double sum = 0;
    for (const auto& [node, weight] : combination) sum += weight * field[static_cast<std::size_t>(node)];
    values.push_back(sum);
  }
  return values;
}

std::vector<double> OutputMesh::cell(std::size_t block, const std::vector<double>& field) const {
  std::vector<double> values;
  values.reserve(cells[block].size());
  for (int cell : cells[block]) values.push_back(field[static_cast<std::size_t>(cell)]);
  return values;
}

}  // namespace ixos

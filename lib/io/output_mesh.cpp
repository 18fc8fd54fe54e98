#include "io/output_mesh.hpp"

#include <algorithm>
#include <array>

#include "fem/cell_info.hpp"
#include "fem/with_element.hpp"
#include "io/distinct_names.hpp"

namespace ixos {
namespace {

/// Returns the number of cells into which one is cut.
int pieces(CellType type) {
  const int n = cell_info(type).pieces;
  return corner_type(type) == CellType::Hex8 ? n * n : n;
}

/// Returns whether piece k of a cell has a part of the cell's side. Pieces are cells of the same sides.
bool has_part(CellType type, int k, int side) {
  const int n = cell_info(type).pieces, i = k % n, j = k / n;
  if (corner_type(type) == CellType::Quad4) return side % 2 == 0 || i == (side == 1 ? n - 1 : 0);
  if (side == contact_side(type) || side > 3) return true;
  return side % 2 == 0 ? j == (side == 2 ? n - 1 : 0) : i == (side == 1 ? n - 1 : 0);
}

/// Returns, by node of a piece, its place in steps from the first corner: across the contact side's first direction, in
/// 3D its second, and away from it. A quadratic piece has two steps along each edge.
std::vector<std::array<std::size_t, 3>> steps_of_nodes(CellType piece) {
  const std::size_t end = is_quadratic(piece) ? 2 : 1;
  const auto step = [end](std::size_t factor) { return factor == 0 ? 0 : factor == 1 ? end : 1; };
  std::vector<std::array<std::size_t, 3>> steps;
  for (std::size_t a = 0; a < static_cast<std::size_t>(nodes_per_cell(piece)); ++a) {
    if (corner_type(piece) == CellType::Quad4) {
      const auto [i, j] = Quad9::factors(a);
      steps.push_back({step(i), 0, step(j)});
    } else {
      const auto [i, j, k] = Hex27::factors(a);
      steps.push_back({step(i), step(j), step(k)});
    }
  }
  return steps;
}

/// Returns the room for the numbers of the nodes that cutting cells adds, for each piece: more than a cell adds.
int numbers_per_piece(const LocalMesh& local) {
  return std::any_of(local.blocks.begin(), local.blocks.end(),
                     [](const auto& block) { return is_quadratic(block.type); })
             ? 10
             : 3;
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
  description.global_nodes = local.global_nodes + local.global_tied;
  int cell_offset = 0;
  for (const LocalBlock& block : local.blocks) {
    const int parts = pieces(block.type);
    ElementBlock here;
    here.name = parts == 1 ? block.name : block.name + "_contact";
    here.type = cell_info(plain_type(block.type)).drawn;
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
  if (local.plain_nodes >= 0)
    description.global_nodes += numbers_per_piece(local) * static_cast<long long>(cell_offset);
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
    for (int a = 0; a < nodes_per_cell(here.type); ++a) here.nodes.push_back(node(a));
    return;
  }
  // Numbers beyond those of all nodes.
  int id = static_cast<int>(local.global_nodes + local.global_tied) + numbers_per_piece(local) * (first_id - 1);
  const bool solid = local.dimension == 3;
  const auto divided = static_cast<std::size_t>(cell_info(block.type).pieces);
  const std::size_t order = is_quadratic(block.type) ? 2 : 1;
  const std::size_t along = order * divided, across = solid ? along : 0, row = along + 1;
  std::vector<std::vector<int>> layers(order + 1);  // from the contact side to the side opposite
  for (std::size_t layer = 0; layer <= order; ++layer)
    for (std::size_t j = 0; j <= across; ++j)
      for (std::size_t i = 0; i <= along; ++i) {
        const auto coordinate = [](std::size_t step, std::size_t steps) {
          return -1 + 2.0 * static_cast<double>(step) / static_cast<double>(steps);
        };
        std::array<double, 3> xi{coordinate(i, along), coordinate(j, along), coordinate(layer, order)};
        if (!solid) xi[1] = xi[2];
        Combination point = point_of(block, cell, xi);
        const bool own = point.size() == 1 && point.front().second == 1;
        layers[layer].push_back(own ? own_node(local, point.front().first) : add_node(local, std::move(point), ++id));
      }
  static const auto quad4 = steps_of_nodes(CellType::Quad4), hex8 = steps_of_nodes(CellType::Hex8),
                    quad9 = steps_of_nodes(CellType::Quad9), hex27 = steps_of_nodes(CellType::Hex27);
  const auto& steps = order == 2 ? (solid ? hex27 : quad9) : (solid ? hex8 : quad4);
  for (std::size_t k = 0; k < static_cast<std::size_t>(parts); ++k)
    for (const auto& [i, j, layer] : steps)
      here.nodes.push_back(layers[layer][order * (k % divided) + i + (order * (k / divided) + j) * row]);
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

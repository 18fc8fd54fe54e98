#include "io/output_mesh.hpp"

#include <algorithm>
#include <array>

#include "fem/cell_types.hpp"

namespace ixos {
namespace {

/// Into how many cells one is cut.
int pieces(CellType type) {
  switch (type) {
    case CellType::Quad4C2:
      return 2;
    case CellType::Quad4C3:
      return 3;
    case CellType::Quad4C4:
    case CellType::Quad4CH:
      return 4;
    default:
      return 1;
  }
}

std::vector<std::pair<int, double>> point_of(const LocalBlock& block, int cell, double xi, double eta) {
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    std::vector<std::pair<int, double>> combination;
    if constexpr (Element::dimension == 2) {
      std::array<double, Element::nodes> value;
      std::array<std::array<double, 2>, Element::nodes> gradient;
      Element::evaluate({xi, eta}, value, gradient);
      for (int a = 0; a < Element::nodes; ++a) {
        const double weight = node_scale(block, cell, a) * value[static_cast<std::size_t>(a)];
        if (weight != 0) combination.emplace_back(block.nodes[cell_entry(cell, Element::nodes, a)], weight);
      }
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
    here.type = block.type == CellType::Hex8 ? CellType::Hex8 : CellType::Quad4;
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
  if (local.plain_nodes >= 0) description.global_nodes += 2 * static_cast<long long>(cell_offset) + 2;
  add_sets(local);
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
  std::vector<int> near{node(0)}, far{node(3)};
  for (int k = 1; k < parts; ++k) {
    const double xi = -1 + 2.0 * k / parts;
    // Numbers beyond those of all nodes, two for each cell here.
    const int id = static_cast<int>(local.global_nodes) + 2 * (first_id + k) - 1;
    near.push_back(block.type == CellType::Quad4CH ? add_node(local, point_of(block, cell, xi, -1), id) : node(3 + k));
    far.push_back(add_node(local, point_of(block, cell, xi, 1), id + 1));
  }
  near.push_back(node(1));
  far.push_back(node(2));
  for (std::size_t k = 0; k < static_cast<std::size_t>(parts); ++k)
    here.nodes.insert(here.nodes.end(), {near[k], near[k + 1], far[k + 1], far[k]});
}

void OutputMesh::add_sets(const LocalMesh& local) {
  for (std::size_t s = 0; s < local.side_sets.size(); ++s) {
    mesh.side_sets.push_back({local.side_set_names[s], {}});
    for (const LocalSide& side : local.side_sets[s]) {
      if (!side.owned) continue;
      const int parts = pieces(local.blocks[static_cast<std::size_t>(side.block)].type);
      const int first = first_cell_[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)];
      // Of a row of pieces, sides 0 and 2 are along it, 1 and 3 at its ends.
      for (int k = 0; k < parts; ++k)
        if (parts == 1 || side.side % 2 == 0 || k == (side.side == 1 ? parts - 1 : 0))
          mesh.side_sets.back().sides.push_back({side.block, first + k, side.side});
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

}  // namespace ixos

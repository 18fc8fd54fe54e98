#include "io/file_cells.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "fem/cell_info.hpp"
#include "mesh/normalize.hpp"

namespace ixos {
namespace {

/// Returns the type of a shape whose first nodes are so many, null for other numbers: that with as many nodes, or the
/// quadratic one with fewer inside.
const CellInfo* type_with(ReferenceShape shape, int nodes) {
  const auto of_shape = [&](const CellInfo& info) { return info.shape == shape && info.plain == info.type; };
  const CellInfo* const same = find_cell([&](const CellInfo& info) { return of_shape(info) && info.nodes == nodes; });
  if (same != nullptr) return same;
  return find_cell([&](const CellInfo& info) {
    if (!of_shape(info) || info.order != 2 || info.bubbles) return false;
    const auto edges = std::count_if(info.node_corners.begin(), info.node_corners.end(),
                                     [](const NodeCorners& corners) { return corners.size() <= 2; });
    return edges == nodes;
  });
}

std::vector<int> as_they_are(int nodes) {
  std::vector<int> order(static_cast<std::size_t>(nodes));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// gmsh's order of the nodes beyond the corners, by the corners beside them, if it is not that of Exodus: gmsh's
/// manual, "Node ordering". Cells without nodes inside have the first ones.
std::map<ReferenceShape, std::vector<NodeCorners>> gmsh_order() {
  return {{ReferenceShape::Tetrahedron, {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}},
          {ReferenceShape::Hexahedron,
           {{0, 1},
            {0, 3},
            {0, 4},
            {1, 2},
            {1, 5},
            {2, 3},
            {2, 6},
            {3, 7},
            {4, 5},
            {4, 7},
            {5, 6},
            {6, 7},
            {0, 1, 2, 3},
            {0, 1, 4, 5},
            {0, 3, 4, 7},
            {1, 2, 5, 6},
            {2, 3, 6, 7},
            {4, 5, 6, 7},
            {0, 1, 2, 3, 4, 5, 6, 7}}},
          {ReferenceShape::Prism,
           {{0, 1},
            {0, 2},
            {0, 3},
            {1, 2},
            {1, 4},
            {2, 5},
            {3, 4},
            {3, 5},
            {4, 5},
            {0, 1, 3, 4},
            {0, 2, 3, 5},
            {1, 2, 4, 5}}},
          {ReferenceShape::Pyramid, {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}, {0, 1, 2, 3}}}};
}

FileCells of_gmsh(const CellInfo& info, int nodes) {
  const auto orders = gmsh_order();
  const auto found = orders.find(info.shape);
  const int corners = nodes_per_cell(info.corners);
  if (found == orders.end() || nodes == corners) return {info.type, as_they_are(nodes)};
  FileCells cells{info.type, as_they_are(corners)};
  for (int a = corners; a < nodes; ++a) {
    NodeCorners own = info.node_corners[static_cast<std::size_t>(a)];
    std::sort(own.begin(), own.end());
    const auto place = std::find(found->second.begin(), found->second.end(), own) - found->second.begin();
    cells.order.push_back(corners + static_cast<int>(place));
  }
  return cells;
}

}  // namespace

const FileCells* exodus_cells(ReferenceShape shape, int nodes) {
  static std::map<std::pair<ReferenceShape, int>, std::optional<FileCells>> known;
  const auto [found, fresh] = known.emplace(std::pair(shape, nodes), std::nullopt);
  if (fresh)
    if (const CellInfo* const info = type_with(shape, nodes);
        info != nullptr && (!info->bubbles || shape == ReferenceShape::Triangle))
      found->second = FileCells{info->type, as_they_are(nodes)};
  return found->second ? &*found->second : nullptr;
}

const FileCells* gmsh_cells(int type) {
  static const auto known = [] {
    std::map<int, FileCells> all;
    for (const CellInfo& info : cell_infos())
      if (info.gmsh != 0 && info.plain == info.type) all.emplace(info.gmsh, of_gmsh(info, info.nodes));
    const std::map<int, std::pair<ReferenceShape, int>> without_insides{{16, {ReferenceShape::Quadrilateral, 8}},
                                                                        {17, {ReferenceShape::Hexahedron, 20}},
                                                                        {18, {ReferenceShape::Prism, 15}},
                                                                        {19, {ReferenceShape::Pyramid, 13}}};
    for (const auto& [number, cell] : without_insides)
      all.emplace(number, of_gmsh(*type_with(cell.first, cell.second), cell.second));
    return all;
  }();
  const auto found = known.find(type);
  return found == known.end() ? nullptr : &found->second;
}

Mesh without_bubbles(Mesh mesh) {
  bool dropped = false;
  for (ElementBlock& block : mesh.blocks) {
    const CellType drawn = cell_info(block.type).drawn;
    if (drawn == block.type) continue;
    const int all = nodes_per_cell(block.type), kept = nodes_per_cell(drawn), cells = block.cells();
    std::vector<int> nodes;
    nodes.reserve(cell_entry(cells, kept));
    for (int cell = 0; cell < cells; ++cell)
      nodes.insert(nodes.end(), &block.nodes[cell_entry(cell, all)], &block.nodes[cell_entry(cell, all)] + kept);
    block.type = drawn;
    block.nodes = std::move(nodes);
    dropped = true;
  }
  if (dropped) drop_unused_nodes(mesh);
  return mesh;
}

void FileCellReader::add(const FileCells& cells, const std::vector<int>& nodes, ElementBlock& block) {
  std::vector<int> cell(cells.order.size());
  for (std::size_t first = 0; first < nodes.size(); first += cell.size()) {
    for (std::size_t a = 0; a < cell.size(); ++a) cell[a] = nodes[first + static_cast<std::size_t>(cells.order[a])];
    middles_.complete(cell.data(), cells.nodes(), cells.type, block.nodes);
  }
}

std::vector<Middles::Sum> FileCellReader::finish() {
  complete_node_sets(mesh_, middles_.added());
  return middles_.sums();
}

}  // namespace ixos

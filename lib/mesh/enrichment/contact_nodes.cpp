#include "mesh/enrichment/contact_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/cell_info.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {

Edge edge_key(int a, int b) { return std::minmax(a, b); }

double length(const Mesh& mesh, const Edge& edge) {
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  const double* a = &mesh.coordinates[dimension * static_cast<std::size_t>(edge.first)];
  const double* b = &mesh.coordinates[dimension * static_cast<std::size_t>(edge.second)];
  return dimension == 2 ? std::hypot(b[0] - a[0], b[1] - a[1]) : std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

std::set<Edge> tied_edges(const Mesh& mesh, const SideSet& set) {
  // Counts, for each edge of the set's faces, those faces less all cells around it. A cell has one face in the set, so
  // the count is zero if every cell at the edge is enriched along it; cells may also meet in the edge alone.
  std::map<Edge, int> balance;
  for (const Side& side : set.sides) {
    const std::vector<int> corners = nodes_of_side(mesh, side);
    for (std::size_t k = 0; k < 4; ++k) ++balance[edge_key(corners[k], corners[(k + 1) % 4])];
  }
  for (const ElementBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    const CellInfo& quadratic = cell_info(raised_type(corner_type(block.type), false));
    for (int cell = 0; cell < block.cells(); ++cell)
      for (const NodeCorners& edge : quadratic.node_corners) {
        if (edge.size() != 2) continue;
        const auto found = balance.find(
            edge_key(block.nodes[cell_entry(cell, n, edge[0])], block.nodes[cell_entry(cell, n, edge[1])]));
        if (found != balance.end()) --found->second;
      }
  }
  std::set<Edge> tied;
  for (const auto& [edge, left] : balance)
    if (left != 0) tied.insert(edge);
  for (const auto& [a, b, middle] : mesh.hanging_edges)
    for (const Edge& edge : {edge_key(a, b), edge_key(a, middle), edge_key(middle, b)}) tied.insert(edge);
  const std::set<int> followed(mesh.nodes_of_tied_sides.begin(), mesh.nodes_of_tied_sides.end());
  for (const auto& [edge, left] : balance)
    if (followed.count(edge.first) > 0 && followed.count(edge.second) > 0) tied.insert(edge);
  return tied;
}

}  // namespace ixos

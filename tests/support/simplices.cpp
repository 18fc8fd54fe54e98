#include "support/simplices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/cell_sides.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos::test {
namespace {

using Cells = std::map<CellType, std::vector<int>>;

void add(Cells& cells, CellType type, const int* nodes, const std::vector<std::vector<int>>& parts) {
  for (const std::vector<int>& part : parts)
    for (const int a : part) cells[type].push_back(nodes[a]);
}

double place_along(const Mesh& mesh, const int* nodes, int count) {
  double x = 0;
  for (int a = 0; a < count; ++a)
    x += mesh.coordinates[static_cast<std::size_t>(nodes[a]) * static_cast<std::size_t>(mesh.dimension)] / count;
  return x;
}

int add_centre(Mesh& mesh, const int* nodes) {
  for (std::size_t i = 0; i < 3; ++i) {
    double x = 0;
    for (int a = 0; a < 8; ++a) x += mesh.coordinates[static_cast<std::size_t>(nodes[a]) * 3 + i] / 8;
    mesh.coordinates.push_back(x);
  }
  return mesh.nodes() - 1;
}

/// The diagonal of each face runs as that of split cells on its other side.
const std::vector<std::vector<int>> six_tetrahedra{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                   {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
const std::vector<std::vector<int>> two_prisms{{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};

void add_pyramids(Mesh& mesh, Cells& cells, const int* nodes, bool right_is_split) {
  const int centre = add_centre(mesh, nodes);
  // A pyramid's base is seen from its apex.
  const std::vector<std::vector<int>> faces{{0, 4, 5, 1}, {3, 2, 6, 7}, {0, 3, 7, 4}, {0, 1, 2, 3}, {4, 7, 6, 5}};
  std::vector<std::vector<int>> bases = faces;
  if (!right_is_split) bases.push_back({1, 5, 6, 2});
  for (const std::vector<int>& base : bases) {
    for (const int a : base) cells[CellType::Pyr5].push_back(nodes[a]);
    cells[CellType::Pyr5].push_back(centre);
  }
  if (right_is_split)
    for (const std::vector<int>& base : std::vector<std::vector<int>>{{1, 5, 6}, {1, 6, 2}}) {
      for (const int a : base) cells[CellType::Tet4].push_back(nodes[a]);
      cells[CellType::Tet4].push_back(centre);
    }
}

/// Tetrahedra between a new node and halves of the faces.
void add_twelve(Mesh& mesh, Cells& cells, const int* nodes) {
  const int centre = add_centre(mesh, nodes);
  for (const std::vector<int>& base : std::vector<std::vector<int>>{
           {0, 4, 5, 1}, {3, 2, 6, 7}, {0, 3, 7, 4}, {0, 1, 2, 3}, {4, 7, 6, 5}, {1, 5, 6, 2}}) {
    std::size_t first = 0;
    for (std::size_t k = 1; k < 4; ++k)
      if (nodes[base[k]] < nodes[base[first]]) first = k;
    for (const std::size_t k : {1U, 2U})
      for (const int node :
           {nodes[base[first]], nodes[base[(first + k) % 4]], nodes[base[(first + k + 1) % 4]], centre})
        cells[CellType::Tet4].push_back(node);
  }
}

void split(Mesh& mesh, const std::string& kind, const int* nodes, double x, double width, Cells& cells) {
  const std::vector<std::vector<int>> two_triangles{{0, 1, 2}, {0, 2, 3}};
  if (kind == "triangles")
    add(cells, CellType::Tri3, nodes, two_triangles);
  else if (kind == "quads and triangles" && x < 0)
    add(cells, CellType::Quad4, nodes, {{0, 1, 2, 3}});
  else if (kind == "quads and triangles")
    add(cells, CellType::Tri3, nodes, two_triangles);
  else if (kind == "tetrahedra")
    add(cells, CellType::Tet4, nodes, six_tetrahedra);
  else if (kind == "twelve tetrahedra")
    add_twelve(mesh, cells, nodes);
  else if (kind == "prisms")
    add(cells, CellType::Prism6, nodes, two_prisms);
  else if (kind == "pyramids")
    add_pyramids(mesh, cells, nodes, false);
  else if (kind == "hexahedra to tetrahedra" && x < 0)
    add(cells, CellType::Hex8, nodes, {{0, 1, 2, 3, 4, 5, 6, 7}});
  else if (kind == "hexahedra to tetrahedra" && x < width)
    add_pyramids(mesh, cells, nodes, true);
  else if (kind == "hexahedra to tetrahedra")
    add(cells, CellType::Tet4, nodes, six_tetrahedra);
  else if (kind == "hexahedra and prisms" && x < 0)
    add(cells, CellType::Hex8, nodes, {{0, 1, 2, 3, 4, 5, 6, 7}});
  else if (kind == "hexahedra and prisms")
    add(cells, CellType::Prism6, nodes, two_prisms);
  else
    throw std::logic_error("no such kind: " + kind);
}

std::pair<std::vector<double>, std::vector<double>> box_of(const Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> low(d, std::numeric_limits<double>::infinity()), high(d, -low[0]);
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) {
    low[k % d] = std::min(low[k % d], mesh.coordinates[k]);
    high[k % d] = std::max(high[k % d], mesh.coordinates[k]);
  }
  return {low, high};
}

}  // namespace

Mesh split_cells(const Mesh& cubes, const std::string& kind) {
  Mesh mesh = cubes;
  const int n = nodes_per_cell(cubes.blocks.front().type);
  std::vector<std::set<std::vector<int>>> sets;  // the corners of each side
  for (const SideSet& set : cubes.side_sets) {
    sets.emplace_back();
    for (const Side& side : set.sides) {
      std::vector<int> corners = nodes_of_side(cubes, side);
      std::sort(corners.begin(), corners.end());
      sets.back().insert(corners);
    }
  }
  const auto [low, high] = box_of(cubes);
  const double first = place_along(cubes, cubes.blocks.front().nodes.data(), n);
  const double width = 2 * (first - low[0]);
  mesh.blocks.clear();
  for (const ElementBlock& block : cubes.blocks) {
    Cells cells;
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* nodes = &block.nodes[cell_entry(cell, n)];
      split(mesh, kind, nodes, place_along(cubes, nodes, n), width, cells);
    }
    for (const auto& [type, nodes] : cells) mesh.blocks.push_back({block.name, type, nodes});
  }
  const std::vector<Side> outer = boundary_sides(mesh);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    mesh.side_sets[s].sides.clear();
    for (const Side& side : outer) {
      SideCorners own = sorted_corners(mesh, side);
      const auto begin = std::find_if(own.begin(), own.end(), [](int node) { return node >= 0; });
      if (std::any_of(sets[s].begin(), sets[s].end(), [&](const std::vector<int>& whole) {
            return std::includes(whole.begin(), whole.end(), begin, own.end());
          }))
        mesh.side_sets[s].sides.push_back(side);
    }
  }
  return mesh;
}

void distort(Mesh& mesh, double by) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto [low, high] = box_of(mesh);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    double* x = &mesh.coordinates[node * d];
    bool inside = true;
    for (std::size_t i = 0; i < d; ++i) inside = inside && x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9;
    for (std::size_t i = 0; inside && i < d; ++i)
      x[i] += by * std::sin(7.0 * static_cast<double>(node) + 2.0 * static_cast<double>(i));
  }
}

void bend(Mesh& mesh, double by) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto [low, high] = box_of(mesh);
  const std::vector<double> old = mesh.coordinates;
  for (std::size_t k = 0; k < old.size(); ++k) {
    const std::size_t i = k % d, first = k - i;
    double wave = std::sin(M_PI * (old[k] - low[i]) / (high[i] - low[i]));  // 0 on the sides across direction i
    for (std::size_t j = 0; j < d; ++j)
      if (j != i) wave *= std::cos(2.0 + 3.0 * old[first + j] + static_cast<double>(i));
    mesh.coordinates[k] += by * wave;
  }
}

}  // namespace ixos::test

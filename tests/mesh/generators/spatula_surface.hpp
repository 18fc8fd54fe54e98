/// Nodes, sides and sets of a mesh of the spatula, for its tests.
#pragma once
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/generators/spatula.hpp"

namespace ixos::test {

using Vec = std::array<double, 3>;

inline SpatulaShape small(int cells) {
  SpatulaShape shape;
  shape.target_cells = cells;
  return shape;
}

/// Returns the mesh of the default shape, which is made once.
inline const Mesh& default_spatula() {
  static const Mesh mesh = spatula({});
  return mesh;
}

inline Vec position(const Mesh& mesh, int node) {
  const std::size_t at = 3 * static_cast<std::size_t>(node);
  return {mesh.coordinates.at(at), mesh.coordinates.at(at + 1), mesh.coordinates.at(at + 2)};
}

inline std::array<int, 4> nodes_of(const Mesh& mesh, const Side& side) {
  std::array<int, 4> nodes{};
  for (std::size_t a = 0; a < 4; ++a)
    nodes[a] = mesh.blocks[0].nodes.at(cell_entry(side.cell, 8, side_nodes(CellType::Hex8, side.side)[a]));
  return nodes;
}

/// Outward normal times area.
inline Vec side_vector(const Mesh& mesh, const Side& side) {
  std::array<Vec, 4> x;
  for (std::size_t a = 0; a < 4; ++a) x[a] = position(mesh, nodes_of(mesh, side)[a]);
  Vec result{};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t i = (d + 1) % 3, j = (d + 2) % 3;
    result[d] = ((x[2][i] - x[0][i]) * (x[3][j] - x[1][j]) - (x[2][j] - x[0][j]) * (x[3][i] - x[1][i])) / 2;
  }
  return result;
}

template <class Set>
const Set& named(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  if (found == sets.end()) throw std::runtime_error("no set " + name);
  return *found;
}

inline Vec area_vector(const Mesh& mesh, const std::string& set) {
  Vec sum{};
  for (const Side& side : named(mesh.side_sets, set).sides) {
    const Vec v = side_vector(mesh, side);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += v[d];
  }
  return sum;
}

}  // namespace ixos::test

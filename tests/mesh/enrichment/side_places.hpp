/// Places of the nodes of sides, in the plane.
#pragma once
#include <array>
#include <vector>

#include "fem/cell_type.hpp"
#include "mesh/mesh.hpp"

namespace ixos::test {

/// Returns the reference coordinates of a side's nodes, in their order.
inline std::vector<std::array<double, 2>> places(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  std::vector<std::array<double, 2>> result;
  for (int a : side_nodes(block.type, side.side)) {
    const auto n = static_cast<std::size_t>(block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), a)]);
    result.push_back({mesh.coordinates[2 * n], mesh.coordinates[2 * n + 1]});
  }
  return result;
}

}  // namespace ixos::test

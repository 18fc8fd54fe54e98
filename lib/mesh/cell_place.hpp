/// Cells as messages name them.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// The place of a cell, as a message names it.
struct CellPlace {
  std::string block;
  int cell = 0;                        ///< of the block, from 1
  std::array<double, 3> centre{};      ///< mean of its corners [L0]
  std::optional<long long> in_file{};  ///< its number in the mesh's file, if it comes from one
};

/// Returns the mean of a cell's corners, with zeros for missing coordinates [L0]. `mesh` and `block`: a Mesh and one of
/// its ElementBlocks, or a LocalMesh and one of its LocalBlocks.
template <class MeshType, class Block>
std::array<double, 3> cell_centre(const MeshType& mesh, const Block& block, int cell) {
  std::array<double, 3> centre{};
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const int corners = nodes_per_cell(corner_type(block.type));
  for (int a = 0; a < corners; ++a) {
    const auto node = static_cast<std::size_t>(block.nodes[cell_entry(cell, nodes_per_cell(block.type), a)]);
    for (std::size_t i = 0; i < d; ++i) centre[i] += mesh.coordinates[node * d + i] / corners;
  }
  return centre;
}

/// Returns the place of a cell of a block, from 0.
CellPlace place_of(const Mesh& mesh, const ElementBlock& block, int cell);

/// Returns "(0.5, 1)", the coordinates of a point in as many dimensions.
std::string point_in_words(const std::array<double, 3>& point, int dimension);

/// Returns "node 3 of the mesh at (0.5, 1)" for the node 2.
std::string node_in_words(const Mesh& mesh, int node);

/// Returns "block "body", cell 3 at (0.5, 1)"; of a cell that comes from a file "cell 3 (number 17 in the file)".
std::string in_words(const CellPlace& place, int dimension);

}  // namespace ixos

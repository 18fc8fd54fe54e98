#include "mesh/mesh.hpp"

namespace ixos {

int nodes_per_cell(CellType type) { return type == CellType::Quad4 ? 4 : 8; }

int sides_per_cell(CellType type) { return type == CellType::Quad4 ? 4 : 6; }

const std::vector<int>& side_nodes(CellType type, int side) {
  static const std::vector<std::vector<int>> quad = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const std::vector<std::vector<int>> hex = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                                    {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  return (type == CellType::Quad4 ? quad : hex).at(static_cast<std::size_t>(side));
}

int Mesh::cells() const {
  int sum = 0;
  for (const ElementBlock& block : blocks) sum += block.cells();
  return sum;
}

}  // namespace ixos

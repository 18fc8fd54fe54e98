#include "mesh/mesh.hpp"

namespace ixos {

int nodes_per_cell(CellType type) {
  switch (type) {
    case CellType::Quad4:
      return 4;
    case CellType::Hex8:
      return 8;
    case CellType::Quad4C2:
      return 5;
    case CellType::Quad4C3:
      return 6;
    case CellType::Quad4C4:
      return 7;
    case CellType::Quad4CH:
      return 6;
  }
  return 0;
}

int sides_per_cell(CellType type) { return type == CellType::Hex8 ? 6 : 4; }

const std::vector<int>& side_nodes(CellType type, int side) {
  static const std::vector<std::vector<int>> quad = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const std::vector<std::vector<int>> hex = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                                    {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  static const std::vector<std::vector<int>> contact = {{0, 1, 4}, {0, 1, 4, 5}, {0, 1, 4, 5, 6}};
  if (side == 0 && type == CellType::Quad4C2) return contact[0];
  if (side == 0 && (type == CellType::Quad4C3 || type == CellType::Quad4CH)) return contact[1];
  if (side == 0 && type == CellType::Quad4C4) return contact[2];
  return (type == CellType::Hex8 ? hex : quad).at(static_cast<std::size_t>(side));
}

int Mesh::cells() const {
  int sum = 0;
  for (const ElementBlock& block : blocks) sum += block.cells();
  return sum;
}

}  // namespace ixos

#include "fem/cell_type.hpp"

namespace ixos {
namespace {

using Sides = std::vector<std::vector<int>>;

/// Returns the sides of a quadrilateral whose first side has that many more nodes.
Sides quad_sides(int extra) {
  Sides sides = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (int k = 0; k < extra; ++k) sides[0].push_back(4 + k);
  return sides;
}

/// Returns the sides of a hexahedron whose bottom has three derivatives at each corner: along its first and second
/// edge, seen from outside, and mixed. A side beside the bottom has the derivatives along the edge that they share.
Sides hermite_sides() {
  Sides sides = {{0, 1, 5, 4, 9, 18}, {1, 2, 6, 5, 17, 14}, {2, 3, 7, 6, 15, 12}, {3, 0, 4, 7, 11, 8}, {0, 3, 2, 1}};
  for (int k = 8; k < 20; ++k) sides.back().push_back(k);
  sides.push_back({4, 5, 6, 7});
  return sides;
}

/// Returns the sides of a hexahedron whose bottom has that many nodes inside each edge.
Sides hex_sides(int inner) {
  if (inner == 0) return {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  Sides sides;
  for (int side = 0; side < 4; ++side) {
    const int next = (side + 1) % 4;
    sides.push_back({side, next, next + 4, side + 4});
    // Seen from outside, the bottom runs through its edges in the opposite direction.
    for (int k = inner - 1; k >= 0; --k) sides.back().push_back(8 + (3 - side) * inner + k);
  }
  sides.push_back({0, 3, 2, 1});
  for (int k = 0; k < 4 * inner + inner * inner; ++k) sides.back().push_back(8 + k);
  sides.push_back({4, 5, 6, 7});
  return sides;
}

/// Returns the sides of a quadratic hexahedron whose bottom is of fourth order, from those without enrichment.
Sides quartic_sides(Sides sides) {
  sides[3] = {3, 0, 4, 7, 11, 12, 19, 15, 23};  // begins with the edge of the bottom
  for (int side = 0; side < 4; ++side)
    for (int k = 1; k >= 0; --k) sides[static_cast<std::size_t>(side)].push_back(27 + 2 * (3 - side) + k);
  std::vector<int>& bottom = sides[4];
  bottom = {0, 3, 2, 1};
  for (int edge = 0; edge < 4; ++edge) bottom.insert(bottom.end(), {27 + 2 * edge, 11 - edge, 28 + 2 * edge});
  bottom.insert(bottom.end(), {35, 36, 37, 38, 21, 39, 40, 41, 42});
  return sides;
}

}  // namespace

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
    case CellType::Hex8C2:
      return 13;
    case CellType::Hex8C3:
    case CellType::Hex8CH:
      return 20;
    case CellType::Hex8C4:
      return 29;
    case CellType::Quad9:
      return 9;
    case CellType::Hex27:
      return 27;
    case CellType::Quad9C4:
      return 11;
    case CellType::Hex27C4:
      return 43;
  }
  return 0;
}

CellType corner_type(CellType type) {
  switch (type) {
    case CellType::Hex8:
    case CellType::Hex27:
    case CellType::Hex27C4:
    case CellType::Hex8C2:
    case CellType::Hex8C3:
    case CellType::Hex8C4:
    case CellType::Hex8CH:
      return CellType::Hex8;
    default:
      return CellType::Quad4;
  }
}

CellType plain_type(CellType type) {
  if (type == CellType::Quad9 || type == CellType::Quad9C4) return CellType::Quad9;
  if (type == CellType::Hex27 || type == CellType::Hex27C4) return CellType::Hex27;
  return corner_type(type);
}

bool is_quadratic(CellType type) { return plain_type(type) != corner_type(type); }

bool is_enriched(CellType type) { return type != plain_type(type); }

int sides_per_cell(CellType type) { return corner_type(type) == CellType::Hex8 ? 6 : 4; }

int contact_side(CellType type) {
  if (!is_enriched(type)) return -1;
  return corner_type(type) == CellType::Hex8 ? 4 : 0;
}

bool is_hermite(CellType type) { return type == CellType::Quad4CH || type == CellType::Hex8CH; }

const std::vector<int>& side_nodes(CellType type, int side) {
  static const std::vector<Sides> quads = {quad_sides(0), quad_sides(1), quad_sides(2), quad_sides(3)};
  static const std::vector<Sides> hexes = {hex_sides(0), hex_sides(1), hex_sides(2), hex_sides(3)};
  static const Sides hermite = hermite_sides();
  static const Sides quadratic_quad = {{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
  static const Sides quadratic_hex = {{0, 1, 5, 4, 8, 13, 16, 12, 25},  {1, 2, 6, 5, 9, 14, 17, 13, 24},
                                      {2, 3, 7, 6, 10, 15, 18, 14, 26}, {0, 4, 7, 3, 12, 19, 15, 11, 23},
                                      {0, 3, 2, 1, 11, 10, 9, 8, 21},   {4, 5, 6, 7, 16, 17, 18, 19, 22}};
  static const Sides quartic_quad = {{0, 1, 9, 4, 10}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
  static const Sides quartic_hex = quartic_sides(quadratic_hex);
  if (type == CellType::Quad9C4) return quartic_quad.at(static_cast<std::size_t>(side));
  if (type == CellType::Hex27C4) return quartic_hex.at(static_cast<std::size_t>(side));
  if (type == CellType::Hex8CH) return hermite.at(static_cast<std::size_t>(side));
  if (type == CellType::Quad9) return quadratic_quad.at(static_cast<std::size_t>(side));
  if (type == CellType::Hex27) return quadratic_hex.at(static_cast<std::size_t>(side));
  const auto extra = [&]() -> std::size_t {
    switch (type) {
      case CellType::Quad4C2:
      case CellType::Hex8C2:
        return 1;
      case CellType::Quad4C3:
      case CellType::Quad4CH:
      case CellType::Hex8C3:
        return 2;
      case CellType::Quad4C4:
      case CellType::Hex8C4:
        return 3;
      default:
        return 0;
    }
  }();
  return (corner_type(type) == CellType::Hex8 ? hexes : quads)[extra].at(static_cast<std::size_t>(side));
}

}  // namespace ixos

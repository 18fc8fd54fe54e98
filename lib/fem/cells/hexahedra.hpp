/// Hexahedra as types of cells.
#pragma once
#include "fem/cell_traits.hpp"
#include "fem/contact_hexahedra.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

struct HexahedronTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Hexahedron;
  using Corners = Hex8;
};

template <>
struct CellTraits<Hex8> : HexahedronTraits {
  using Plain = Hex8;
  using Sides = SideElements<Quad4, Quad4, Quad4, Quad4, Quad4, Quad4>;
  static constexpr std::string_view exodus = "HEX8";
  static constexpr int gmsh = 5;
  static SideNodes side_nodes() {
    return {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  }
};

template <>
struct CellTraits<Hex27> : HexahedronTraits {
  using Plain = Hex27;
  using Sides = SideElements<Quad9, Quad9, Quad9, Quad9, Quad9, Quad9>;
  static constexpr int order = 2;
  static constexpr std::string_view exodus = "HEX27";
  static constexpr int gmsh = 12;
  static SideNodes side_nodes() {
    return {{0, 1, 5, 4, 8, 13, 16, 12, 25},  {1, 2, 6, 5, 9, 14, 17, 13, 24}, {2, 3, 7, 6, 10, 15, 18, 14, 26},
            {0, 4, 7, 3, 12, 19, 15, 11, 23}, {0, 3, 2, 1, 11, 10, 9, 8, 21},  {4, 5, 6, 7, 16, 17, 18, 19, 22}};
  }
};

/// A linear hexahedron whose bottom is that face. A side that shares an edge with it is a `Beside`, and begins with
/// that edge.
template <class Face, class Beside>
struct ContactHexTraits : HexahedronTraits {
  using Plain = Hex8;
  using Sides = SideElements<Beside, Beside, Beside, Beside, Face, Quad4>;
  static constexpr int contact_side = 4;
};

/// A ContactHexTraits whose bottom has `inner` nodes inside each edge.
template <class Face, class Beside, int inner>
struct LagrangeHexTraits : ContactHexTraits<Face, Beside> {
  static SideNodes side_nodes() {
    SideNodes sides;
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
};
template <>
struct CellTraits<Hex8C2> : LagrangeHexTraits<LagrangeFace<2>, Quad4C2, 1> {
  static constexpr std::string_view contact = "Q1C2";
  static constexpr int pieces = 2;
};
template <>
struct CellTraits<Hex8C3> : LagrangeHexTraits<LagrangeFace<3>, Quad4C3, 2> {
  static constexpr std::string_view contact = "Q1C3";
  static constexpr int pieces = 3;
};
template <>
struct CellTraits<Hex8C4> : LagrangeHexTraits<LagrangeFace<4>, Quad4C4, 3> {
  static constexpr std::string_view contact = "Q1C4";
  static constexpr int pieces = 4;
};

/// Three derivatives at each corner of the bottom: along its first and second edge, seen from outside, and mixed. A
/// side beside the bottom has the derivatives along the edge that they share.
template <>
struct CellTraits<Hex8CH> : ContactHexTraits<HermiteFace, Quad4CH> {
  static constexpr std::string_view contact = "Q1CH";
  static constexpr int pieces = 4;
  static constexpr bool hermite = true;
  static SideNodes side_nodes() {
    SideNodes sides = {
        {0, 1, 5, 4, 9, 18}, {1, 2, 6, 5, 17, 14}, {2, 3, 7, 6, 15, 12}, {3, 0, 4, 7, 11, 8}, {0, 3, 2, 1}};
    for (int k = 8; k < 20; ++k) sides.back().push_back(k);
    sides.push_back({4, 5, 6, 7});
    return sides;
  }
};

/// A quadratic hexahedron whose bottom is of fourth order.
template <>
struct CellTraits<Hex27C4> : HexahedronTraits {
  using Plain = Hex27;
  using Sides = SideElements<Quad9C4, Quad9C4, Quad9C4, Quad9C4, QuarticFace, Quad9>;
  static constexpr int order = 2;
  static constexpr int contact_side = 4;
  static constexpr std::string_view contact = "Q2C4";
  static constexpr int pieces = 2;
  static SideNodes side_nodes() {
    SideNodes sides = CellTraits<Hex27>::side_nodes();
    sides[3] = {3, 0, 4, 7, 11, 12, 19, 15, 23};  // begins with the edge of the bottom
    for (int side = 0; side < 4; ++side)
      for (int k = 1; k >= 0; --k) sides[static_cast<std::size_t>(side)].push_back(27 + 2 * (3 - side) + k);
    std::vector<int>& bottom = sides[4];
    bottom = {0, 3, 2, 1};
    for (int edge = 0; edge < 4; ++edge) bottom.insert(bottom.end(), {27 + 2 * edge, 11 - edge, 28 + 2 * edge});
    bottom.insert(bottom.end(), {35, 36, 37, 38, 21, 39, 40, 41, 42});
    return sides;
  }
};

}  // namespace ixos

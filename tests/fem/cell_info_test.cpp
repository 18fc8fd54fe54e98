// The table of cell types: what an element type says of its sides fits its shape functions.
#include "fem/cell_info.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>
#include <typeindex>
#include <utility>

#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// The corners of a reference shape, in the order of the cells' nodes.
template <ReferenceShape shape>
auto corners_of_shape() {
  if constexpr (shape == ReferenceShape::Triangle)
    return Tri3::corners;
  else if constexpr (shape == ReferenceShape::Tetrahedron)
    return Tet4::corners;
  else if constexpr (shape == ReferenceShape::Prism)
    return Prism6::corners;
  else if constexpr (shape == ReferenceShape::Pyramid)
    return Pyr5::corners;
  else
    return corners < shape == ReferenceShape::Quadrilateral ? 2 : 3 > ();
}

/// Expects that a side's functions are those of its nodes in the cell, up to the sign of a derivative, and that the
/// other nodes' functions vanish there.
template <class Element, class Side>
void expect_side(const std::vector<int>& nodes, const std::string& where) {
  constexpr std::size_t D = Element::dimension, S = D - 1, N = Element::nodes;
  ASSERT_EQ(nodes.size(), static_cast<std::size_t>(Side::nodes)) << where;
  const auto corner = corners_of_shape<CellTraits<Element>::shape>();
  for (double phase : {0.3, 1.1, 2.9}) {
    std::array<double, S> t;
    for (std::size_t d = 0; d < S; ++d) t[d] = std::sin(phase + 2.0 * static_cast<double>(d));
    if constexpr (HasRule<Side>::value) t = {0.2 + 0.1 * t[0], 0.3 + 0.1 * t[1]};  // in the triangle
    using Linear = std::conditional_t<HasRule<Side>::value, Tri3, Multilinear<static_cast<int>(S)>>;
    std::array<double, Linear::nodes> share;
    std::array<std::array<double, S>, Linear::nodes> slope;
    Linear::evaluate(t, share, slope);
    std::array<double, D> xi{};
    for (std::size_t c = 0; c < share.size(); ++c)
      for (std::size_t d = 0; d < D; ++d) xi[d] += share[c] * corner[static_cast<std::size_t>(nodes[c])][d];
    std::array<double, N> value;
    std::array<std::array<double, D>, N> gradient;
    Element::evaluate(xi, value, gradient);
    std::array<double, Side::nodes> own;
    std::array<std::array<double, S>, Side::nodes> own_slope;
    Side::evaluate(t, own, own_slope);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      double& there = value[static_cast<std::size_t>(nodes[a])];
      EXPECT_NEAR(std::abs(there), std::abs(own[a]), 1e-14) << where << ", node " << a;
      there = 0;
    }
    for (double rest : value) EXPECT_NEAR(rest, 0, 1e-14) << where;
  }
}

/// Expects that of all sides, and that with_side_element() finds their types.
template <class Element, std::size_t... sides>
void expect_sides(const CellInfo& info, std::index_sequence<sides...> /*numbers*/) {
  using Sides = typename CellTraits<Element>::Sides;
  const auto expect = [&](auto own, int side) {
    const std::string where = std::string(info.name) + ", side " + std::to_string(side);
    expect_side<Element, typename decltype(own)::type>(side_nodes(info.type, side), where);
    const auto found =
        with_side_element(info.type, side, [](auto tag) { return std::type_index(typeid(decltype(tag))); });
    EXPECT_EQ(found, std::type_index(typeid(decltype(own)))) << where;
  };
  (expect(std::tuple_element_t<sides, Sides>{}, static_cast<int>(sides)), ...);
}

TEST(CellInfoTest, SidesAreTheCellsOwnFunctions) {
  for (const CellInfo& info : cell_infos())
    with_element(info.type, [&](auto cell) {
      using Element = typename decltype(cell)::type;
      constexpr std::size_t count = std::tuple_size_v<typename CellTraits<Element>::Sides>;
      ASSERT_EQ(info.sides.size(), count);
      expect_sides<Element>(info, std::make_index_sequence<count>());
    });
}

TEST(CellInfoTest, EachTypeStandsAtItsPlace) {
  std::set<std::string_view> names, exodus;
  std::set<int> gmsh;
  for (std::size_t k = 0; k < cell_infos().size(); ++k) {
    const CellInfo& info = cell_infos()[k];
    EXPECT_EQ(static_cast<std::size_t>(info.type), k);
    EXPECT_EQ(&cell_info(info.type), &info);
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    if (!info.exodus.empty()) {
      EXPECT_TRUE(exodus.insert(info.exodus).second) << info.name;
    }
    if (info.gmsh != 0) {
      EXPECT_TRUE(gmsh.insert(info.gmsh).second) << info.name;
    }
    const CellInfo &plain = cell_info(info.plain), &corners = cell_info(info.corners);
    EXPECT_EQ(plain.plain, info.plain);
    EXPECT_EQ(corners.corners, info.corners);
    EXPECT_EQ(corners.order, 1);
    EXPECT_EQ(plain.order, info.order);
    EXPECT_EQ(info.contact_side >= 0, info.plain != info.type);
    EXPECT_EQ(info.contact.empty(), info.plain == info.type);
    EXPECT_EQ(info.exodus.empty(), info.drawn != info.type) << "a picture has plain cells without bubbles";
    const CellInfo& drawn = cell_info(info.drawn);
    EXPECT_EQ(drawn.drawn, info.drawn);
    EXPECT_EQ(drawn.order, info.order);
    EXPECT_LE(drawn.nodes, info.nodes);
    for (const CellInfo* part : {&plain, &corners}) {
      EXPECT_EQ(part->shape, info.shape);
      EXPECT_LE(part->nodes, info.nodes);
      EXPECT_EQ(part->sides.size(), info.sides.size());
    }
  }
}

TEST(CellInfoTest, TypesAreFoundByWhatTheyAre) {
  EXPECT_EQ(cube_type(2), CellType::Quad4);
  EXPECT_EQ(cube_type(3), CellType::Hex8);
  EXPECT_EQ(cube_type(2, 2), CellType::Quad9);
  EXPECT_EQ(cube_type(3, 2), CellType::Hex27);
  EXPECT_EQ(cell_with(3, 27)->type, CellType::Hex27);
  EXPECT_EQ(cell_with(2, 3)->type, CellType::Tri3);
  EXPECT_EQ(cell_with(3, 6)->type, CellType::Prism6) << "in the plane it is a triangle";
  EXPECT_EQ(cell_with(2, 5), nullptr) << "an enriched cell is not plain";
  EXPECT_EQ(raised_type(CellType::Tet4, false), CellType::Tet10);
  EXPECT_EQ(raised_type(CellType::Tet10, true), CellType::Tet15);
  EXPECT_EQ(raised_type(CellType::Hex8, true), CellType::Hex27);
  std::set<std::pair<int, int>> counts;
  for (const CellInfo& info : cell_infos())
    if (info.plain == info.type) {
      EXPECT_TRUE(counts.insert({info.dimension, info.nodes}).second) << info.name;
    }
}

TEST(CellInfoTest, ANumberThatIsNoTypeIsNoOtherTypeInSilence) {
  const auto none = static_cast<CellType>(cell_infos().size());
  EXPECT_THROW(cell_info(none), std::out_of_range);
  EXPECT_THROW(nodes_per_cell(none), std::out_of_range);
  EXPECT_THROW(with_element(none, [](auto) {}), std::logic_error);
  EXPECT_THROW(with_plane_element(CellType::Hex8, [](auto) {}), std::logic_error);
  for (const int side : {-1, 3}) EXPECT_THROW(with_side_element(CellType::Tri3, side, [](auto) {}), std::out_of_range);
}

}  // namespace
}  // namespace ixos

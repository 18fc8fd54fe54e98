// Meshes of triangles and tetrahedra, also beside other cells, that are split in regions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "fem/cell_info.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/fingerprint.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/mesh_points.hpp"
#include "support/refusal.hpp"
#include "support/simplices.hpp"

namespace ixos {
namespace {

Mesh grid(const std::string& kind, int order, bool bubbles = false) {
  BoxShape shape;
  shape.dimension = kind.find("triangles") != std::string::npos ? 2 : 3;
  shape.lower = {-2, 0, 0};  // kinds change at x = 0
  shape.lengths = {4, 2, 2};
  shape.divisions = {kind.find("hexahedra") == 0 ? 8 : 4, 2, 2};
  Mesh mesh = test::split_cells(box(shape), kind);
  test::distort(mesh, 0.1);
  if (order == 2) raise_order(mesh, bubbles);
  return mesh;
}

NamedRegion corner(int dimension, int levels, double end = 0.6) {
  RefinedRegion region;
  region.levels = levels;
  region.upper.assign(static_cast<std::size_t>(dimension), end);
  region.upper[0] = end - 2;
  return {"corner", region};
}

const std::vector<std::string> kinds{"triangles",         "quads and triangles",     "tetrahedra",
                                     "twelve tetrahedra", "hexahedra to tetrahedra", "hexahedra and prisms"};
bool is_pure(const std::string& kind) { return kind.find(' ') == std::string::npos || kind == "twelve tetrahedra"; }

TEST(RefineSimplicesTest, CellsFillTheBodyOnceAndAreSound) {
  for (const std::string& kind : kinds)
    for (const int order : {1, 2})
      for (const auto& [levels, end] : {std::pair(1, 0.6), std::pair(2, 0.6), std::pair(1, 99.0)}) {
        SCOPED_TRACE(kind + ", order " + std::to_string(order) + ", levels " + std::to_string(levels));
        Mesh mesh = grid(kind, order);
        const int cells = mesh.cells();
        refine(mesh, {corner(mesh.dimension, levels, end)}, order);
        EXPECT_GT(mesh.cells(), cells);
        check_cells(mesh);
        require_one_order(mesh);
        EXPECT_NEAR(test::volume(mesh), mesh.dimension == 2 ? 8 : 16, 1e-11);
        for (const int part : connected_parts(mesh)) EXPECT_EQ(part, connected_parts(mesh).front());
        std::set<std::array<int, 3>> alone, in_set;
        for (const Side& side : boundary_sides(mesh)) alone.insert({side.block, side.cell, side.side});
        for (const Side& side : side_set_named(mesh, "surface").sides)
          in_set.insert({side.block, side.cell, side.side});
        EXPECT_EQ(in_set, alone);
        for (const Side& side : mesh.hanging_sides)
          EXPECT_TRUE(mesh.dimension == 2 || is_cube(mesh.blocks[static_cast<std::size_t>(side.block)].type));
        if (is_pure(kind)) {
          EXPECT_TRUE(mesh.ties.empty());
          EXPECT_TRUE(mesh.hanging_sides.empty());
          require_shared_middles(mesh);
        }
      }
}

// A node that hangs has the trace of the edge: in the plane all hanging nodes lie on edges of quadrilaterals, and each
// side that triangles have on a coarser quadrilateral ends in its corners and tied nodes.
TEST(RefineSimplicesTest, TrianglesBesideCoarserQuadrilateralsFollowThem) {
  for (const int order : {1, 2}) {
    Mesh mesh = grid("quads and triangles", order);
    RefinedRegion right;
    right.levels = 1;
    right.lower = {0.2, 0};
    refine(mesh, {{"right", right}}, order);
    ASSERT_FALSE(mesh.ties.empty());
    std::vector<char> is_tied(static_cast<std::size_t>(mesh.nodes()), 0);
    for (const Tie& tie : mesh.ties) {
      is_tied[static_cast<std::size_t>(tie.node)] = 1;
      double sum = 0;
      std::array<double, 2> place{};
      for (std::size_t k = 0; k < tie.masters.size(); ++k) {
        sum += tie.weights[k];
        for (std::size_t i = 0; i < 2; ++i)
          place[i] += tie.weights[k] * mesh.coordinates[2 * static_cast<std::size_t>(tie.masters[k]) + i];
      }
      EXPECT_NEAR(sum, 1, 1e-15);
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(place[i], mesh.coordinates[2 * static_cast<std::size_t>(tie.node) + i], 1e-14);
    }
    int of_triangles = 0;
    for (const Side& side : mesh.hanging_sides) {
      if (is_cube(mesh.blocks[static_cast<std::size_t>(side.block)].type)) continue;
      ++of_triangles;
      int tied = 0;
      for (const int node : nodes_of_side(mesh, side)) tied += is_tied[static_cast<std::size_t>(node)];
      EXPECT_GE(tied, 1);
    }
    EXPECT_GT(of_triangles, 0);
  }
}

// A region asks for as many bisections as halve all edges: lengths over the whole region are those of the levels.
TEST(RefineSimplicesTest, LevelsHalveEdges) {
  for (const std::string& kind : {std::string("triangles"), std::string("tetrahedra")})
    for (const int levels : {1, 2, 3}) {
      Mesh mesh = grid(kind, 1);
      const int before = mesh.cells();
      refine(mesh, {corner(mesh.dimension, levels, 99)}, 1);
      EXPECT_GE(mesh.cells(), before << (mesh.dimension * levels));
      EXPECT_LE(mesh.cells(), 2 * before << (mesh.dimension * levels)) << "neighbours ask for little more";
    }
}

TEST(RefineSimplicesTest, PyramidsPrismsAndTheirNeighboursStay) {
  for (const std::string& kind : {std::string("hexahedra to tetrahedra"), std::string("hexahedra and prisms")}) {
    Mesh mesh = grid(kind, 1);
    const auto count = [&](ReferenceShape shape) {
      int cells = 0;
      for (const ElementBlock& block : mesh.blocks)
        if (cell_info(block.type).shape == shape) cells += block.cells();
      return cells;
    };
    const int pyramids = count(ReferenceShape::Pyramid), prisms = count(ReferenceShape::Prism),
              hexahedra = count(ReferenceShape::Hexahedron), tetrahedra = count(ReferenceShape::Tetrahedron);
    refine(mesh, {corner(3, 2, 99)}, 1);
    EXPECT_EQ(count(ReferenceShape::Pyramid), pyramids);
    EXPECT_EQ(count(ReferenceShape::Prism), prisms);
    EXPECT_GT(count(ReferenceShape::Hexahedron), hexahedra);
    EXPECT_EQ(count(ReferenceShape::Tetrahedron) > tetrahedra, tetrahedra > 0);
    check_cells(mesh);
    ASSERT_EQ(mesh.notes.size(), 1U);
    test::expect_contains(mesh.notes[0], "are not as fine as asked: those are not split");
    // Their number is no reason to forecast more cells than there will be.
    Mesh deep = grid(kind, 1);
    EXPECT_EQ(test::refusal([&] {
                RefinedRegion beside;
                beside.levels = 9;
                beside.lower = {0.1, 0.5, 0.5};
                beside.upper = {0.4, 1.5, 1.5};
                refine(deep, {{"beside", beside}}, 1);
              }),
              "");
  }
}

TEST(RefineSimplicesTest, SplitsAreValues) {
  for (const std::string& kind : kinds)
    for (const auto& [order, end, bubbles] :
         {std::tuple(1, 0.6, false), std::tuple(2, 0.6, false), std::tuple(1, 99.0, false), std::tuple(2, 2.8, true)}) {
      if (bubbles && !is_pure(kind)) continue;
      Mesh one = grid(kind, order, bubbles), other = one, third = one;
      const CellSplits splits = refine(one, {corner(one.dimension, 2, end)}, order).splits();
      const CellSplits read = CellSplits::of_text(splits.text());
      EXPECT_TRUE(read == splits);
      EXPECT_TRUE(split(other, read, order).splits() == splits);
      split(third, splits, order);
      EXPECT_EQ(fingerprint(other), fingerprint(third)) << kind;
      EXPECT_EQ(other.cells(), one.cells());
      EXPECT_EQ(other.nodes(), one.nodes());
    }
}

TEST(RefineSimplicesTest, CellsWithBubblesGetNewOnes) {
  for (const std::string& kind : {std::string("triangles"), std::string("tetrahedra")}) {
    Mesh mesh = grid(kind, 2, true), plain = grid(kind, 2);
    refine(mesh, {corner(mesh.dimension, 1)}, 2);
    refine(plain, {corner(mesh.dimension, 1)}, 2);
    add_bubbles(plain);
    EXPECT_EQ(mesh.nodes(), plain.nodes());
    EXPECT_TRUE(cell_info(mesh.blocks[0].type).bubbles);
    check_cells(mesh);
    require_placed_bubbles(mesh);
  }
}

TEST(RefineSimplicesTest, NodeSetsKeepWhatIsBetweenTheirNodes) {
  for (const std::string& kind : {std::string("triangles"), std::string("tetrahedra")}) {
    Mesh mesh = grid(kind, 1);
    NodeSet own{"own", {}};
    const auto d = static_cast<std::size_t>(mesh.dimension);
    const auto is_left = [&](int node) { return mesh.coordinates[static_cast<std::size_t>(node) * d] == -2; };
    for (int node = 0; node < mesh.nodes(); ++node)
      if (is_left(node)) own.nodes.push_back(node);
    mesh.node_sets.push_back(own);
    refine(mesh, {corner(mesh.dimension, 2, 99)}, 1);
    std::set<int> expected;
    for (int node = 0; node < mesh.nodes(); ++node)
      if (is_left(node)) expected.insert(node);
    const NodeSet& found = mesh.node_sets.back();
    EXPECT_EQ(std::set<int>(found.nodes.begin(), found.nodes.end()), expected);
    EXPECT_GT(found.nodes.size(), own.nodes.size());
  }
}

// A corner cell of triangles has all its nodes on the surface, but not the middle of the edge across.
TEST(RefineSimplicesTest, NodeSetsOnTheSurfaceStayThere) {
  for (const std::string& kind : {std::string("triangles"), std::string("tetrahedra")}) {
    Mesh mesh = grid(kind, 1);
    NodeSet own{"own", {}};
    std::set<int> surface;
    for (const Side& side : boundary_sides(mesh))
      for (const int node : nodes_of_side(mesh, side)) surface.insert(node);
    own.nodes.assign(surface.begin(), surface.end());
    mesh.node_sets.push_back(own);
    refine(mesh, {corner(mesh.dimension, 2, 99)}, 1);
    surface.clear();
    for (const Side& side : boundary_sides(mesh))
      for (const int node : nodes_of_side(mesh, side)) surface.insert(node);
    const NodeSet& found = mesh.node_sets.back();
    EXPECT_EQ(std::set<int>(found.nodes.begin(), found.nodes.end()), surface);
  }
}

TEST(RefineSimplicesTest, WhatCannotBeIsRefused) {
  Mesh triangles = grid("triangles", 1);
  NamedRegion along = corner(2, 1);
  along.region.directions = "x";
  EXPECT_EQ(test::refusal([&] { refine(triangles, {along}, 1); }),
            "corner: triangles and tetrahedra have no axes; leave Directions out");
  Mesh deep = grid("triangles", 1);
  NamedRegion point = corner(2, 30, 1e-9);
  EXPECT_EQ(test::refusal([&] { refine(deep, {point}, 1); }), "");  // 60 bisections of the cells at a point
  Mesh deeper = grid("tetrahedra", 1);
  NamedRegion far = corner(3, 30, 1e-9);
  EXPECT_EQ(test::refusal([&] { refine(deeper, {far}, 1); }),
            "triangles and tetrahedra are bisected at most 62 times; use fewer levels");
  Mesh prisms = grid("prisms", 1);
  EXPECT_EQ(test::refusal([&] { refine(prisms, {corner(3, 1)}, 1); }),
            "prisms and pyramids are not refined; give a mesh of them its size where it is made, or split them into "
            "tetrahedra");
}

}  // namespace
}  // namespace ixos

#include "mesh/cell_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/generators/spatula.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// A box of 3 by 2 (by 1) with cells of every place: 3 x 2 (x 2).
Mesh example(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 1};
  shape.divisions = {3, 2, 2};
  return box(shape);
}

Mesh raised(Mesh mesh) {
  raise_order(mesh);
  return mesh;
}

template <class Set>
const Set& named(const std::vector<Set>& sets, const std::string& name) {
  return *std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
}

/// Returns the radius of a node of a disk about the origin.
double radius(const Mesh& mesh, int node) {
  const double* x = &mesh.coordinates[2 * static_cast<std::size_t>(node)];
  return std::hypot(x[0], x[1]);
}

DiskShape disk_of(int order, bool half = false) {
  DiskShape shape;
  shape.diameter = 8;
  shape.half = half;
  shape.cell_order = order;
  return shape;
}

TEST(CellOrderTest, ABoxHasTheNodesOfOneOfTwiceAsManyCells) {
  for (int dimension : {2, 3}) {
    const Mesh linear = example(dimension), mesh = raised(linear);
    BoxShape fine;
    fine.dimension = dimension;
    fine.lengths = {3, 2, 1};
    fine.divisions = {6, 4, 4};
    const auto d = static_cast<std::size_t>(dimension);
    const auto places = [d](const Mesh& of) {
      std::set<std::vector<double>> all;
      for (std::size_t k = 0; k < of.coordinates.size(); k += d) {
        all.emplace();
        std::vector<double> x(&of.coordinates[k], &of.coordinates[k] + d);
        for (double& value : x) value = std::round(value * 12) / 12;  // thirds are rounded
        all.insert(x);
      }
      return all;
    };
    EXPECT_EQ(mesh.nodes(), box(fine).nodes());
    EXPECT_EQ(places(mesh), places(box(fine)));
    EXPECT_EQ(mesh.cells(), linear.cells());
    EXPECT_EQ(mesh.linear_nodes, linear.nodes());
    EXPECT_EQ(mesh.blocks[0].type, dimension == 2 ? CellType::Quad9 : CellType::Hex27);
    EXPECT_TRUE(std::equal(linear.coordinates.begin(), linear.coordinates.end(), mesh.coordinates.begin()));
    EXPECT_NEAR(mesh_quality(mesh).volume, 6, 1e-13);
    EXPECT_NEAR(mesh_quality(mesh).least_scaled_jacobian, 1, 1e-14);
    check_arrays(mesh);
    check_cells(mesh);
    refuse_repeated_cells(mesh);
    EXPECT_EQ(coincident_nodes(mesh), "");
    EXPECT_TRUE(loose_parts(mesh, std::vector<bool>(static_cast<std::size_t>(mesh.nodes()), true)).empty());
    EXPECT_EQ(boundary_sides(mesh).size(), boundary_sides(linear).size());
  }
}

TEST(CellOrderTest, NodeSetsGetTheNodesOfTheirSides) {
  for (int dimension : {2, 3}) {
    const Mesh mesh = raised(example(dimension));
    const auto d = static_cast<std::size_t>(dimension);
    const double lengths[] = {3, 2, 1};
    std::size_t on_surface = 0, on_right = 0;
    for (std::size_t k = 0; k < mesh.coordinates.size(); k += d) {
      bool outside = false;
      for (std::size_t i = 0; i < d; ++i)
        outside = outside || mesh.coordinates[k + i] == 0 || mesh.coordinates[k + i] == lengths[i];
      on_surface += outside ? 1 : 0;
      on_right += mesh.coordinates[k] == 3 ? 1 : 0;
    }
    EXPECT_EQ(named(mesh.node_sets, "surface").nodes.size(), on_surface);
    EXPECT_EQ(named(mesh.node_sets, "right").nodes.size(), on_right);
    for (int node : named(mesh.node_sets, "right").nodes)
      EXPECT_EQ(mesh.coordinates[d * static_cast<std::size_t>(node)], 3);
  }
}

TEST(CellOrderTest, OtherNodeSetsGetTheMiddlesBetweenTheirNodes) {
  Mesh mesh = example(3);
  mesh.side_sets.clear();
  mesh.node_sets = {{"edge", {0, 1}}, {"apart", {0, 3}}, {"face", {0, 1, 4, 5}}};
  raise_order(mesh);
  EXPECT_EQ(mesh.node_sets[0].nodes.size(), 3);
  EXPECT_EQ(mesh.node_sets[1].nodes.size(), 2);
  EXPECT_EQ(mesh.node_sets[2].nodes.size(), 9);
  const double* middle = &mesh.coordinates[3 * static_cast<std::size_t>(mesh.node_sets[0].nodes[2])];
  EXPECT_EQ(middle[0], 0.5);
  EXPECT_EQ(middle[1], 0);
}

TEST(CellOrderTest, QuadraticCellsStayAndLinearOnesJoinThem) {
  const Mesh once = raised(example(2)), twice = raised(once);
  EXPECT_EQ(once.coordinates, twice.coordinates);
  EXPECT_EQ(once.blocks[0].nodes, twice.blocks[0].nodes);
  // The right half of a row of two cells is quadratic already.
  Mesh row;
  row.coordinates = {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1, 1.5, 0, 2, 0.5, 1.5, 1, 1.1, 0.5, 1.5, 0.5};
  row.blocks = {{"left", CellType::Quad4, {0, 1, 4, 3}}, {"right", CellType::Quad9, {1, 2, 5, 4, 6, 7, 8, 9, 10}}};
  EXPECT_EQ(
      test::refusal([&] { require_one_order(row); }),
      "block \"right\" has quadratic cells and block \"left\" linear ones, which do not conform; use one order in "
      "all blocks, or Mesh/Cell Order 2, which raises that of the linear ones");
  raise_order(row);
  require_one_order(row);
  EXPECT_EQ(row.nodes(), 11 + 4);
  EXPECT_EQ(row.blocks[0].nodes[5], 9);  // the middle of their common side, where the quadratic cell has it
  EXPECT_NEAR(mesh_quality(row).volume, 2, 1e-14);
}

TEST(CellOrderTest, CellsThatDoNotShareTheirMiddlesAreRefused) {
  for (int dimension : {2, 3}) {
    Mesh open = raised(example(dimension));
    open.linear_nodes = -1;  // as from a file
    EXPECT_EQ(test::refusal([&] { require_shared_middles(open); }), "");
    // The middle of the edge that cells 1 and 2 share, right of cell 1.
    const int shared = open.blocks[0].nodes[dimension == 2 ? 5 : 9];
    Mesh corner = open;
    corner.blocks[0].nodes[dimension == 2 ? 5 : 9] =
        open.blocks[0].nodes[cell_entry(4, nodes_per_cell(open.blocks[0].type), 2)];
    test::expect_contains(test::refusal([&] { require_shared_middles(corner); }), "but a corner of another");
    for (int i = 0; i < dimension; ++i)
      open.coordinates.push_back(open.coordinates[static_cast<std::size_t>(shared * dimension + i)]);
    open.blocks[0].nodes[dimension == 2 ? 5 : 9] = open.nodes() - 1;
    test::expect_contains(test::refusal([&] { require_shared_middles(open); }),
                          "share the corners of an edge or a face, but have the nodes");
  }
}

TEST(CellOrderTest, AnEnrichedMeshKeepsItsOrder) {
  Mesh mesh = example(2);
  enrich(mesh, "bottom", ContactElement::Q1C2);
  test::expect_contains(test::refusal([&] { raise_order(mesh); }),
                        "raise the order of its cells before it is enriched");
}

TEST(CellOrderTest, TheDiskFollowsItsCircle) {
  const Mesh mesh = disk(disk_of(2));
  check_cells(mesh);
  const NodeSet& rim = named(mesh.node_sets, "surface");
  EXPECT_EQ(rim.nodes.size(), 32);
  for (int node : rim.nodes) EXPECT_NEAR(radius(mesh, node), 4, 1e-14);
  for (int node = 0; node < mesh.nodes(); ++node) EXPECT_LT(radius(mesh, node), 4 + 1e-14);
  // The area between a circle and the parabola through the ends and the middle of an arc is of fourth order.
  const double area = 16 * M_PI, coarse = mesh_quality(mesh).volume;
  DiskShape finer = disk_of(2);
  finer.core_divisions = 8;
  const double fine = mesh_quality(disk(finer)).volume;
  EXPECT_LT(std::abs(coarse - area), 1e-4 * area);
  EXPECT_NEAR(std::log2((coarse - area) / (fine - area)), 4, 0.1);
  // A disk of twice as many cells has the same nodes.
  finer = disk_of(1);
  finer.core_divisions *= 2;
  finer.rings *= 2;
  const Mesh double_disk = disk(finer);
  EXPECT_EQ(mesh.nodes(), double_disk.nodes());
  for (int node = 0; node < mesh.nodes(); ++node) {
    double least = 1;
    for (int other = 0; other < double_disk.nodes(); ++other) {
      const auto a = 2 * static_cast<std::size_t>(node), b = 2 * static_cast<std::size_t>(other);
      least = std::min(least, std::hypot(mesh.coordinates[a] - double_disk.coordinates[b],
                                         mesh.coordinates[a + 1] - double_disk.coordinates[b + 1]));
    }
    EXPECT_LT(least, 1e-14) << node;
  }
}

TEST(CellOrderTest, HalfADiskHasTheMiddlesOnItsAxis) {
  const Mesh half = disk(disk_of(2, true)), whole = disk(disk_of(2));
  check_cells(half);
  EXPECT_NEAR(2 * mesh_quality(half).volume, mesh_quality(whole).volume, 1e-12);
  EXPECT_EQ(2 * half.cells(), whole.cells());
  EXPECT_EQ(half.linear_nodes, disk(disk_of(1, true)).nodes());
  std::size_t on_axis = 0;
  for (std::size_t k = 0; k < half.coordinates.size(); k += 2) on_axis += half.coordinates[k] == 0 ? 1 : 0;
  EXPECT_EQ(named(half.node_sets, "axis").nodes.size(), on_axis);
  EXPECT_EQ(on_axis, 4 * 4 + 1);  // along 4 cells of the core and 2 rings on either side
}

TEST(CellOrderTest, ASpatulaKeepsItsShape) {
  SpatulaShape shape;
  shape.target_cells = 1000;
  const Mesh linear = spatula(shape), mesh = raised(linear);
  check_cells(mesh);
  EXPECT_NEAR(mesh_quality(mesh).volume, mesh_quality(linear).volume, 1e-10 * mesh_quality(linear).volume);
  EXPECT_EQ(named(mesh.node_sets, "tip").nodes, named(linear.node_sets, "tip").nodes);
  // Euler: on the surface of a ball there are sides + 2 corners, twice as many edges as sides, a middle for each.
  const SideSet& surface = named(mesh.side_sets, "surface");
  EXPECT_EQ(named(mesh.node_sets, "surface").nodes.size(), 4 * surface.sides.size() + 2);
}

}  // namespace
}  // namespace ixos

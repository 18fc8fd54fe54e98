#include "mesh/generators/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/refusal.hpp"

namespace ixos {
namespace {

using Vec = std::array<double, 3>;

Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec position(const Mesh& mesh, int node) {
  const auto dim = static_cast<std::size_t>(mesh.dimension);
  Vec x{};
  for (std::size_t d = 0; d < dim; ++d) x[d] = mesh.coordinates.at(static_cast<std::size_t>(node) * dim + d);
  return x;
}

/// Positions of the nodes of a cell of the first block.
std::vector<Vec> cell_corners(const Mesh& mesh, int cell) {
  const ElementBlock& block = mesh.blocks.at(0);
  const int n = nodes_per_cell(block.type);
  std::vector<Vec> corners;
  for (int a = 0; a < n; ++a) corners.push_back(position(mesh, block.nodes.at(static_cast<std::size_t>(cell * n + a))));
  return corners;
}

double quad_area(const std::vector<Vec>& x) { return cross(minus(x[2], x[0]), minus(x[3], x[1]))[2] / 2; }

double disk_area(const Mesh& mesh) {
  double sum = 0;
  for (int cell = 0; cell < mesh.cells(); ++cell) sum += quad_area(cell_corners(mesh, cell));
  return sum;
}

/// Normal times length or area, to the right of an edge and by the right-hand rule round a face: outward if the nodes
/// are in the order that side_nodes promises.
Vec side_vector(const Mesh& mesh, const Side& side) {
  const std::vector<Vec> x = cell_corners(mesh, side.cell);
  std::vector<Vec> y;
  for (int a : side_nodes(mesh.blocks.at(0).type, side.side)) y.push_back(x[static_cast<std::size_t>(a)]);
  if (y.size() == 2) return {y[1][1] - y[0][1], y[0][0] - y[1][0], 0.0};
  const Vec twice = cross(minus(y[2], y[0]), minus(y[3], y[1]));
  return {twice[0] / 2, twice[1] / 2, twice[2] / 2};
}

template <class Set>
const Set& named(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  if (found == sets.end()) throw std::runtime_error("no set " + name);
  return *found;
}

/// The message with which a shape is refused.
template <class Shape, class Change>
std::string refusal(Mesh (*make)(const Shape&), Change change) {
  Shape shape;
  change(shape);
  return test::refusal([&] { make(shape); });
}

TEST(BallTest, ItsCellsFillTheSphere) {
  double error = 0;
  for (const int n : {2, 4, 8}) {
    BallShape shape;
    shape.diameter = 6;
    shape.center = {1, -2, 5};
    shape.core_divisions = n;
    shape.rings = 2;
    const Mesh mesh = ball(shape);
    EXPECT_EQ(mesh.cells(), n * n * (n + 12));
    EXPECT_EQ(mesh.nodes(), (n + 1) * (n + 1) * (n + 1) + 2 * (6 * n * n + 2));
    double volume = 0;  // a third of the flux of x through the sides
    for (const Side& side : named(mesh.side_sets, "surface").sides) {
      const Vec area = side_vector(mesh, side);
      const std::vector<Vec> x = cell_corners(mesh, side.cell);
      Vec middle{};
      for (int a : side_nodes(CellType::Hex8, side.side))
        for (std::size_t i = 0; i < 3; ++i) middle[i] += (x[static_cast<std::size_t>(a)][i] - shape.center[i]) / 4;
      EXPECT_GT(dot(area, middle), 0) << "outward";
      volume += dot(area, middle) / 3;
    }
    for (const int node : named(mesh.node_sets, "surface").nodes) {
      const Vec r = minus(position(mesh, node), {1, -2, 5});
      EXPECT_NEAR(std::sqrt(dot(r, r)), 3, 1e-14);
    }
    const double own = std::abs(volume / (4 * M_PI / 3 * 27) - 1);
    if (error > 0) {
      EXPECT_NEAR(own, error / 4, 0.05 * error) << "second order";
    }
    error = own;
  }
}

TEST(BallTest, RefusesWhatHasNoCells) {
  EXPECT_EQ(refusal(ball, [](BallShape& s) { s.diameter = 0; }), "diameter 0 must be positive");
  EXPECT_NE(refusal(ball, [](BallShape& s) { s.core_divisions = 0; }).find("core divisions 0"), std::string::npos);
  EXPECT_NE(refusal(ball, [](BallShape& s) { s.rings = 0; }).find("rings 0"), std::string::npos);
  EXPECT_NE(refusal(ball, [](BallShape& s) { s.core_half_side = 0.6; }).find("0.55"), std::string::npos);
  EXPECT_NE(refusal(ball, [](BallShape& s) { s.core_divisions = 1000; }).find("5e7"), std::string::npos);
}

TEST(DiskTest, HasTheCellsAndNodesOfThePaper) {
  const Mesh mesh = disk({});
  EXPECT_EQ(mesh.cells(), 48);
  EXPECT_EQ(mesh.nodes(), 57);
  EXPECT_EQ(named(mesh.side_sets, "surface").sides.size(), 16u);
  EXPECT_EQ(named(mesh.node_sets, "surface").nodes.size(), 16u);
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].name, "body");
}

TEST(DiskTest, CellsAreCounterClockwiseAndConvex) {
  for (int n : {2, 4, 8}) {
    DiskShape shape;
    shape.core_divisions = n;
    shape.rings = n / 2 + 1;
    const Mesh mesh = disk(shape);
    for (int cell = 0; cell < mesh.cells(); ++cell) {
      const std::vector<Vec> x = cell_corners(mesh, cell);
      for (std::size_t a = 0; a < 4; ++a)  // the Jacobian at the corner, up to a factor 4
        EXPECT_GT(cross(minus(x[(a + 1) % 4], x[a]), minus(x[(a + 3) % 4], x[a]))[2], 0.0) << n << ", cell " << cell;
    }
  }
}

TEST(DiskTest, AHalfHasHalfOfTheCells) {
  DiskShape shape;
  shape.diameter = 8;
  shape.center = {0, 3};
  const Mesh whole = disk(shape);
  shape.half = true;
  const Mesh half = disk(shape);
  EXPECT_EQ(2 * half.cells(), whole.cells());
  EXPECT_NEAR(disk_area(half), disk_area(whole) / 2, 1e-13);
  const auto& axis = named(half.node_sets, "axis").nodes;
  EXPECT_EQ(axis.size(), 4u + 1 + 2 * 2);  // across the core, and two rings at both ends
  EXPECT_EQ(half.nodes() * 2, whole.nodes() + static_cast<int>(axis.size()));
  for (const int node : axis) EXPECT_EQ(position(half, node)[0], 0);
  EXPECT_EQ(2 * named(half.side_sets, "surface").sides.size(), named(whole.side_sets, "surface").sides.size());
  for (const Side& side : named(half.side_sets, "surface").sides) EXPECT_GT(side_vector(half, side)[0], 0);
  const int middle = named(half.node_sets, "center").nodes.at(0);
  EXPECT_EQ(position(half, middle)[1], 3);
  EXPECT_TRUE(half.notes.empty());  // the user's file left nothing out
}

TEST(DiskTest, RimNodesLieOnTheCircle) {
  DiskShape shape;
  shape.center = {3.0, -2.0};
  const Mesh mesh = disk(shape);
  for (int node : named(mesh.node_sets, "surface").nodes) {
    const Vec r = minus(position(mesh, node), {3.0, -2.0, 0.0});
    EXPECT_NEAR(std::hypot(r[0], r[1]), 5.0, 4e-15);
  }
  const std::vector<int>& center = named(mesh.node_sets, "center").nodes;
  ASSERT_EQ(center.size(), 1u);
  EXPECT_EQ(position(mesh, center[0]), (Vec{3.0, -2.0, 0.0}));
}

TEST(DiskTest, AreaIsThatOfTheRegularPolygonAndConvergesWithSecondOrder) {
  std::vector<double> error;
  for (int n : {4, 8, 16}) {
    DiskShape shape;
    shape.core_divisions = n;
    const double area = disk_area(disk(shape));
    EXPECT_NEAR(area, 2 * n * 25.0 * std::sin(M_PI / (2 * n)), 1e-12);  // 4 n corners on the radius 5
    error.push_back(M_PI * 25 - area);
  }
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.1);
  EXPECT_NEAR(error[1] / error[2], 4.0, 0.1);
}

TEST(DiskTest, IsMirrorSymmetric) {
  const Mesh mesh = disk({});
  const auto has_node_at = [&mesh](double x, double y) {
    for (int node = 0; node < mesh.nodes(); ++node) {
      const Vec p = position(mesh, node);
      if (std::hypot(p[0] - x, p[1] - y) < 1e-14) return true;
    }
    return false;
  };
  for (int node = 0; node < mesh.nodes(); ++node) {
    const Vec p = position(mesh, node);
    EXPECT_TRUE(has_node_at(-p[0], p[1]) && has_node_at(p[0], -p[1]) && has_node_at(p[1], p[0])) << node;
  }
}

TEST(DiskTest, SidesPointOutwardAndClose) {
  const Mesh mesh = disk({});
  Vec sum{};
  for (const Side& side : named(mesh.side_sets, "surface").sides) {
    const Vec v = side_vector(mesh, side);
    const std::vector<Vec> x = cell_corners(mesh, side.cell);
    // A chord of the circle of radius 5; its normal is that of the circle half-way.
    EXPECT_NEAR(std::hypot(v[0], v[1]), 10 * std::sin(M_PI / 16), 1e-14);
    const Vec corner = x[static_cast<std::size_t>(side_nodes(CellType::Quad4, side.side)[0])];
    EXPECT_NEAR(dot(v, corner), 25 * std::sin(M_PI / 8), 1e-13);
    for (std::size_t d = 0; d < 2; ++d) sum[d] += v[d];
  }
  EXPECT_NEAR(sum[0], 0.0, 1e-13);
  EXPECT_NEAR(sum[1], 0.0, 1e-13);
}

TEST(DiskTest, BadValuesAreRefused) {
  const auto undefined = [](DiskShape& s) { s.diameter = std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.diameter = 0; }), "diameter 0 must be positive");
  EXPECT_EQ(refusal(disk, undefined), "diameter nan must be positive");
  const std::string even = " must be even and at least 2";
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.core_divisions = 3; }), "core divisions 3" + even);
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.core_divisions = 0; }), "core divisions 0" + even);
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.rings = 0; }), "rings 0 must be at least 1");
  const std::string between = " must lie between 0 and 0.7";
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.core_half_side = 0.7; }), "core half side 0.7" + between);
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.core_half_side = 0; }), "core half side 0" + between);
  // 10001^2 of the core and 40000 a ring.
  EXPECT_EQ(refusal(disk, [](DiskShape& s) { s.core_divisions = s.rings = 10000; }),
            "core divisions 10000 and rings 10000 make 5e+08 nodes; at most 5e7 are allowed");
}

/// 3 x 2 cells, or 3 x 2 x 4, of a box with sides 1.5, 2 and 3.
BoxShape example(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = {-1.0, 0.5, 2.0};
  shape.lengths = {1.5, 2.0, 3.0};
  shape.divisions = {3, 2, 4};
  return shape;
}

void expect_set(const Mesh& mesh, const std::string& name, std::size_t sides, std::size_t nodes, const Vec& outward) {
  SCOPED_TRACE(name);
  const SideSet& set = named(mesh.side_sets, name);
  EXPECT_EQ(set.sides.size(), sides);
  EXPECT_EQ(named(mesh.node_sets, name).nodes.size(), nodes);
  Vec sum{};
  for (const Side& side : set.sides) {
    const Vec v = side_vector(mesh, side);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += v[d];
    // All sides of a face are alike; those of "surface" have every direction and sum to zero.
    if (name == "surface") continue;
    EXPECT_NEAR(dot(v, outward), dot(outward, outward) / static_cast<double>(sides), 1e-13);
  }
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(sum[d], outward[d], 1e-13);
}

TEST(BoxTest, RectangleHasItsCellsNodesAndSets) {
  const Mesh mesh = box(example(2));
  EXPECT_EQ(mesh.cells(), 6);
  EXPECT_EQ(mesh.nodes(), 12);
  for (int cell = 0; cell < 6; ++cell) EXPECT_NEAR(quad_area(cell_corners(mesh, cell)), 1.5 * 2 / 6, 1e-14);
  expect_set(mesh, "left", 2, 3, {-2.0, 0.0, 0.0});
  expect_set(mesh, "right", 2, 3, {2.0, 0.0, 0.0});
  expect_set(mesh, "bottom", 3, 4, {0.0, -1.5, 0.0});
  expect_set(mesh, "top", 3, 4, {0.0, 1.5, 0.0});
  expect_set(mesh, "surface", 10, 10, {});
  for (int node : named(mesh.node_sets, "right").nodes) EXPECT_EQ(position(mesh, node)[0], 0.5);
  for (int node : named(mesh.node_sets, "top").nodes) EXPECT_EQ(position(mesh, node)[1], 2.5);
}

TEST(BoxTest, BrickHasItsCellsNodesAndSets) {
  const Mesh mesh = box(example(3));
  EXPECT_EQ(mesh.cells(), 24);
  EXPECT_EQ(mesh.nodes(), 60);
  for (int cell = 0; cell < 24; ++cell) {
    const std::vector<Vec> x = cell_corners(mesh, cell);
    const double volume = dot(cross(minus(x[1], x[0]), minus(x[3], x[0])), minus(x[4], x[0]));
    EXPECT_NEAR(volume, 1.5 * 2 * 3 / 24, 1e-14);
  }
  expect_set(mesh, "left", 8, 15, {-6.0, 0.0, 0.0});
  expect_set(mesh, "right", 8, 15, {6.0, 0.0, 0.0});
  expect_set(mesh, "front", 12, 20, {0.0, -4.5, 0.0});
  expect_set(mesh, "back", 12, 20, {0.0, 4.5, 0.0});
  expect_set(mesh, "bottom", 6, 12, {0.0, 0.0, -3.0});
  expect_set(mesh, "top", 6, 12, {0.0, 0.0, 3.0});
  expect_set(mesh, "surface", 52, 54, {});
}

TEST(BoxTest, BadValuesAreRefused) {
  EXPECT_EQ(refusal(box, [](BoxShape& s) { s.dimension = 1; }), "dimension 1 must be 2 or 3");
  EXPECT_EQ(refusal(box, [](BoxShape& s) { s.dimension = 4; }), "dimension 4 must be 2 or 3");
  EXPECT_EQ(refusal(box, [](BoxShape& s) { s.lengths[1] = 0; }), "length 0 must be positive");
  EXPECT_EQ(refusal(box, [](BoxShape& s) { s.lengths[0] = -1.5; }), "length -1.5 must be positive");
  const auto flat = [](BoxShape& s) {
    s.dimension = 3;
    s.divisions[2] = 0;
  };
  EXPECT_EQ(refusal(box, flat), "divisions 0 must be at least 1");
}

}  // namespace
}  // namespace ixos

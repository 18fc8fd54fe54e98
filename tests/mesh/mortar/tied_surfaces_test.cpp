#include "mesh/mortar/tied_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/error.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/mortar/mortar_sums.hpp"
#include "mesh/normalize.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "mesh/tied_nodes.hpp"
#include "support/refusal.hpp"
#include "support/tied_bodies.hpp"

namespace ixos {
namespace {

/// The integrals of the shape functions of a surface.
std::map<int, double> shares(const Mesh& mesh, const std::string& set, bool axisymmetric) {
  std::map<int, double> result;
  for (const Side& side : side_set_named(mesh, set).sides) {
    const Facet facet(mesh, side);
    const ProjectionPlane plane = facet.plane();
    for (const Polygon& part : facet.images(plane))
      for (const auto& [image, weight] : points_of(part, 24)) {
        const Vec<2> xi = *facet.find(plane, image);
        const std::vector<double> value = facet.values(xi);
        for (std::size_t a = 0; a < value.size(); ++a)
          result[facet.nodes()[a]] += weight * value[a] * (axisymmetric ? facet.point(xi)[0] : 1.0);
      }
  }
  return result;
}

/// Ties the boxes and expects that a constant stress on the joint is that on both sides.
void expect_constant_stress(Mesh mesh, const std::string& what) {
  SCOPED_TRACE(what);
  const std::vector<double> before = mesh.coordinates;
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  std::map<int, double> passed;
  const std::map<int, double> secondary = shares(mesh, "upper_bottom", mesh.axisymmetric);
  ASSERT_EQ(mesh.ties.size(), secondary.size());
  for (const Tie& tie : mesh.ties) {
    double sum = 0;
    for (std::size_t k = 0; k < tie.masters.size(); ++k) {
      sum += tie.weights[k];
      passed[tie.masters[k]] += tie.weights[k] * secondary.at(tie.node);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
  }
  for (const auto& [node, share] : shares(mesh, "lower_top", mesh.axisymmetric))
    EXPECT_NEAR(passed[node], share, 1e-11);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(mesh.coordinates[i], before[i], 1e-12);
}

TEST(TiedSurfacesTest, ConstantStressComesBackAsItShould) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2})
      for (const bool axisymmetric : {false, true}) {
        if (axisymmetric && dimension == 3) continue;
        Mesh mesh = test::stacked_boxes(dimension, order);
        mesh.axisymmetric = axisymmetric;
        expect_constant_stress(mesh, std::to_string(dimension) + "D, order " + std::to_string(order));
      }
}

TEST(TiedSurfacesTest, ConstantStressPassesBetweenTriangles) {
  for (const test::StackedCells& cells : test::stacked_triangles())
    expect_constant_stress(test::stacked_boxes(cells),
                           cells.lower + " below " + cells.upper + ", order " + std::to_string(cells.order));
}

TEST(TiedSurfacesTest, TrianglesOfSixNodesCannotFollow) {
  Mesh mesh = test::stacked_boxes(test::StackedCells{"tetrahedra", "tetrahedra", 2});
  test::expect_contains(test::refusal([&] { tie_surfaces(mesh, "upper_bottom", "lower_top", 0); }),
                        "triangles of six nodes");
}

/// Ties the boxes and expects that nodes of their rims follow nodes of the same rims alone, and corners corners.
void expect_rims_to_follow_rims(Mesh mesh) {
  const int dimension = mesh.dimension;
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  int corners = 0;
  for (const Tie& tie : mesh.ties) {
    int sides = 0;
    for (int i = 0; i + 1 < dimension; ++i)
      for (const double end : {0.0, 3.0}) {
        const auto at = [&](int node) {
          return std::abs(mesh.coordinates[static_cast<std::size_t>(node * dimension + i)] - end) < 1e-9;
        };
        if (!at(tie.node)) continue;
        ++sides;
        for (const int master : tie.masters) EXPECT_TRUE(at(master));
      }
    if (sides + 1 < dimension) continue;
    ++corners;
    EXPECT_EQ(tie.weights, std::vector<double>{1.0});
  }
  EXPECT_EQ(corners, 1 << (dimension - 1));
}

TEST(TiedSurfacesTest, BoundariesFollowBoundariesAndCornersCorners) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) expect_rims_to_follow_rims(test::stacked_boxes(dimension, order));
  // A triangle in a corner may have no node inside.
  for (const test::StackedCells& cells : test::stacked_triangles())
    expect_rims_to_follow_rims(test::stacked_boxes(cells));
}

/// Two blocks, one upon the other: the upper one is `width` wide and at height `gap` above the lower one of width 4.
Mesh two_blocks(double width, double gap, double left = 0) {
  BoxShape lower, upper;
  lower.lengths = {4, 1, 1};
  lower.divisions = {4, 1, 1};
  upper.lower = {left, 1 + gap, 0};
  upper.lengths = {width, 1, 1};
  upper.divisions = {3, 1, 1};
  return joined_parts({{"lower", box(lower)}, {"upper", box(upper)}});
}

std::string refusal(Mesh mesh, const std::string& secondary, const std::string& primary, double tolerance = 0) {
  return test::refusal([&] { tie_surfaces(mesh, secondary, primary, tolerance); });
}

TEST(TiedSurfacesTest, RefusesSurfacesThatDoNotMeet) {
  EXPECT_EQ(refusal(two_blocks(3, 0), "upper_bottom", "lower_top"), "");
  const auto expect = [](const Mesh& mesh, const std::string& secondary, const std::string& primary,
                         const std::string& words) { test::expect_contains(refusal(mesh, secondary, primary), words); };
  expect(
      two_blocks(3, 0), "lower_top", "upper_bottom",
      "no side of \"upper_bottom\" faces the side of \"lower_top\" at (3.5, 1): the middle of the nearest one, at (");
  expect(two_blocks(3, 0, 1.5), "upper_bottom", "lower_top", "face 50 % of the side");
  expect(two_blocks(3, 0.25), "upper_bottom", "lower_top", "is 0.25 L0 away");
  expect(two_blocks(3, 0), "upper_top", "lower_top", "looks the same way");
  expect(two_blocks(3, 0), "upper_bottom", "upper_left", "share node");
  expect(two_blocks(3, 0), "upper_bottom", "lower_tip", "\"lower_top\"");
}

TEST(TiedSurfacesTest, MovesNodesOntoTheOtherSurfaceWithinTheTolerance) {
  Mesh mesh = two_blocks(3, 0.04);
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  for (const Tie& tie : mesh.ties) EXPECT_NEAR(mesh.coordinates[static_cast<std::size_t>(tie.node) * 2 + 1], 1, 1e-15);
  Mesh far = two_blocks(3, 0.3);
  tie_surfaces(far, "upper_bottom", "lower_top", 0.31);
  ASSERT_EQ(far.notes.size(), 1U);
  EXPECT_EQ(far.notes.front(),
            "the nodes of \"upper_bottom\" moved by up to 0.3 L0 onto \"lower_top\", which they follow");
  for (const Tie& tie : far.ties) EXPECT_NEAR(far.coordinates[static_cast<std::size_t>(tie.node) * 2 + 1], 1, 1e-15);
}

TEST(TiedSurfacesTest, ToleratesHalfASideAtMost) {
  EXPECT_EQ(refusal(two_blocks(3, 0), "upper_bottom", "lower_top", 0.5), "");
  test::expect_contains(
      refusal(two_blocks(3, 0), "upper_bottom", "lower_top", 0.51),
      "the Tolerance, 0.51 L0, is more than half of the side of \"upper_bottom\" at (0.5, 1), which is 1 L0");
}

TEST(TiedSurfacesTest, PrimaryNodesMayFollowOthersButNoSecondaryOnes) {
  Mesh mesh = two_blocks(3, 0);
  RefinedRegion corner;
  corner.upper = {0.5, 1.5};
  corner.lower = {-1, 0.5};
  refine(mesh, {{"corner", corner}}, 1);
  EXPECT_EQ(refusal(mesh, "upper_bottom", "lower_top"), "");  // in the plane surfaces have no hanging nodes
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  test::expect_contains(refusal(mesh, "upper_bottom", "lower_top"), "follows other nodes already");
  EXPECT_NO_THROW(resolved_ties(mesh));
}

/// One coarse side before many fine ones, far from the origin of a file's coordinates.
TEST(TiedSurfacesTest, ACoarseSideFindsAllFineOnes) {
  BoxShape lower, upper;
  lower.dimension = upper.dimension = 3;
  lower.divisions = {60, 60, 1};
  upper.divisions = {1, 1, 1};
  lower.lower = {7, -13, 0};
  upper.lower = {7, -13, 1};
  Mesh mesh = joined_parts({{"lower", box(lower)}, {"upper", box(upper)}});
  EXPECT_EQ(refusal(mesh, "upper_bottom", "lower_top"), "");
}

/// Both ends of two cylinders, whose rims are other polygons of one circle.
TEST(TiedSurfacesTest, RoundFacesOfOtherDivisionsAreTied) {
  const auto cylinder = [](int n, double bottom) {
    BoxShape shape;
    shape.dimension = 3;
    shape.lower = {-1, -1, bottom};
    shape.lengths = {2, 2, 1};
    shape.divisions = {n, n, 1};
    Mesh mesh = box(shape);
    for (std::size_t k = 0; k < mesh.coordinates.size(); k += 3) {  // squares become circles
      const double x = mesh.coordinates[k], y = mesh.coordinates[k + 1];
      mesh.coordinates[k] = x * std::sqrt(1 - y * y / 2);
      mesh.coordinates[k + 1] = y * std::sqrt(1 - x * x / 2);
    }
    return mesh;
  };
  for (const auto& [lower, upper] : {std::pair{6, 8}, {8, 6}, {9, 7}}) {
    Mesh mesh = joined_parts({{"lower", cylinder(lower, 0)}, {"upper", cylinder(upper, 1)}});
    EXPECT_EQ(refusal(mesh, "upper_bottom", "lower_top"), "") << lower << " and " << upper;
    tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
    EXPECT_EQ(mesh.ties.size(), static_cast<std::size_t>((upper + 1) * (upper + 1)));
  }
}

TEST(TiedSurfacesTest, NodesKeepTheirPlaceInTheListWhenOthersGo) {
  Mesh mesh = two_blocks(3, 0);
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  mesh.coordinates.insert(mesh.coordinates.begin(), {9, 9});
  for (ElementBlock& block : mesh.blocks)
    for (int& node : block.nodes) ++node;
  for (Tie& tie : mesh.ties) {
    ++tie.node;
    for (int& master : tie.masters) ++master;
  }
  for (int& node : mesh.nodes_of_tied_sides) ++node;
  const std::vector<int> before = mesh.nodes_of_tied_sides;
  drop_unused_nodes(mesh);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(mesh.nodes_of_tied_sides[k], before[k] - 1);
}

}  // namespace
}  // namespace ixos

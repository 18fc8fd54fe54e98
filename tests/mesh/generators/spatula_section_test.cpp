// Sections and centreline of a spatula, by what their definitions say.
#include "mesh/generators/spatula_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

using Point = std::array<double, 2>;

/// Divisions of a section; nothing here depends on the cells along the spatula but station_length().
SpatulaDivisions section(int core_cells, int core_layers, int rings) {
  return {core_cells, core_layers, rings, 1, 5, 7, 11};
}

const SpatulaDivisions sections[] = {section(4, 1, 1), section(8, 2, 2), section(6, 5, 3), section(44, 2, 2)};

/// Returns the nodes of a ring, anticlockwise from the lower left corner on.
std::vector<SectionNode> around(const SpatulaDivisions& d, int ring) {
  std::vector<SectionNode> nodes;
  nodes.reserve(2 * static_cast<std::size_t>(d.core_cells + d.core_layers));
  for (int i = 0; i < d.core_cells; ++i) nodes.push_back({i, 0, ring});
  for (int j = 0; j < d.core_layers; ++j) nodes.push_back({d.core_cells, j, ring});
  for (int i = d.core_cells; i > 0; --i) nodes.push_back({i, d.core_layers, ring});
  for (int j = d.core_layers; j > 0; --j) nodes.push_back({0, j, ring});
  return nodes;
}

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

TEST(SpatulaLayersTest, ThicknessesGrowByOneFactorFromTheUndersideOn) {
  for (const SpatulaDivisions& d : sections)
    for (double ratio : {1.0, 2.0, 5.0}) {
      SpatulaShape shape;
      shape.layer_ratio = ratio;
      const SpatulaLayers layers(shape, d);
      std::vector<double> heights;  // upwards through the lower rings, the core and the upper rings
      for (int ring = d.rings; ring > 0; --ring) heights.push_back(layers.height({0, 0, ring}));
      for (int layer = 0; layer < d.core_layers; ++layer) heights.push_back(layers.height({0, layer, 0}));
      for (int ring = 0; ring <= d.rings; ++ring) heights.push_back(layers.height({0, d.core_layers, ring}));
      EXPECT_EQ(heights.front(), 0);
      EXPECT_EQ(heights.back(), 1);
      const auto thickness = [&](std::size_t k) { return heights[k + 1] - heights[k]; };
      const std::size_t last = heights.size() - 2;
      EXPECT_NEAR(thickness(last) / thickness(0), ratio, 1e-12);
      for (std::size_t k = 0; k < last; ++k)
        EXPECT_NEAR(thickness(k + 1) / thickness(k), std::pow(ratio, 1.0 / static_cast<double>(last)), 1e-12);
    }
}

// At the narrow ends a ring's cells divide the height between its lower and its upper side as the core is divided.
TEST(SpatulaLayersTest, RingsAreDividedLikeTheCore) {
  const SpatulaDivisions d = section(6, 5, 3);
  const SpatulaLayers layers(SpatulaShape{}, d);
  const auto share = [&](int layer, int ring) {
    const double lower = layers.height({0, 0, ring}), upper = layers.height({0, d.core_layers, ring});
    return (layers.height({0, layer, ring}) - lower) / (upper - lower);
  };
  for (int layer = 1; layer < d.core_layers; ++layer)
    for (int ring = 1; ring <= d.rings; ++ring) EXPECT_NEAR(share(layer, ring), share(layer, 0), 1e-14);
}

TEST(DiskNodeTest, TheSurfaceIsACircleDividedEvenlyOnEachSide) {
  SpatulaShape shape;
  shape.shaft_diameter = 50;
  for (const SpatulaDivisions& d : sections) {
    const std::vector<SectionNode> nodes = around(d, d.rings);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Point here = disk_node(shape, d, nodes[k]), next = disk_node(shape, d, nodes[(k + 1) % nodes.size()]);
      EXPECT_NEAR(std::hypot(here[0], here[1]), 25, 1e-13);
      // Its side begins like the lower side or like the right end.
      const bool flat =
          k % static_cast<std::size_t>(d.core_cells + d.core_layers) < static_cast<std::size_t>(d.core_cells);
      const std::size_t first = flat ? 0 : static_cast<std::size_t>(d.core_cells);
      EXPECT_NEAR(distance(here, next),
                  distance(disk_node(shape, d, nodes[first]), disk_node(shape, d, nodes[first + 1])), 1e-13)
          << k;
    }
  }
}

TEST(DiskNodeTest, IsSymmetricInBothDirections) {
  const SpatulaShape shape;
  const SpatulaDivisions d = section(6, 5, 3);
  for (int ring = 0; ring <= d.rings; ++ring)
    for (const SectionNode& node : around(d, ring)) {
      const Point here = disk_node(shape, d, node);
      const Point beside = disk_node(shape, d, {d.core_cells - node.column, node.layer, ring});
      const Point above = disk_node(shape, d, {node.column, d.core_layers - node.layer, ring});
      EXPECT_NEAR(beside[0], -here[0], 1e-13);
      EXPECT_NEAR(beside[1], here[1], 1e-13);
      EXPECT_NEAR(above[0], here[0], 1e-13);
      EXPECT_NEAR(above[1], -here[1], 1e-13);
    }
  const Point middle = disk_node(shape, section(4, 2, 1), {2, 1, 0});
  EXPECT_NEAR(std::hypot(middle[0], middle[1]), 0, 1e-13);
}

/// The least product of two edges of a quadrilateral that meet, with the sine of the angle between them: positive if
/// the corners are convex and follow each other anticlockwise.
double least_corner(const std::array<Point, 4>& corners) {
  double least = 1e300;
  for (std::size_t a = 0; a < 4; ++a) {
    const Point &o = corners[a], &p = corners[(a + 1) % 4], &q = corners[(a + 3) % 4];
    least = std::min(least, (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]));
  }
  return least;
}

TEST(DiskNodeTest, AllCellsAreConvex) {
  const SpatulaShape shape;
  for (const SpatulaDivisions& d : sections) {
    const auto at = [&](const SectionNode& node) { return disk_node(shape, d, node); };
    for (int i = 0; i < d.core_cells; ++i)
      for (int j = 0; j < d.core_layers; ++j)
        EXPECT_GT(least_corner({at({i, j, 0}), at({i + 1, j, 0}), at({i + 1, j + 1, 0}), at({i, j + 1, 0})}), 0)
            << d.core_cells << ": " << i << ", " << j;
    for (int ring = 0; ring < d.rings; ++ring) {
      const std::vector<SectionNode> inner = around(d, ring), outer = around(d, ring + 1);
      for (std::size_t k = 0; k < inner.size(); ++k) {
        const std::size_t next = (k + 1) % inner.size();
        EXPECT_GT(least_corner({at(inner[k]), at(outer[k]), at(outer[next]), at(inner[next])}), 0)
            << d.core_cells << ": " << ring << ", " << k;
      }
    }
  }
}

TEST(CenterlineTest, IsAnArcAndThenAStraightLine) {
  for (double inclination : {30.0, 45.0, 90.0}) {
    SpatulaShape shape;
    shape.inclination = inclination;
    const double r = shape.fillet_radius, angle = inclination * M_PI / 180, arc = r * angle;
    const double start = shape.gap + shape.rear_thickness / 2;  // the middle of the pad's rear end
    const CenterlinePoint first = centerline(shape, 0), end = centerline(shape, arc);
    EXPECT_EQ(first.x, 0);
    EXPECT_EQ(first.z, start);
    for (double share : {0.0, 0.2, 0.7, 1.0}) {
      const CenterlinePoint p = centerline(shape, share * arc);
      EXPECT_NEAR(std::hypot(p.x, p.z - start - r), r, 1e-12);
      EXPECT_NEAR(p.sine, std::sin(share * angle), 1e-14);
      EXPECT_NEAR(p.cosine, std::cos(share * angle), 1e-14);
    }
    for (double beyond : {10.0, 200.0}) {
      const CenterlinePoint p = centerline(shape, arc + beyond);
      EXPECT_NEAR(p.x, end.x - beyond * std::cos(angle), 1e-11);
      EXPECT_NEAR(p.z, end.z + beyond * std::sin(angle), 1e-11);
      EXPECT_NEAR(p.sine, std::sin(angle), 1e-14);
    }
  }
}

// The derivative by the length is the unit vector at a right angle to the section's upward direction.
TEST(CenterlineTest, TheLengthIsMeasuredAlongIt) {
  const SpatulaShape shape;
  const double h = 1e-4;
  for (double length = 1; length < 300; length += 7) {
    const CenterlinePoint p = centerline(shape, length), behind = centerline(shape, length - h),
                          ahead = centerline(shape, length + h);
    EXPECT_NEAR((ahead.x - behind.x) / (2 * h), -p.cosine, 1e-8) << length;
    EXPECT_NEAR((ahead.z - behind.z) / (2 * h), p.sine, 1e-8) << length;
  }
}

// These conditions determine a quintic: values, and no slope and no curvature at both ends.
TEST(RoundnessTest, IsTheQuinticBetweenRectangleAndDisk) {
  SpatulaShape shape;
  shape.transition_length = 80;
  const auto at = [&](double share) { return roundness(shape, 80 * share); };
  EXPECT_EQ(at(0), 0);
  EXPECT_EQ(at(1), 1);
  EXPECT_EQ(at(1.5), 1) << "in the shaft";
  for (double small : {0.1, 0.01, 0.001}) {
    EXPECT_LT(at(small), 10 * small * small * small) << "as flat as a cubic";
    EXPECT_GT(at(small), 0);
    EXPECT_NEAR(at(small) + at(1 - small), 1, 1e-13) << "the other end is the same";
  }
  // The sixth differences of a quintic vanish, the fifth do not.
  double sixth = 0, fifth = 0;
  const double binomial6[] = {1, -6, 15, -20, 15, -6, 1}, binomial5[] = {1, -5, 10, -10, 5, -1};
  for (int k = 0; k < 7; ++k) sixth += binomial6[k] * at(k / 6.0);
  for (int k = 0; k < 6; ++k) fifth += binomial5[k] * at(k / 6.0);
  EXPECT_NEAR(sixth, 0, 1e-13);
  EXPECT_GT(std::abs(fifth), 1e-3);
}

TEST(StationLengthTest, DividesTheShaftEvenlyAndTheTransitionGeometrically) {
  const SpatulaDivisions d = section(8, 2, 2);
  for (double growth : {1.0, 2.0, 4.0}) {
    SpatulaShape shape;
    shape.growth = growth;
    const auto at = [&](int station) { return station_length(shape, d, station); };
    EXPECT_NEAR(at(0), shape.transition_length + shape.shaft_length, 1e-12);
    EXPECT_NEAR(at(d.shaft), shape.transition_length, 1e-12);
    EXPECT_NEAR(at(d.shaft + d.transition), 0, 1e-12);
    const auto cell = [&](int station) { return at(station) - at(station + 1); };
    for (int k = 0; k < d.shaft; ++k) EXPECT_NEAR(cell(k), shape.shaft_length / d.shaft, 1e-12);
    // Towards the pad each cell is shorter by the factor whose power over the whole transition is the growth.
    for (int k = d.shaft; k + 1 < d.shaft + d.transition; ++k)
      EXPECT_NEAR(cell(k) / cell(k + 1), std::pow(growth, 1.0 / d.transition), 1e-12) << k;
  }
}

}  // namespace
}  // namespace ixos

#include "mesh/mortar/facet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

/// A box with curved sides: x and y are stretched unevenly.
Mesh bent_box(int dimension, int order) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {2, 2, 2};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()); ++n) {
    double* const x = &mesh.coordinates[n * d];
    const double bend = 0.1 * std::sin(3 * x[0]) * x[1];
    x[0] += bend;
    x[d - 1] += 0.05 * x[0] * x[0];
  }
  return mesh;
}

TEST(FacetTest, FindsThePointsThatItPlaces) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      const Mesh mesh = bent_box(dimension, order);
      for (const Side& side : side_set_named(mesh, "surface").sides) {
        const Facet facet(mesh, side);
        const ProjectionPlane plane = facet.plane();
        const Vec<2> xi{0.3, dimension == 2 ? 0.0 : -0.6};
        const auto found = facet.find(plane, plane.image(facet.point(xi)));
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(length(*found - xi), 0, 1e-13) << dimension << "D, order " << order;
        double area_of_images = 0;
        for (const Polygon& part : facet.images(plane)) {
          EXPECT_GT(area(part), 0);
          area_of_images += area(part);
        }
        EXPECT_NEAR(area_of_images, dimension == 2 ? 0.5 : 0.25, 0.12);
      }
    }
}

TEST(FacetTest, KnowsWhetherItsMapIsAffine) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      BoxShape shape;
      shape.dimension = dimension;
      Mesh straight = box(shape);
      if (order == 2) raise_order(straight);
      for (const Side& side : side_set_named(straight, "surface").sides) EXPECT_TRUE(Facet(straight, side).is_affine());
      const Mesh bent = bent_box(dimension, order);
      int bent_sides = 0;
      for (const Side& side : side_set_named(bent, "surface").sides)
        if (!Facet(bent, side).is_affine()) ++bent_sides;
      EXPECT_EQ(bent_sides > 0, dimension == 3 || order == 2);
    }
}

TEST(FacetTest, EdgesAndEndsOfABoxsSide) {
  for (const int order : {1, 2}) {
    BoxShape shape;
    shape.dimension = 3;
    shape.divisions = {3, 2, 1};
    Mesh mesh = box(shape);
    if (order == 2) raise_order(mesh);
    std::vector<Facet> sides;
    for (const Side& side : side_set_named(mesh, "top").sides) sides.emplace_back(mesh, side);
    const std::vector<Facet> edges = boundary_edges(sides);
    EXPECT_EQ(edges.size(), 10);
    double around = 0;
    for (const Facet& edge : edges) {
      around += area(edge.images(edge.plane()).front());
      EXPECT_EQ(edge.nodes().size(), static_cast<std::size_t>(order + 1));
      EXPECT_TRUE(edge.is_affine());
      EXPECT_EQ(edge.normal(), (Vec<3>{0, 0, 0}));
    }
    EXPECT_NEAR(around, 4, 1e-14);
    EXPECT_EQ(curve_ends(edges).size(), 4);
  }
}

TEST(FacetTest, HasNoPointFarAway) {
  const Mesh mesh = box(BoxShape());
  const Facet facet(mesh, side_set_named(mesh, "bottom").sides.front());
  EXPECT_FALSE(facet.find(facet.plane(), {1000, 0}).has_value());
}

}  // namespace
}  // namespace ixos

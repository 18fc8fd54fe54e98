#include "mesh/layers.hpp"

#include <gtest/gtest.h>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

Mesh slab(int dimension, int layers, ContactElement element = ContactElement::Q1C1) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {8, dimension == 2 ? 0.5 : 3.0, 0.5};
  shape.divisions = {8, dimension == 2 ? layers : 3, layers};
  Mesh mesh = box(shape);
  enrich(mesh, "bottom", element);
  return mesh;
}

TEST(SingleLayerTest, OneLayerIsFoundInBothDimensionsAndWithAnyElement) {
  for (int dimension : {2, 3})
    for (ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C4, ContactElement::Q1CH}) {
      const Mesh mesh = slab(dimension, 1, element);
      const SingleLayer layer = single_layer(mesh, side_set_named(mesh, "bottom"));
      EXPECT_DOUBLE_EQ(layer.share, 1);
      EXPECT_NEAR(layer.thickness, 0.5, 1e-15);
    }
}

TEST(SingleLayerTest, TwoLayersAreNone) {
  for (int dimension : {2, 3}) {
    const Mesh mesh = slab(dimension, 2, ContactElement::Q1C2);
    EXPECT_EQ(single_layer(mesh, side_set_named(mesh, "bottom")).share, 0);
  }
}

TEST(SingleLayerTest, ASurfaceAllAroundCountsOnlyItsThinSides) {
  // The slab has 16 sides along it and 2 across its ends, whose cells have neighbours behind them.
  const Mesh mesh = slab(2, 1);
  const SingleLayer layer = single_layer(mesh, side_set_named(mesh, "surface"));
  EXPECT_DOUBLE_EQ(layer.share, 16.0 / 18);
}

}  // namespace
}  // namespace ixos

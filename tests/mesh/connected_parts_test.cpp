#include "mesh/connected_parts.hpp"

#include <gtest/gtest.h>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

TEST(ConnectedPartsTest, BlocksThatShareANodeAreOnePart) {
  // Squares 0 1 4 3, 1 2 5 4 and, apart from them, 6 7 9 8.
  Mesh mesh;
  mesh.coordinates = {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1, 5, 0, 6, 0, 5, 1, 6, 1};
  mesh.blocks = {{"a", CellType::Quad4, {0, 1, 4, 3}}, {"b", CellType::Quad4, {6, 7, 9, 8, 1, 2, 5, 4}}};
  EXPECT_EQ(connected_parts(mesh), (std::vector<int>{0, 0, 0, 0, 0, 0, 6, 6, 6, 6}));
}

TEST(ConnectedPartsTest, NodesOfContactElementsBelongToTheBody) {
  for (ContactElement element : {ContactElement::Q1C4, ContactElement::Q1CH}) {
    BoxShape shape;
    shape.divisions = {4, 2, 1};
    Mesh mesh = box(shape);
    enrich(mesh, "bottom", element);
    EXPECT_EQ(connected_parts(mesh), std::vector<int>(static_cast<std::size_t>(mesh.nodes()), 0));
  }
}

}  // namespace
}  // namespace ixos

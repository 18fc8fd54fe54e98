#include "mesh/cell_place.hpp"

#include <gtest/gtest.h>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

Mesh squares() {
  BoxShape shape;
  shape.lengths = {4, 2, 1};
  shape.divisions = {4, 2, 1};
  return box(shape);
}

TEST(CellPlaceTest, ACellHasItsNumberInTheBlockAndItsCentre) {
  const Mesh mesh = squares();
  EXPECT_EQ(in_words(place_of(mesh, mesh.blocks[0], 6), 2), "block \"body\", cell 7 at (2.5, 1.5)");
  BoxShape shape;
  shape.dimension = 3;
  const Mesh brick = box(shape);
  EXPECT_EQ(in_words(place_of(brick, brick.blocks[0], 0), 3), "block \"body\", cell 1 at (0.5, 0.5, 0.5)");
}

TEST(CellPlaceTest, ACellOfAFileHasItsNumberThereToo) {
  Mesh mesh = squares();
  mesh.blocks[0].file_numbers = {10, 20, 30, 40, 50, 60, 3000000000, 80};
  EXPECT_EQ(in_words(place_of(mesh, mesh.blocks[0], 6), 2),
            "block \"body\", cell 7 (number 3000000000 in the file) at (2.5, 1.5)");
}

// The bottom's cells, numbers 10 to 40, move to a block of their own.
TEST(CellPlaceTest, CellsKeepTheirNumbersWhenSidesAreEnriched) {
  Mesh mesh = squares();
  mesh.blocks[0].file_numbers = {10, 20, 30, 40, 50, 60, 70, 80};
  enrich(mesh, "bottom", ContactElement::Q1C2);
  ASSERT_EQ(mesh.blocks.size(), 2U);
  for (const ElementBlock& block : mesh.blocks) {
    ASSERT_EQ(block.file_numbers.size(), 4U);
    for (int cell = 0; cell < 4; ++cell) {
      const CellPlace place = place_of(mesh, block, cell);
      EXPECT_EQ(place.in_file, 10 * (1 + static_cast<long long>(place.centre[0]) + (place.centre[1] > 1 ? 4 : 0)));
    }
  }
}

}  // namespace
}  // namespace ixos

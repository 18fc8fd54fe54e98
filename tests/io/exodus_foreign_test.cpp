// Exodus files as other programs write them: shells, ids of 64 bits, cells that are numbered as mirror images.
#include <gtest/gtest.h>

#include <exodusII.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "io/exodus_mesh.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::expect_contains;

std::string path() { return testing::TempDir() + "foreign.e"; }

std::string refusal() {
  return test::refusal([] { check_cells(read_exodus_mesh(path())); });
}

/// Two squares side by side, 0 to 2 by 0 to 1, in one block; the side set holds one side of the second.
struct Squares {
  int dimension = 2;
  const char* type = "QUAD4";
  int side = 2;       ///< of the second square, from 1: nodes 3 and 6 in a quadrilateral
  double height = 0;  ///< z of node 3
  bool with_brick = false;
  int mode = EX_CLOBBER;
  std::int64_t block = 1, node_set = 1, side_set = 1;
  std::vector<std::int64_t> numbers{};  ///< of the elements; empty: no map
  std::vector<int> second{2, 3, 6, 5};
};

void write(const Squares& s) {
  int word = 8, stored = 8;
  const int id = ex_create(path().c_str(), s.mode | EX_IDS_INT64_API | EX_MAPS_INT64_API, &word, &stored);
  double x[] = {0, 1, 2, 0, 1, 2, 0, 1, 1, 0}, y[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 1};
  double z[] = {0, 0, s.height, 0, 0, 0, 1, 1, 1, 1};
  std::vector<int> cells{1, 2, 5, 4};
  cells.insert(cells.end(), s.second.begin(), s.second.end());
  int brick[] = {1, 2, 5, 4, 7, 8, 9, 10}, nodes[] = {3, 6}, element[] = {2}, side[] = {s.side};
  ex_put_init(id, "squares", s.dimension, s.with_brick ? 10 : 6, s.with_brick ? 3 : 2, s.with_brick ? 2 : 1, 1, 1);
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, s.block, s.type, 2, 4, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, s.block, cells.data(), nullptr, nullptr);
  if (s.with_brick) {
    ex_put_block(id, EX_ELEM_BLOCK, s.block + 1, "HEX8", 1, 8, 0, 0, 0);
    ex_put_conn(id, EX_ELEM_BLOCK, s.block + 1, brick, nullptr, nullptr);
  }
  ex_put_set_param(id, EX_NODE_SET, s.node_set, 2, 0);
  ex_put_set(id, EX_NODE_SET, s.node_set, nodes, nullptr);
  ex_put_set_param(id, EX_SIDE_SET, s.side_set, 1, 0);
  ex_put_set(id, EX_SIDE_SET, s.side_set, element, side);
  if (!s.numbers.empty()) ex_put_id_map(id, EX_ELEM_MAP, s.numbers.data());
  ex_close(id);
}

/// Expects two sound squares whose side set is their right end, x = 2.
void expect_squares(const Mesh& mesh) {
  EXPECT_EQ(mesh.dimension, 2);
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1}));
  ASSERT_EQ(mesh.blocks.size(), 1U);
  EXPECT_EQ(mesh.blocks[0].type, CellType::Quad4);
  EXPECT_EQ(mesh.blocks[0].nodes, (std::vector<int>{0, 1, 4, 3, 1, 2, 5, 4}));
  ASSERT_EQ(mesh.side_sets.at(0).sides.size(), 1U);
  EXPECT_EQ(sorted_corners(mesh, mesh.side_sets[0].sides[0]), sorted_corners({2, 5}));
  EXPECT_EQ(mesh.node_sets.at(0).nodes, (std::vector<int>{2, 5}));
  EXPECT_NO_THROW(check_cells(mesh));
}

TEST(ExodusForeignTest, ShellsInThePlaneAreQuadrilaterals) {
  for (const char* type : {"SHELL4", "SHELL", "shell4", "Shell", "QUAD4", "quad"}) {
    SCOPED_TRACE(type);
    Squares squares;
    squares.type = type;
    write(squares);
    expect_squares(read_exodus_mesh(path()));
    // With three coordinates the sides 1 and 2 of a shell are its faces.
    squares.dimension = 3;
    const bool shell = type[0] == 'S' || type[0] == 's';
    squares.side = shell ? 4 : 2;
    write(squares);
    expect_squares(read_exodus_mesh(path()));
    squares.side = shell ? 2 : 5;
    write(squares);
    expect_contains(refusal(), shell ? "refers to side 2 of element 2; sides 3 to 6 are allowed"
                                     : "refers to side 5 of element 2; sides 1 to 4 are allowed");
  }
}

TEST(ExodusForeignTest, ShellsOfNineNodesAreQuadratic) {
  int word = 8, stored = 8;
  const int id = ex_create(path().c_str(), EX_CLOBBER, &word, &stored);
  double x[] = {0, 2, 2, 0, 1, 2, 1, 0, 1}, y[] = {0, 0, 2, 2, 0, 1, 2, 1, 1}, z[9] = {};
  int cell[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  ex_put_init(id, "one", 3, 9, 1, 1, 0, 0);
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, 1, "SHELL9", 1, 9, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 1, cell, nullptr, nullptr);
  ex_close(id);
  const Mesh mesh = read_exodus_mesh(path());
  EXPECT_EQ(mesh.blocks.at(0).type, CellType::Quad9);
  EXPECT_NEAR(mesh_quality(mesh).volume, 4, 1e-14);
}

TEST(ExodusForeignTest, ShellsInSpaceAreRefusedAsShells) {
  Squares squares;
  squares.dimension = 3;
  squares.type = "SHELL4";
  squares.side = 4;
  squares.height = 0.5;
  write(squares);
  std::string message = refusal();
  expect_contains(message,
                  "foreign.e: the surface elements do not lie in the plane z = 0: a node stands at (2, 0, 0.5)");
  expect_contains(message, "Ixos has no shells in space");
  squares.height = 0;
  squares.with_brick = true;
  write(squares);
  message = refusal();
  expect_contains(message, "block \"block_1\" has shells (SHELL4) beside cells of a volume");
  EXPECT_EQ(message.find("Mesh.SubdivisionAlgorithm"), std::string::npos) << message;
}

TEST(ExodusForeignTest, IdsMayHave64Bits) {
  for (const std::int64_t id : {std::int64_t{2147483647}, std::int64_t{2147483648}, std::int64_t{3000000000},
                                std::int64_t{4294967296}, std::int64_t{9000000000000000000}}) {
    Squares squares;
    squares.mode = EX_CLOBBER | EX_NETCDF4 | EX_IDS_INT64_DB | EX_MAPS_INT64_DB;
    squares.block = squares.node_set = squares.side_set = id;
    squares.numbers = {id + 5, id + 3};
    write(squares);
    const Mesh mesh = read_exodus_mesh(path());
    expect_squares(mesh);
    EXPECT_EQ(mesh.blocks[0].name, "block_" + std::to_string(id));
    EXPECT_EQ(mesh.node_sets[0].name, "nodelist_" + std::to_string(id));
    EXPECT_EQ(mesh.side_sets[0].name, "surface_" + std::to_string(id));
    EXPECT_EQ(mesh.blocks[0].file_numbers, (std::vector<long long>{id + 5, id + 3}));
    squares.numbers = {id + 5, id + 5};
    write(squares);
    expect_contains(refusal(), "element number " + std::to_string(id + 5) + " is given twice");
  }
}

TEST(ExodusForeignTest, MessagesOfCellsNameTheNumberInTheFile) {
  Squares squares;
  squares.second = {2, 3, 5, 6};  // crosses itself
  squares.numbers = {70, 17};
  write(squares);
  expect_contains(refusal(), "block \"block_1\", cell 2 (number 17 in the file) at (1.5, 0.5): inverted or degenerate");
  squares.numbers.clear();
  write(squares);
  expect_contains(refusal(), "block \"block_1\", cell 2 (number 2 in the file) at (1.5, 0.5): inverted or degenerate");
}

TEST(ExodusForeignTest, ClockwiseSquaresAreTurnedWithTwoCoordinatesAsWithThree) {
  Squares squares;
  squares.second = {2, 5, 6, 3};
  squares.side = 3;  // nodes 6 and 3
  for (const int dimension : {2, 3}) {
    squares.dimension = dimension;
    write(squares);
    expect_squares(read_exodus_mesh(path()));
  }
}

/// A body whose x axis is reflected: all its cells are mirror images.
TEST(ExodusForeignTest, MirrorImagesOfAllKindsOfCellsAreTurned) {
  for (const int dimension : {2, 3})
    for (const bool quadratic : {false, true}) {
      BoxShape shape;
      shape.dimension = dimension;
      shape.divisions = {3, 2, 2};
      Mesh mesh = box(shape);
      if (quadratic) raise_order(mesh);
      const auto d = static_cast<std::size_t>(dimension);
      for (std::size_t i = 0; i < mesh.coordinates.size(); i += d) mesh.coordinates[i] = 1 - mesh.coordinates[i];
      write_exodus_mesh(mesh, path(), "mirror image");
      const Mesh back = read_exodus_mesh(path());
      EXPECT_NO_THROW(check_cells(back));
      EXPECT_NEAR(mesh_quality(back).volume, 1, 1e-13);
      EXPECT_EQ(back.coordinates, mesh.coordinates);
      ASSERT_EQ(back.side_sets.size(), mesh.side_sets.size());
      for (std::size_t s = 0; s < mesh.side_sets.size(); ++s)
        for (std::size_t k = 0; k < mesh.side_sets[s].sides.size(); ++k)
          EXPECT_EQ(sorted_corners(back, back.side_sets[s].sides[k]), sorted_corners(mesh, mesh.side_sets[s].sides[k]));
    }
}

}  // namespace
}  // namespace ixos

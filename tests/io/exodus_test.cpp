#include <gtest/gtest.h>

#include <exodusII.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fem/cell_info.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "support/refusal.hpp"
#include "support/simplices.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::expect_contains;

std::string path(const std::string& name) { return testing::TempDir() + name; }

std::string refusal(const std::string& file) {
  return test::refusal([&] { check_cells(read_exodus_mesh(file)); });
}

/// A box, written after a change.
template <class Change>
std::string changed_box(const std::string& name, const Change& change) {
  BoxShape shape;
  shape.divisions = {2, 2, 2};
  Mesh mesh = box(shape);
  change(mesh);
  write_exodus_mesh(mesh, path(name), "box");
  return refusal(path(name));
}

TEST(ExodusTest, MeshesReadBackAsTheyWereWritten) {
  BoxShape flat, solid;
  flat.divisions = {3, 2, 1};
  solid.dimension = 3;
  solid.divisions = {2, 3, 1};
  DiskShape curved;
  curved.cell_order = 2;
  Mesh bricks = box(solid);
  raise_order(bricks);
  for (Mesh mesh : {disk({}), box(flat), box(solid), disk(curved), bricks}) {
    // A second block: the last cell, with a side of it in a set.
    const int n = nodes_per_cell(mesh.blocks[0].type);
    ElementBlock second{"second", mesh.blocks[0].type, {mesh.blocks[0].nodes.end() - n, mesh.blocks[0].nodes.end()}};
    mesh.blocks[0].nodes.resize(mesh.blocks[0].nodes.size() - static_cast<std::size_t>(n));
    for (SideSet& set : mesh.side_sets)
      for (Side& side : set.sides)
        if (side.cell == mesh.blocks[0].cells()) side = {1, 0, side.side};
    mesh.blocks.push_back(second);
    write_exodus_mesh(mesh, path("round.e"), "round trip");
    const Mesh back = read_exodus_mesh(path("round.e"));
    EXPECT_EQ(back.dimension, mesh.dimension);
    EXPECT_EQ(back.coordinates, mesh.coordinates);
    ASSERT_EQ(back.blocks.size(), 2U);
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_EQ(back.blocks[b].name, mesh.blocks[b].name);
      EXPECT_EQ(back.blocks[b].type, mesh.blocks[b].type);
      EXPECT_EQ(back.blocks[b].nodes, mesh.blocks[b].nodes);
    }
    ASSERT_EQ(back.side_sets.size(), mesh.side_sets.size());
    for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
      EXPECT_EQ(back.side_sets[s].name, mesh.side_sets[s].name);
      ASSERT_EQ(back.side_sets[s].sides.size(), mesh.side_sets[s].sides.size());
      for (std::size_t i = 0; i < mesh.side_sets[s].sides.size(); ++i) {
        EXPECT_EQ(back.side_sets[s].sides[i].block, mesh.side_sets[s].sides[i].block);
        EXPECT_EQ(back.side_sets[s].sides[i].cell, mesh.side_sets[s].sides[i].cell);
        EXPECT_EQ(back.side_sets[s].sides[i].side, mesh.side_sets[s].sides[i].side);
      }
    }
    ASSERT_EQ(back.node_sets.size(), mesh.node_sets.size());
    for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) EXPECT_EQ(back.node_sets[s].name, mesh.node_sets[s].name);
  }
}

/// Returns a mesh of cells of several types whose quadratic form has straight edges.
Mesh split_box(int dimension, const std::string& kind, int order) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {2, 1, 1};
  shape.lower = {-1, 0, 0};
  shape.divisions = {4, 2, 2};
  Mesh mesh = test::split_cells(box(shape), kind);
  if (order == 2) raise_order(mesh);
  return mesh;
}

TEST(ExodusTest, CellsOfAllShapesReadBackAsTheyWereWritten) {
  for (const auto& [dimension, kind] :
       {std::pair(2, "quads and triangles"), {3, "prisms"}, {3, "pyramids"}, {3, "hexahedra to tetrahedra"}})
    for (const int order : {1, 2}) {
      const Mesh mesh = split_box(dimension, kind, order);
      write_exodus_mesh(mesh, path("shapes.e"), "shapes");
      const Mesh back = read_exodus_mesh(path("shapes.e"));
      EXPECT_EQ(back.coordinates, mesh.coordinates);
      ASSERT_EQ(back.blocks.size(), mesh.blocks.size());
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        EXPECT_EQ(back.blocks[b].name, b == 0 ? "body" : "body_" + std::to_string(b + 1));
        EXPECT_EQ(back.blocks[b].type, mesh.blocks[b].type);
        EXPECT_EQ(back.blocks[b].nodes, mesh.blocks[b].nodes);
      }
      ASSERT_EQ(back.side_sets.size(), mesh.side_sets.size());
      for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
        ASSERT_EQ(back.side_sets[s].sides.size(), mesh.side_sets[s].sides.size());
        for (std::size_t i = 0; i < mesh.side_sets[s].sides.size(); ++i)
          EXPECT_EQ(nodes_of_side(back, back.side_sets[s].sides[i]), nodes_of_side(mesh, mesh.side_sets[s].sides[i]));
      }
      // Bubbles are not written.
      Mesh richer = mesh;
      add_bubbles(richer);
      write_exodus_mesh(richer, path("shapes.e"), "shapes");
      EXPECT_EQ(read_exodus_mesh(path("shapes.e")).coordinates, mesh.coordinates);
    }
}

/// The cells of a file with 8, 13, 15 and 20 nodes are the first nodes of those that Ixos computes with.
TEST(ExodusTest, CellsWithoutNodesInsideGetThem) {
  for (const auto& [dimension, kind] :
       {std::pair(2, "quads and triangles"), {3, "hexahedra and prisms"}, {3, "pyramids"}}) {
    const Mesh whole = split_box(dimension, kind, 2);
    const auto corners = [](const ElementBlock& block, std::size_t a) {
      return cell_info(block.type).node_corners[a].size();
    };
    int word = 8, stored = 8;
    const int id = ex_create(path("edges.e").c_str(), EX_CLOBBER, &word, &stored);
    const auto d = static_cast<std::size_t>(dimension);
    const auto nodes = static_cast<std::size_t>(whole.nodes());
    std::array<std::vector<double>, 3> x;
    for (auto& axis : x) axis.assign(nodes, 0.0);
    for (std::size_t k = 0; k < whole.coordinates.size(); ++k) x[k % d][k / d] = whole.coordinates[k];
    ex_put_init(id, "edges", dimension, static_cast<int>(nodes), whole.cells(), static_cast<int>(whole.blocks.size()),
                1, 0);
    ex_put_coord(id, x[0].data(), x[1].data(), x[2].data());
    std::vector<int> bottom;
    for (const ElementBlock& block : whole.blocks) {
      const auto n = static_cast<std::size_t>(nodes_per_cell(block.type));
      std::vector<int> kept;
      int each = 0;
      for (std::size_t k = 0; k < block.nodes.size(); ++k)
        if (corners(block, k % n) <= 2) {
          kept.push_back(block.nodes[k] + 1);
          each += k < n ? 1 : 0;
          if (std::abs(whole.coordinates[static_cast<std::size_t>(block.nodes[k]) * d + d - 1]) < 1e-12)
            bottom.push_back(block.nodes[k] + 1);
        }
      const char* const name = each == 6    ? "TRI6"
                               : each == 8  ? "QUAD8"
                               : each == 20 ? "HEX20"
                               : each == 15 ? "WEDGE15"
                                            : "PYRAMID13";
      const int number = static_cast<int>(&block - whole.blocks.data()) + 1;
      ex_put_block(id, EX_ELEM_BLOCK, number, name, block.cells(), each, 0, 0, 0);
      ex_put_conn(id, EX_ELEM_BLOCK, number, kept.data(), nullptr, nullptr);
    }
    std::sort(bottom.begin(), bottom.end());
    bottom.erase(std::unique(bottom.begin(), bottom.end()), bottom.end());
    ex_put_set_param(id, EX_NODE_SET, 1, static_cast<int64_t>(bottom.size()), 0);
    ex_put_set(id, EX_NODE_SET, 1, bottom.data(), nullptr);
    ex_close(id);
    const Mesh back = read_exodus_mesh(path("edges.e"));
    ASSERT_EQ(back.nodes(), whole.nodes()) << kind;
    for (std::size_t b = 0; b < whole.blocks.size(); ++b) {
      EXPECT_EQ(back.blocks[b].type, whole.blocks[b].type);
      for (std::size_t k = 0; k < whole.blocks[b].nodes.size(); ++k)
        for (std::size_t i = 0; i < d; ++i)
          EXPECT_NEAR(back.coordinates[static_cast<std::size_t>(back.blocks[b].nodes[k]) * d + i],
                      whole.coordinates[static_cast<std::size_t>(whole.blocks[b].nodes[k]) * d + i], 1e-14);
    }
    // The set of the bottom has the middles of its faces.
    int below = 0;
    for (int node = 0; node < back.nodes(); ++node)
      below += std::abs(back.coordinates[static_cast<std::size_t>(node) * d + d - 1]) < 1e-12 ? 1 : 0;
    EXPECT_EQ(static_cast<int>(back.node_sets.at(0).nodes.size()), below) << kind;
  }
}

TEST(ExodusTest, FilesThatAreNotMeshesAreRefused) {
  expect_contains(refusal(path("nowhere.e")), "the mesh file cannot be read");
  expect_contains(refusal(testing::TempDir()), "cannot be read");
  std::filesystem::remove(path("pipe.e"));
  ASSERT_EQ(mkfifo(path("pipe.e").c_str(), 0600), 0);
  expect_contains(refusal(path("pipe.e")), "the mesh file cannot be read");  // nobody writes into it
  std::ofstream(path("text.e")) << "not a mesh";
  expect_contains(refusal(path("text.e")), "is not an Exodus file");
  std::ofstream(path("empty.e")) << "";
  expect_contains(refusal(path("empty.e")), "is not an Exodus file");
  std::ofstream(path("hdf.e")) << "\x89HDF\r\n\x1a\n and then nothing";
  expect_contains(refusal(path("hdf.e")), "is not an Exodus file");
}

// netCDF 4.9.0 divides by a length of zero (NC_check_vlen); this process must not be the one that does.
TEST(ExodusTest, AFileThatEndsItsReaderIsRefused) {
  // "is damaged: reading it crashes", or what newer versions of the reader find out
  expect_contains(refusal(IXOS_TEST_DIRECTORY "/io/divides_by_zero.e"), "is damaged");
}

TEST(ExodusTest, TruncatedFilesAreRefusedOrWhole) {
  write_exodus_mesh(disk({}), path("whole.e"), "disk");
  const auto size = std::filesystem::file_size(path("whole.e"));
  int refused = 0;
  for (std::uintmax_t cut = 0; cut < size; cut += 97) {
    std::filesystem::copy_file(path("whole.e"), path("cut.e"), std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path("cut.e"), cut);
    refused += refusal(path("cut.e")).empty() ? 0 : 1;
  }
  // netCDF reads zeros where a file was cut in its padding: then nothing was lost, or the zeros are found out.
  EXPECT_GE(refused, static_cast<int>(size / 97));
}

/// The dimension of that name in a file of NetCDF's classic format: its length follows the name, as four bytes.
void claim(const std::string& name, const std::string& dimension, std::uint32_t length) {
  std::fstream file(path(name), std::ios::binary | std::ios::in | std::ios::out);
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t found = bytes.find(dimension);
  ASSERT_NE(found, std::string::npos) << dimension;
  file.seekp(static_cast<std::streamoff>(found + (dimension.size() + 3) / 4 * 4));
  for (int shift = 24; shift >= 0; shift -= 8) file.put(static_cast<char>(length >> shift));
}

TEST(ExodusTest, SizesBeyondTheFilesAreRefused) {
  for (const char* dimension : {"num_nodes", "num_elem", "num_el_blk", "num_node_sets", "num_side_sets",
                                "num_el_in_blk1", "num_nod_ns1", "num_side_ss1"}) {
    write_exodus_mesh(disk({}), path("claims.e"), "disk");
    claim("claims.e", dimension, 2000000000);
    EXPECT_NE(refusal(path("claims.e")), "") << dimension << ": accepted";
    claim("claims.e", dimension, 300000);
    EXPECT_NE(refusal(path("claims.e")), "") << dimension << ": accepted";
  }
  // HDF5 keeps no place for what was never written: netCDF has nothing to say against it.
  int word = 8, stored = 8;
  const int id = ex_create(path("claims.e").c_str(), EX_CLOBBER | EX_NETCDF4, &word, &stored);
  ex_put_init(id, "claims", 3, 50000000, 60000000, 1, 0, 0);
  ex_close(id);
  EXPECT_LT(std::filesystem::file_size(path("claims.e")), 100000U);
  expect_contains(refusal(path("claims.e")), "is damaged: it claims 50000000 nodes and 60000000 elements");
}

TEST(ExodusTest, InconsistentMeshesAreRefused) {
  expect_contains(changed_box("inverted.e", [](Mesh& m) { std::swap(m.blocks[0].nodes[0], m.blocks[0].nodes[1]); }),
                  "block \"body\", cell 1 (number 1 in the file) at (0.25, 0.25): inverted or degenerate");
  expect_contains(changed_box("range.e", [](Mesh& m) { m.blocks[0].nodes[0] = 1000; }),
                  "block \"body\" refers to node 1001, but there are 9");
  expect_contains(changed_box("zero.e", [](Mesh& m) { m.blocks[0].nodes[0] = -1; }),
                  "block \"body\" refers to node 0: the file seems to be truncated");
  expect_contains(changed_box("names.e", [](Mesh& m) { m.node_sets[1].name = m.node_sets[0].name; }), "is given twice");
  expect_contains(changed_box("sides.e", [](Mesh& m) { m.side_sets[0].sides[0].side = 5; }),
                  "refers to side 6 of element");
  expect_contains(changed_box("twice.e", [](Mesh& m) { m.side_sets[0].sides.push_back(m.side_sets[0].sides[0]); }),
                  "twice");
  expect_contains(changed_box("nan.e", [](Mesh& m) { m.coordinates[3] = std::nan(""); }), "is not finite");
}

TEST(ExodusTest, NodesThatNoCellHasAreLeftOutWithANote) {
  const auto lonely = [](Mesh& mesh) {
    mesh.coordinates.insert(mesh.coordinates.begin(), {7, 7});
    for (int& node : mesh.blocks[0].nodes) ++node;
    for (NodeSet& set : mesh.node_sets)
      for (int& node : set.nodes) ++node;
    mesh.node_sets[0].nodes.push_back(0);
  };
  EXPECT_EQ(changed_box("sound.e", [](Mesh&) {}), "");
  EXPECT_EQ(changed_box("lonely.e", lonely), "");
  const Mesh sound = read_exodus_mesh(path("sound.e")), mesh = read_exodus_mesh(path("lonely.e"));
  EXPECT_EQ(mesh.coordinates, sound.coordinates);
  EXPECT_EQ(mesh.blocks[0].nodes, sound.blocks[0].nodes);
  EXPECT_EQ(mesh.node_sets[0].nodes, sound.node_sets[0].nodes);
  EXPECT_EQ(mesh.notes, std::vector<std::string>{"1 node(s) of the mesh belong to no cell and are left out"});
  EXPECT_TRUE(sound.notes.empty());
}

/// A file made by the Exodus library alone: two quadrilaterals, with the given element type and ids.
void make_file(const std::string& name, int dimension, const char* type, int second_block_id, int second_node_id) {
  int word = 8, stored = 8;
  const int id = ex_create(path(name).c_str(), EX_CLOBBER, &word, &stored);
  double x[] = {0, 1, 2, 0, 1, 2}, y[] = {0, 0, 0, 1, 1, 1}, z[] = {0, 0, 0, 0, 0, 0};
  int first[] = {1, 2, 5, 4}, second[] = {2, 3, 6, 5}, nodes[] = {1, second_node_id, 3, 4, 5, 6};
  ex_put_init(id, "two", dimension, 6, 2, 2, 0, 0);
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, 10, type, 1, 4, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, second_block_id, type, 1, 4, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 10, first, nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, second_block_id, second, nullptr, nullptr);
  ex_put_id_map(id, EX_NODE_MAP, nodes);
  ex_close(id);
}

/// Two quadrilaterals as meshio writes them: three coordinates, blocks of a point and of two lines, no names and no
/// sets. The second cell is clockwise. The last node belongs to the point alone.
void make_meshio_file(const std::string& name, double height = 0, int block_of_side = 0) {
  int word = 8, stored = 8;
  const int id = ex_create(path(name).c_str(), EX_CLOBBER, &word, &stored);
  double x[] = {0, 1, 2, 0, 1, 2, 5}, y[] = {0, 0, 0, 1, 1, 1, 5}, z[] = {0, 0, height, 0, 0, 0, 0};
  int point[] = {7}, lines[] = {1, 2, 2, 3}, cells[] = {1, 2, 5, 4, 2, 5, 6, 3}, ends[] = {3, 6, 7};
  ex_put_init(id, "two", 3, 7, 5, 3, 1, block_of_side > 0 ? 1 : 0);
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, 1, "SPHERE", 1, 1, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 2, "BAR2", 2, 2, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 3, "QUAD4", 2, 4, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 1, point, nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 2, lines, nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 3, cells, nullptr, nullptr);
  ex_put_set_param(id, EX_NODE_SET, 1, 3, 0);
  ex_put_set(id, EX_NODE_SET, 1, ends, nullptr);
  if (block_of_side > 0) {
    int element[] = {block_of_side == 2 ? 2 : 5}, side[] = {3};  // of the last cell: nodes 6 and 3
    ex_put_set_param(id, EX_SIDE_SET, 1, 1, 0);
    ex_put_set(id, EX_SIDE_SET, 1, element, side);
  }
  ex_close(id);
}

TEST(ExodusTest, PlaneMeshesWithAThirdCoordinateAndLinesAreReadAsTwoDimensional) {
  make_meshio_file("meshio.e");
  const Mesh mesh = read_exodus_mesh(path("meshio.e"));
  EXPECT_EQ(mesh.dimension, 2);
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1}));
  ASSERT_EQ(mesh.blocks.size(), 1U);
  EXPECT_EQ(mesh.blocks[0].name, "block_3");
  EXPECT_EQ(mesh.blocks[0].nodes, (std::vector<int>{0, 1, 4, 3, 1, 2, 5, 4}));
  EXPECT_EQ(mesh.node_sets.at(0).nodes, (std::vector<int>{2, 5}));
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{
                            "the mesh's blocks of points, lines or faces are left out: \"block_1\", \"block_2\"",
                            "1 node(s) of the mesh belong to no cell and are left out"}));
  EXPECT_NO_THROW(check_cells(mesh));

  make_meshio_file("meshio.e", 0.5);
  expect_contains(refusal(path("meshio.e")),
                  "meshio.e: the surface elements do not lie in the plane z = 0: a node stands "
                  "at (2, 0, 0.5)");
  make_meshio_file("meshio.e", 0, 3);
  const Mesh with_side = read_exodus_mesh(path("meshio.e"));
  const Side side = with_side.side_sets.at(0).sides.at(0);
  EXPECT_EQ(sorted_corners(with_side, side), sorted_corners({2, 5}));
  make_meshio_file("meshio.e", 0, 2);
  expect_contains(refusal(path("meshio.e")),
                  "side set \"surface_1\" refers to element 2 of block \"block_2\", which is no cell of the mesh");
}

TEST(ExodusTest, FacesBesideHexahedraAreLeftOut) {
  int word = 8, stored = 8;
  const int id = ex_create(path("faces.e").c_str(), EX_CLOBBER, &word, &stored);
  double x[] = {0, 1, 1, 0, 0, 1, 1, 0}, y[] = {0, 0, 1, 1, 0, 0, 1, 1}, z[] = {0, 0, 0, 0, 1, 1, 1, 1};
  int face[] = {1, 2, 3, 4}, cell[] = {1, 2, 3, 4, 5, 6, 7, 8};
  ex_put_init(id, "one", 3, 8, 2, 2, 0, 0);
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, 1, "QUAD4", 1, 4, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 2, "HEX8", 1, 8, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 1, face, nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 2, cell, nullptr, nullptr);
  ex_close(id);
  const Mesh mesh = read_exodus_mesh(path("faces.e"));
  EXPECT_EQ(mesh.dimension, 3);
  EXPECT_EQ(mesh.cells(), 1);
  EXPECT_EQ(mesh.notes.size(), 1U);
}

TEST(ExodusTest, ForeignFilesAreReadOrRefusedByWhatTheyHold) {
  make_file("foreign.e", 2, "quad", 20, 2);
  const Mesh mesh = read_exodus_mesh(path("foreign.e"));
  EXPECT_EQ(mesh.blocks.at(1).name, "block_20");
  EXPECT_EQ(mesh.cells(), 2);
  make_file("lines.e", 2, "BAR", 20, 2);
  expect_contains(refusal(path("lines.e")),
                  "elements of type BAR with 4 nodes in 2 dimensions; triangles of 3, 6 and 7");
  make_file("tet.e", 3, "TETRA", 20, 2);
  EXPECT_NE(refusal(path("tet.e")), "") << "its corners lie in a plane";
  make_file("numbers.e", 2, "QUAD4", 20, 1);
  expect_contains(refusal(path("numbers.e")), "node number 1 is given twice");
}

}  // namespace
}  // namespace ixos

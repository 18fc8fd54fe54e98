#include <gtest/gtest.h>

#include <exodusII.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/reference_elements.hpp"
#include "fem/shape_table.hpp"
#include "io/exodus_mesh.hpp"
#include "io/output_mesh.hpp"
#include "mesh/enrich.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

std::string path(const std::string& name) { return testing::TempDir() + "ixos_" + name; }

std::string refusal(const std::string& file) {
  try {
    check_cells(read_exodus_mesh(file));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(ExodusTest, MeshesReadBackAsTheyWereWritten) {
  BoxShape flat, solid;
  flat.divisions = {3, 2, 1};
  solid.dimension = 3;
  solid.divisions = {2, 3, 1};
  for (Mesh mesh : {disk({}), box(flat), box(solid)}) {
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

TEST(ExodusTest, FilesThatAreNotMeshesAreRefused) {
  expect_contains(refusal(path("nowhere.e")), "the mesh file cannot be read");
  expect_contains(refusal(testing::TempDir()), "cannot be read");
  std::ofstream(path("text.e")) << "not a mesh";
  expect_contains(refusal(path("text.e")), "is not an Exodus file");
  std::ofstream(path("empty.e")) << "";
  expect_contains(refusal(path("empty.e")), "is not an Exodus file");
  std::ofstream(path("hdf.e")) << "\x89HDF\r\n\x1a\n and then nothing";
  expect_contains(refusal(path("hdf.e")), "is not an Exodus file");
}

TEST(ExodusTest, TruncatedFilesAreRefusedOrWhole) {
  write_exodus_mesh(disk({}), path("whole.e"), "disk");
  const auto size = std::filesystem::file_size(path("whole.e"));
  int refused = 0;
  for (std::uintmax_t cut = 0; cut < size; cut += 97) {
    std::filesystem::copy_file(path("whole.e"), path("cut.e"), std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path("cut.e"), cut);
    refused += refusal(path("cut.e")) == "accepted" ? 0 : 1;
  }
  // netCDF reads zeros where a file was cut in its padding: then nothing was lost, or the zeros are found out.
  EXPECT_GE(refused, static_cast<int>(size / 97));
}

TEST(ExodusTest, InconsistentMeshesAreRefused) {
  expect_contains(changed_box("inverted.e", [](Mesh& m) { std::swap(m.blocks[0].nodes[1], m.blocks[0].nodes[3]); }),
                  "block \"body\", cell 1: inverted or degenerate");
  expect_contains(changed_box("range.e", [](Mesh& m) { m.blocks[0].nodes[0] = 1000; }),
                  "block \"body\" refers to node 1001, but there are 9");
  expect_contains(changed_box("lonely.e",
                              [](Mesh& m) {
                                m.coordinates.push_back(7);
                                m.coordinates.push_back(7);
                              }),
                  "node 10 belongs to no element");
  expect_contains(changed_box("names.e", [](Mesh& m) { m.node_sets[1].name = m.node_sets[0].name; }), "is given twice");
  expect_contains(changed_box("sides.e", [](Mesh& m) { m.side_sets[0].sides[0].side = 5; }),
                  "refers to side 6 of element");
  expect_contains(changed_box("twice.e", [](Mesh& m) { m.side_sets[0].sides.push_back(m.side_sets[0].sides[0]); }),
                  "twice");
  expect_contains(changed_box("nan.e", [](Mesh& m) { m.coordinates[3] = std::nan(""); }), "is not finite");
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

TEST(ExodusTest, ForeignFilesAreReadOrRefusedByWhatTheyHold) {
  make_file("foreign.e", 2, "quad", 20, 2);
  const Mesh mesh = read_exodus_mesh(path("foreign.e"));
  EXPECT_EQ(mesh.blocks.at(1).name, "block_20");
  EXPECT_EQ(mesh.cells(), 2);
  make_file("shell.e", 3, "QUAD4", 20, 2);
  expect_contains(refusal(path("shell.e")), "has elements of type QUAD4 with 4 nodes in 3 dimensions");
  make_file("tet.e", 3, "TETRA", 20, 2);
  expect_contains(refusal(path("tet.e")), "TETRA");
  make_file("numbers.e", 2, "QUAD4", 20, 1);
  expect_contains(refusal(path("numbers.e")), "node number 1 is given twice");
}

// An enriched cell is shown as a row of bilinear ones along its curved side.
TEST(OutputMeshTest, EnrichedCellsBecomeRowsThatFillTheSameArea) {
  for (const auto& [element, parts] : {std::pair{ContactElement::Q1C2, 2}, std::pair{ContactElement::Q1C3, 3},
                                       std::pair{ContactElement::Q1C4, 4}, std::pair{ContactElement::Q1CH, 4}}) {
    BoxShape shape;
    shape.lengths = {3, 2, 0};
    shape.divisions = {3, 2, 1};
    Mesh mesh = box(shape);
    enrich(mesh, "bottom", element);
    const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
    const OutputMesh output(local, 1);
    EXPECT_EQ(output.mesh.cells(), 3 + 3 * parts);
    double area = 0;
    for (const ElementBlock& block : output.mesh.blocks)
      for (int cell = 0; cell < block.cells(); ++cell)
        for (int a = 0; a < 4; ++a) {
          const auto n = 2 * static_cast<std::size_t>(block.nodes[cell_entry(cell, 4, a)]);
          const auto m = 2 * static_cast<std::size_t>(block.nodes[cell_entry(cell, 4, (a + 1) % 4)]);
          const std::vector<double>& x = output.mesh.coordinates;
          area += (x[n] * x[m + 1] - x[m] * x[n + 1]) / 2;
        }
    EXPECT_NEAR(area, 6, 1e-13);
    const std::set<int> ids(output.description.node_ids.begin(), output.description.node_ids.end());
    EXPECT_EQ(ids.size(), output.description.node_ids.size());
    const std::set<int> cells(output.description.cell_ids.begin(), output.description.cell_ids.end());
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(output.mesh.cells()));
    // Side sets keep their length in pieces.
    const auto sides = [&](const char* name) {
      for (const SideSet& set : output.mesh.side_sets)
        if (set.name == name) return set.sides.size();
      return std::size_t{0};
    };
    EXPECT_EQ(sides("bottom"), 3U * static_cast<std::size_t>(parts));
    EXPECT_EQ(sides("left"), 2U);
    EXPECT_EQ(sides("top"), 3U);
  }
}

/// Volume of a hexahedron with planar faces, by its corners.
double volume_of(const Mesh& mesh, const ElementBlock& block, int cell) {
  const ShapeTable<Hex8> table;
  double volume = 0;
  for (std::size_t q = 0; q < table.size(); ++q)
    volume += table.weight[q] * determinant(jacobian<3>(mesh.coordinates, &block.nodes[cell_entry(cell, 8)],
                                                        cell_scales<Hex8>(block, cell), table.gradient[q]));
  return volume;
}

// Hexahedra are cut in both directions of their contact face; tied edges make several blocks.
TEST(OutputMeshTest, EnrichedHexahedraBecomeRowsThatFillTheSameVolume) {
  for (const auto& [element, n] :
       {std::pair{ContactElement::Q1C2, 2}, std::pair{ContactElement::Q1C3, 3}, std::pair{ContactElement::Q1C4, 4}})
    for (const char* side : {"bottom", "right"}) {
      BoxShape shape;
      shape.dimension = 3;
      shape.lengths = {3, 2, 2};
      shape.divisions = {3, 2, 2};
      Mesh mesh = box(shape);
      // Of the bottom the first two columns, of the right side the lower half.
      const bool bottom = std::string(side) == "bottom";
      add_side_set(mesh, "patch", side, {{}, bottom ? std::vector{2.0, 2.0, 2.0} : std::vector{3.0, 2.0, 1.0}});
      const int cells = bottom ? 4 : 2;
      enrich(mesh, "patch", element);
      const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
      const OutputMesh output(local, 1);
      EXPECT_EQ(output.mesh.cells(), 12 + cells * (n * n - 1));
      double volume = 0;
      std::set<std::string> names;
      for (const ElementBlock& block : output.mesh.blocks) {
        EXPECT_TRUE(names.insert(block.name).second) << block.name;
        EXPECT_EQ(block.type, CellType::Hex8);
        for (int cell = 0; cell < block.cells(); ++cell) {
          EXPECT_GT(volume_of(output.mesh, block, cell), 0);
          volume += volume_of(output.mesh, block, cell);
        }
      }
      EXPECT_NEAR(volume, 12, 1e-13);
      const std::set<int> ids(output.description.node_ids.begin(), output.description.node_ids.end());
      EXPECT_EQ(ids.size(), output.description.node_ids.size());
      EXPECT_LE(*ids.rbegin(), output.description.global_nodes);
      // An affine field stays one, and each side set is the sum of its pieces.
      std::vector<double> field;
      for (std::size_t k = 0; k < local.coordinates.size(); k += 3)
        field.push_back(local.coordinates[k] - 2 * local.coordinates[k + 1] + 3 * local.coordinates[k + 2]);
      const std::vector<double> shown = output.nodal(field);
      const std::vector<double>& x = output.mesh.coordinates;
      for (std::size_t k = 0; k < shown.size(); ++k)
        EXPECT_NEAR(shown[k], x[3 * k] - 2 * x[3 * k + 1] + 3 * x[3 * k + 2], 1e-13);
      const std::map<std::string, std::pair<std::size_t, double>> planes{{"left", {0, 0}},   {"right", {0, 3}},
                                                                         {"front", {1, 0}},  {"back", {1, 2}},
                                                                         {"bottom", {2, 0}}, {"top", {2, 2}}};
      for (const SideSet& set : output.mesh.side_sets) {
        if (set.name == "patch") {
          EXPECT_EQ(set.sides.size(), static_cast<std::size_t>(cells * n * n));
        }
        if (planes.count(set.name) == 0) continue;
        const auto [d, place] = planes.at(set.name);
        std::size_t on_plane = 0;
        for (const ElementBlock& block : output.mesh.blocks)
          for (int cell = 0; cell < block.cells(); ++cell)
            for (int s = 0; s < 6; ++s) {
              const std::vector<int>& corner = side_nodes(CellType::Hex8, s);
              on_plane += std::all_of(corner.begin(), corner.end(),
                                      [&](int a) {
                                        const auto node = static_cast<std::size_t>(block.nodes[cell_entry(cell, 8, a)]);
                                        return std::abs(x[3 * node + d] - place) < 1e-12;
                                      })
                              ? 1U
                              : 0U;
            }
        EXPECT_EQ(set.sides.size(), on_plane) << set.name;
        for (const Side& one : set.sides)
          for (int a : side_nodes(CellType::Hex8, one.side)) {
            const ElementBlock& block = output.mesh.blocks[static_cast<std::size_t>(one.block)];
            const auto node = static_cast<std::size_t>(block.nodes[cell_entry(one.cell, 8, a)]);
            EXPECT_NEAR(x[3 * node + d], place, 1e-12) << set.name;
          }
      }
    }
}

TEST(OutputMeshTest, TheCurvedSideIsTheElementsOwn) {
  // One cell of length 2, its bottom displaced by (x - 1)^2 - 1: a parabola, which every contact element holds.
  for (ContactElement element :
       {ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH}) {
    BoxShape shape;
    shape.lengths = {2, 1, 0};
    Mesh mesh = box(shape);
    enrich(mesh, "bottom", element);
    const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
    const OutputMesh output(local, 1);
    std::vector<double> field(static_cast<std::size_t>(local.nodes()), 0.0);
    for (std::size_t n = 0; n < field.size(); ++n) {
      const double x = local.coordinates[2 * n], y = local.coordinates[2 * n + 1];
      if (y == 0) field[n] = (x - 1) * (x - 1) - 1;
    }
    if (element == ContactElement::Q1CH)  // d/dxi at the ends, x = 1 + xi
      for (std::size_t k : {0U, 1U}) field[static_cast<std::size_t>(local.blocks[0].nodes[4 + k])] = k == 0 ? -2 : 2;
    const std::vector<double> shown = output.nodal(field);
    for (std::size_t n = 0; n < shown.size(); ++n) {
      const double x = output.mesh.coordinates[2 * n], y = output.mesh.coordinates[2 * n + 1];
      EXPECT_NEAR(shown[n], y == 0 ? (x - 1) * (x - 1) - 1 : 0.0, 1e-14);
    }
  }
}

}  // namespace
}  // namespace ixos

// Meshes for gmsh, read back by Ixos and by gmsh itself.
#include "io/gmsh_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/child_process.hpp"
#include "io/gmsh_mesh.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"
#include "support/simplices.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

Mesh block(int dimension, const std::string& kind, int order, bool bubbles = false) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = {-1.0 / 3, 0.1, 0};
  shape.divisions = {4, 2, 2};
  Mesh mesh = box(shape);
  if (!kind.empty()) mesh = test::split_cells(mesh, kind);
  if (order == 2) raise_order(mesh, bubbles);
  return mesh;
}

/// Sorted by block and cell.
std::vector<std::vector<std::array<int, 2>>> sorted_sides(const Mesh& mesh) {
  std::vector<std::vector<std::array<int, 2>>> all;
  for (const SideSet& set : mesh.side_sets) {
    all.emplace_back();
    int first = 0;
    std::vector<int> begin;
    for (const ElementBlock& own : mesh.blocks) {
      begin.push_back(first);
      first += own.cells();
    }
    for (const Side& side : set.sides)
      all.back().push_back({begin[static_cast<std::size_t>(side.block)] + side.cell, side.side});
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

class GmshWriterTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
};

/// Nodes, cells, sides and sets come back, to the last digit.
TEST_F(GmshWriterTest, WhatIsWrittenComesBack) {
  const std::vector<std::pair<int, std::string>> kinds{{2, ""},
                                                       {2, "triangles"},
                                                       {2, "quads and triangles"},
                                                       {3, ""},
                                                       {3, "tetrahedra"},
                                                       {3, "hexahedra to tetrahedra"},
                                                       {3, "hexahedra and prisms"}};
  for (const auto& [dimension, kind] : kinds)
    for (const int order : {1, 2}) {
      SCOPED_TRACE(kind + ", order " + std::to_string(order));
      Mesh mesh = block(dimension, kind, order);
      mesh.node_sets.push_back({"two nodes", {3, 5}});
      mesh.node_sets.front().nodes.resize(2);  // no longer those of the side set of its name
      const std::string changed = mesh.node_sets.front().name;
      write_gmsh_mesh(mesh, path("box.msh"));
      const Mesh read = read_gmsh_mesh(path("box.msh"));
      EXPECT_EQ(read.dimension, dimension);
      EXPECT_EQ(read.coordinates, mesh.coordinates);
      ASSERT_EQ(read.blocks.size(), mesh.blocks.size());
      for (const ElementBlock& own : mesh.blocks) {
        const auto found = std::find_if(read.blocks.begin(), read.blocks.end(),
                                        [&own](const ElementBlock& b) { return b.type == own.type; });
        ASSERT_NE(found, read.blocks.end());
        EXPECT_EQ(found->nodes, own.nodes);
        EXPECT_EQ(found->name, own.name);
      }
      ASSERT_EQ(read.side_sets.size(), mesh.side_sets.size());
      for (std::size_t s = 0; s < read.side_sets.size(); ++s) EXPECT_EQ(read.side_sets[s].name, mesh.side_sets[s].name);
      if (mesh.blocks.size() == 1) {
        EXPECT_EQ(sorted_sides(read), sorted_sides(mesh));
      }
      const auto nodes_of = [](const Mesh& own, const std::string& name) {
        const auto found = std::find_if(own.node_sets.begin(), own.node_sets.end(),
                                        [&name](const NodeSet& set) { return set.name == name; });
        std::vector<int> nodes = found == own.node_sets.end() ? std::vector<int>{-1} : found->nodes;
        std::sort(nodes.begin(), nodes.end());
        return nodes;
      };
      for (const NodeSet& set : mesh.node_sets)
        EXPECT_EQ(nodes_of(read, set.name == changed ? changed + "_nodes" : set.name), nodes_of(mesh, set.name));
    }
}

/// gmsh reads the file and writes it in its other format.
TEST_F(GmshWriterTest, GmshReadsIt) {
  for (const char* kind : {"", "tetrahedra", "hexahedra and prisms"}) {
    const Mesh mesh = block(3, kind, 2);
    write_gmsh_mesh(mesh, path("box.msh"));
    const ChildOutcome end =
        ChildProcess({"/usr/bin/env", "gmsh", "-0", path("box.msh"), "-format", "msh22", "-o", path("again.msh")},
                     path("log"))
            .wait();
    ASSERT_EQ(end.exit_status, 0);
    const Mesh again = read_gmsh_mesh(path("again.msh"));
    EXPECT_EQ(again.nodes(), mesh.nodes());
    EXPECT_EQ(again.cells(), mesh.cells());
    ASSERT_EQ(again.side_sets.size(), mesh.side_sets.size());
    for (std::size_t s = 0; s < mesh.side_sets.size(); ++s)
      EXPECT_EQ(again.side_sets[s].sides.size(), mesh.side_sets[s].sides.size());
  }
}

TEST_F(GmshWriterTest, BubblesAreLeftOut) {
  const Mesh mesh = block(3, "tetrahedra", 2, true), plain = block(3, "tetrahedra", 2);
  write_gmsh_mesh(mesh, path("box.msh"));
  const Mesh read = read_gmsh_mesh(path("box.msh"));
  EXPECT_EQ(read.blocks.front().type, CellType::Tet10);
  EXPECT_EQ(read.nodes(), plain.nodes());
}

TEST_F(GmshWriterTest, RefusesWhatTheFormatCannotHold) {
  Mesh mesh = block(2, "", 1);
  mesh.side_sets.front().name = "a \"side\"";
  test::expect_contains(test::refusal([&] { write_gmsh_mesh(mesh, path("box.msh")); }), "a \"side\" has a quote");
  Mesh enriched = block(2, "", 1);
  enrich(enriched, "bottom", ContactElement::Q1C2);
  test::expect_contains(test::refusal([&] { write_gmsh_mesh(enriched, path("box.msh")); }), "enriched cells");
  EXPECT_FALSE(std::filesystem::exists(path("box.msh")));
}

}  // namespace
}  // namespace ixos

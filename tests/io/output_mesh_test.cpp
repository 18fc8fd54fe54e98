// What results show of enriched meshes: plain cells that fill the same space.
#include "io/output_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"
#include "fem/shape_table.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

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
    // No two sets have one name: readers on IOSS want that.
    std::set<std::string> sets;
    for (const SideSet& set : output.mesh.side_sets) sets.insert(set.name);
    for (const NodeSet& set : output.mesh.node_sets) sets.insert(set.name);
    EXPECT_EQ(sets.size(), output.mesh.side_sets.size() + output.mesh.node_sets.size());
    EXPECT_EQ(sets.count("bottom_nodes"), 1U);
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
  for (const auto& [element, n] : {std::pair{ContactElement::Q1C2, 2}, std::pair{ContactElement::Q1C3, 3},
                                   std::pair{ContactElement::Q1C4, 4}, std::pair{ContactElement::Q1CH, 4}})
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
      std::size_t patches = 0, faces = 0;
      for (const SideSet& set : output.mesh.side_sets) {
        if (set.name == "patch") {
          ++patches;
          EXPECT_EQ(set.sides.size(), static_cast<std::size_t>(cells * n * n));
        }
        if (planes.count(set.name) == 0) continue;
        ++faces;
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
      EXPECT_EQ(patches, 1U);
      EXPECT_EQ(faces, planes.size());
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

/// The integral of a field over quadratic cells, by the program's own elements.
template <class Element>
double integral(const Mesh& mesh, const std::vector<double>& field) {
  const ShapeTable<Element> table;
  double sum = 0;
  for (const ElementBlock& block : mesh.blocks)
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* nodes = &block.nodes[cell_entry(cell, Element::nodes)];
      for (std::size_t q = 0; q < table.size(); ++q) {
        double value = 0;
        for (std::size_t a = 0; a < Element::nodes; ++a)
          value += table.value[q][a] * field[static_cast<std::size_t>(nodes[a])];
        sum += value * table.weight[q] *
               determinant(jacobian<Element::dimension>(mesh.coordinates, nodes, cell_scales<Element>(block, cell),
                                                        table.gradient[q]));
      }
    }
  return sum;
}

// Enriched quadratic cells are cut into quadratic ones, which fill the same space and show squares exactly.
TEST(OutputMeshTest, EnrichedQuadraticCellsBecomeQuadraticOnes) {
  for (const int dimension : {2, 3}) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.lengths = {3, 2, 2};
    shape.divisions = {3, 2, 2};
    Mesh mesh = box(shape);
    raise_order(mesh);
    add_side_set(mesh, "patch", "bottom",
                 {{}, dimension == 2 ? std::vector<double>{2, 2} : std::vector<double>{2, 2, 2}});
    enrich(mesh, "patch", ContactElement::Q2C4);
    const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
    const OutputMesh output(local, 1);
    const int rich = dimension == 2 ? 2 : 4, parts = dimension == 2 ? 2 : 4;
    EXPECT_EQ(output.mesh.cells(), (dimension == 2 ? 6 : 12) + rich * (parts - 1));
    for (const ElementBlock& block : output.mesh.blocks)
      EXPECT_EQ(block.type, dimension == 2 ? CellType::Quad9 : CellType::Hex27);
    std::vector<double> field;
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t k = 0; k < local.coordinates.size(); k += d)
      field.push_back(local.coordinates[k] * local.coordinates[k] -
                      2 * local.coordinates[k] * local.coordinates[k + 1]);
    const std::vector<double> shown = output.nodal(field);
    for (std::size_t n = 0; n < shown.size(); ++n) {
      const double x = output.mesh.coordinates[d * n], y = output.mesh.coordinates[d * n + 1];
      EXPECT_NEAR(shown[n], x * x - 2 * x * y, 1e-13);
    }
    const double expected = (9 * 2 - 2 * 9.0 / 2 * 4.0 / 2) * (dimension == 3 ? 2 : 1);
    EXPECT_NEAR(dimension == 2 ? integral<Quad9>(output.mesh, shown) : integral<Hex27>(output.mesh, shown), expected,
                1e-12);
    const std::set<int> ids(output.description.node_ids.begin(), output.description.node_ids.end());
    EXPECT_EQ(ids.size(), output.description.node_ids.size());
    EXPECT_LE(*ids.rbegin(), output.description.global_nodes);
    for (const SideSet& set : output.mesh.side_sets)
      if (set.name == "patch") {
        EXPECT_EQ(set.sides.size(), static_cast<std::size_t>(rich * parts));
        for (const Side& side : set.sides) {
          const ElementBlock& block = output.mesh.blocks[static_cast<std::size_t>(side.block)];
          for (int a : side_nodes(block.type, side.side))
            EXPECT_EQ(
                output.mesh.coordinates[d * static_cast<std::size_t>(
                                                block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), a)]) +
                                        d - 1],
                0);
        }
      }
  }
}

}  // namespace
}  // namespace ixos

#include "mesh/enrichment/conformity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fem/with_element.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/bricks.hpp"
#include "mesh/quality.hpp"

namespace ixos::test {
namespace {

/// The element of each side must be the trace of its cell.
void expect_traces(const Mesh& mesh, const std::string& what) {
  const std::vector<double> field = random_field(mesh);
  for (const ElementBlock& block : mesh.blocks)
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int side = 0; side < 6; ++side)
        with_side_element(block.type, side, [&](auto tag) {
          using Element = typename decltype(tag)::type;
          const std::vector<int>& local = side_nodes(block.type, side);
          ASSERT_EQ(local.size(), static_cast<std::size_t>(Element::nodes));
          if constexpr (Element::dimension == 2)
            for (const std::array<double, 2>& x :
                 {std::array{-0.7, 0.2}, std::array{0.4, -1.0}, std::array{0.9, 0.6}}) {
              std::array<double, Element::nodes> value;
              std::array<std::array<double, 2>, Element::nodes> gradient;
              evaluate_tied<Element>(side_ties(block, side), x, value, gradient);
              double sum = 0;
              for (std::size_t a = 0; a < value.size(); ++a)
                sum += side_node_scale(block, cell, side, a) * value[a] *
                       field[static_cast<std::size_t>(cell_nodes(block, cell)[local[a]])];
              std::array<double, 4> share;
              std::array<std::array<double, 2>, 4> unused;
              Quad4::evaluate(x, share, unused);
              Place xi{};
              for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t d = 0; d < 3; ++d)
                  xi[d] += share[k] * corners<3>()[static_cast<std::size_t>(local[k])][d];
              EXPECT_NEAR(sum, value_in(block, cell, xi, field), 1e-13) << what << ", side " << side;
            }
        });
}

}  // namespace

std::vector<double> random_field(const Mesh& mesh) {
  std::vector<double> field;
  for (int node = 0; node < mesh.nodes(); ++node) field.push_back(std::sin(12.9898 * node + 1));
  return field;
}

Place between(const ElementBlock& block, int cell, const std::map<int, double>& weights) {
  Place xi{};
  const int* nodes = cell_nodes(block, cell);
  for (std::size_t a = 0; a < 8; ++a) {
    const auto found = weights.find(nodes[a]);
    if (found == weights.end()) continue;
    for (std::size_t d = 0; d < 3; ++d) xi[d] += found->second * corners<3>()[a][d];
  }
  return xi;
}

Cells faces_and_edges(const Mesh& mesh) {
  Cells cells;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (int cell = 0; cell < mesh.blocks[b].cells(); ++cell) {
      std::set<std::vector<int>> parts;
      for (int side = 0; side < 6; ++side) {
        const std::vector<int>& local = side_nodes(mesh.blocks[b].type, side);
        const int* nodes = cell_nodes(mesh.blocks[b], cell);
        std::vector<int> corner;
        for (std::size_t k = 0; k < 4; ++k) corner.push_back(nodes[local[k]]);
        for (std::size_t k = 0; k < 4; ++k) {
          std::vector<int> edge{corner[k], corner[(k + 1) % 4]};
          std::sort(edge.begin(), edge.end());
          parts.insert(edge);
        }
        parts.insert(corner);
      }
      for (std::vector<int> part : parts) {
        std::sort(part.begin(), part.end());
        cells[part].emplace_back(b, cell);
      }
    }
  return cells;
}

const int* cell_nodes(const ElementBlock& block, int cell) {
  return &block.nodes[cell_entry(cell, nodes_per_cell(block.type))];
}

double value_in(const ElementBlock& block, int cell, const Place& xi, const std::vector<double>& field) {
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    double sum = 0;
    if constexpr (Element::dimension == 3) {
      std::array<double, Element::nodes> value;
      std::array<Place, Element::nodes> gradient;
      evaluate_tied<Element>(block.tied, xi, value, gradient);
      for (std::size_t a = 0; a < value.size(); ++a)
        sum += node_scale(block, cell, static_cast<int>(a)) * value[a] *
               field[static_cast<std::size_t>(cell_nodes(block, cell)[a])];
    }
    return sum;
  });
}

void expect_plain_map(const Mesh& mesh, const ElementBlock& block) {
  for (std::size_t d = 0; d < 3; ++d) {
    std::vector<double> x;
    for (int node = 0; node < mesh.nodes(); ++node) x.push_back(mesh.coordinates[at_node(node, d)]);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (const Place& xi : {Place{-0.3, 0.4, -1}, {0.8, -0.9, -0.5}, {0.1, 0.2, 0.7}}) {
        std::array<double, 8> value;
        std::array<Place, 8> gradient;
        Hex8::evaluate(xi, value, gradient);
        double plain = 0;
        for (std::size_t a = 0; a < 8; ++a) plain += value[a] * x[static_cast<std::size_t>(cell_nodes(block, cell)[a])];
        EXPECT_NEAR(value_in(block, cell, xi, x), plain, 1e-14);
      }
  }
}

void expect_conforming(const Mesh& mesh, const std::string& what) {
  const std::vector<double> field = random_field(mesh);
  int compared = 0;
  for (const auto& [part, cells] : faces_and_edges(mesh)) {
    if (cells.size() < 2) continue;
    const auto& [first_block, first_cell] = cells.front();
    const ElementBlock& first = mesh.blocks[first_block];
    // Corners in the order around the face, as its first cell has them.
    std::vector<int> around;
    for (int side = 0; side < 6 && around.empty() && part.size() == 4; ++side) {
      for (std::size_t k = 0; k < 4; ++k)
        around.push_back(cell_nodes(first, first_cell)[side_nodes(first.type, side)[k]]);
      std::vector<int> sorted = around;
      std::sort(sorted.begin(), sorted.end());
      if (sorted != part) around.clear();
    }
    if (part.size() == 2) around = part;
    for (double s : {0.13, 0.5, 0.81})
      for (double t : {0.22, 0.7}) {
        std::map<int, double> weights;
        if (part.size() == 2)
          weights = {{around[0], 1 - s}, {around[1], s}};
        else
          weights = {
              {around[0], (1 - s) * (1 - t)}, {around[1], s * (1 - t)}, {around[2], s * t}, {around[3], (1 - s) * t}};
        const double expected = value_in(first, first_cell, between(first, first_cell, weights), field);
        for (const auto& [b, cell] : cells)
          EXPECT_NEAR(value_in(mesh.blocks[b], cell, between(mesh.blocks[b], cell, weights), field), expected, 1e-13)
              << what;
        ++compared;
      }
  }
  EXPECT_GT(compared, 0);
}

void expect_sound(Mesh& mesh, const std::string& what) {
  EXPECT_NO_THROW(check_cells(mesh)) << what;
  expect_conforming(mesh, what);
  expect_traces(mesh, what);
  // Every new node belongs to a cell, and none is there twice.
  std::vector<char> used(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const ElementBlock& block : mesh.blocks)
    for (int node : block.nodes) used[static_cast<std::size_t>(node)] = 1;
  EXPECT_EQ(std::count(used.begin() + mesh.plain_nodes, used.end(), 0), 0) << what;
  std::set<Place> places;
  int points = 0;
  for (int node = 0; node < mesh.nodes(); ++node) {
    if (mesh.is_derivative(node)) continue;
    ++points;
    places.insert(
        {mesh.coordinates[at_node(node, 0)], mesh.coordinates[at_node(node, 1)], mesh.coordinates[at_node(node, 2)]});
  }
  EXPECT_EQ(places.size(), static_cast<std::size_t>(points)) << what;
}

void expect_patches_conform(ContactElement element) {
  const std::vector<std::vector<std::size_t>> shapes = {
      {0, 5, 10, 15},                          // faces that meet at corners only
      {0, 1, 2, 3, 4, 8, 12},                  // an L
      {0, 1, 2, 4, 6, 8, 9, 10},               // a ring
      {0, 1, 2, 4, 5, 6, 8, 9, 10, 11},        // three faces at a node of the rim
      {5},                                     // all edges tied
      {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},  // a strip
  };
  for (const auto& shape : shapes)
    for (const char* from : {"bottom", "left", "back"}) {
      Mesh mesh = brick({4, 4, 4});
      if (element == ContactElement::Q2C4) raise_order(mesh);
      choose(mesh, "patch", from, shape);
      enrich(mesh, "patch", element);
      expect_sound(mesh, from);
    }
}

void expect_sets_conform(ContactElement element) {
  Mesh mesh = brick({4, 2, 2});
  choose(mesh, "one", "bottom", {0, 1, 4, 5});
  choose(mesh, "other", "bottom", {2, 6});
  enrich(mesh, "one", element);
  enrich(mesh, "other", ContactElement::Q1C4);
  enrich(mesh, "top", ContactElement::Q1C3);
  expect_sound(mesh, "three sets");
}

}  // namespace ixos::test

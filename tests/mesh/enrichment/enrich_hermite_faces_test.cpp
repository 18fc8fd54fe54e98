// Bicubic Hermite contact faces: shared derivatives, smoothness, ties.
#include "mesh/enrichment/enrich.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/with_element.hpp"
#include "mesh/enrichment/bricks.hpp"
#include "mesh/enrichment/conformity.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"

namespace ixos {
namespace {

using test::at_node;
using test::between;
using test::brick;
using test::cell_nodes;
using test::choose;
using test::expect_patches_conform;
using test::expect_plain_map;
using test::expect_sets_conform;
using test::expect_sound;
using test::faces_and_edges;
using test::Place;
using test::random_field;
using test::value_in;

/// A flat bottom of 4 by 3 faces of unequal width, and of unequal shape where distorted.
Mesh uneven(bool distorted) {
  Mesh mesh = distorted ? brick({4, 3, 2}) : box({3, {}, {4, 3, 2}, {4, 3, 2}});
  const double x[] = {0, 0.5, 1.9, 2.3, 4}, y[] = {0, 1.6, 1.9, 3};
  for (std::size_t n = 0; n < 20; ++n) {
    mesh.coordinates[3 * n] += x[n % 5] - static_cast<double>(n % 5);
    mesh.coordinates[3 * n + 1] += y[n / 5] - static_cast<double>(n / 5);
    mesh.coordinates[3 * n + 2] = 0;
  }
  return mesh;
}

/// The gradient in X and Y of a field on a flat contact face.
std::array<double, 2> face_gradient(const Mesh& mesh, const ElementBlock& block, int cell, const Place& xi,
                                    const std::vector<double>& field) {
  std::array<double, Hex8CH::nodes> value;
  std::array<Place, Hex8CH::nodes> gradient;
  evaluate_tied<Hex8CH>(block.tied, xi, value, gradient);
  const auto scale = cell_scales<Hex8CH>(block, cell);
  const int* nodes = cell_nodes(block, cell);
  const auto x = jacobian<3>(mesh.coordinates, nodes, scale, gradient);
  const Small<double, 2> plane{{{x[0][0], x[0][1]}, {x[1][0], x[1][1]}}};
  const auto back = inverse(plane, determinant(plane));
  std::array<double, 2> result{};
  for (std::size_t a = 0; a < scale.size(); ++a)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        result[i] += scale[a] * field[static_cast<std::size_t>(nodes[a])] * gradient[a][d] * back[d][i];
  return result;
}

/// The largest jump of a random field's gradient between contact faces, and the largest gradient. Faces with a tied
/// edge are left out.
std::array<double, 2> largest_jump(const Mesh& mesh) {
  const std::vector<double> field = random_field(mesh);
  double jump = 0, largest = 0;
  for (const auto& [part, cells] : faces_and_edges(mesh)) {
    if (part.size() != 2) continue;
    for (double s : {0.0, 0.13, 0.5, 0.81, 1.0}) {
      std::vector<std::array<double, 2>> gradients;
      for (const auto& [b, cell] : cells) {
        const ElementBlock& block = mesh.blocks[b];
        if (block.type != CellType::Hex8CH || block.tied != 0) continue;
        const Place xi = between(block, cell, {{part[0], 1 - s}, {part[1], s}});
        if (xi[2] == -1) gradients.push_back(face_gradient(mesh, block, cell, xi, field));
      }
      if (gradients.size() < 2) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        jump = std::max(jump, std::abs(gradients[0][i] - gradients[1][i]));
        largest = std::max(largest, std::abs(gradients[0][i]));
      }
    }
  }
  return {jump, largest};
}

/// By places, so that the answer does not depend on where a cell starts: rotates the corners of all cells by
/// themselves.
void turn_cells(Mesh& mesh) {
  ElementBlock& block = mesh.blocks[0];
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  SideSet bottom{"bottom", {}};
  for (int cell = 0; cell < block.cells(); ++cell) {
    int* nodes = &block.nodes[cell_entry(cell, 8)];
    for (int layer : {0, 4}) std::rotate(nodes + layer, nodes + layer + cell % 4, nodes + layer + 4);
    bool flat = true;
    for (int a = 0; a < 4; ++a) flat = flat && mesh.coordinates[at_node(nodes[a], 2)] == 0;
    if (flat) bottom.sides.push_back({0, cell, 4});
  }
  mesh.side_sets.push_back(bottom);
}

TEST(EnrichHermiteFacesTest, NeighboursShareThreeDerivativesANode) {
  for (const char* name : {"bottom", "top", "left", "right", "front", "back"}) {
    Mesh mesh = brick({3, 2, 4});
    const int before = mesh.nodes();
    enrich(mesh, name, ContactElement::Q1CH);
    const std::string set = name;
    const int a = set == "left" || set == "right" ? 2 : 3, b = set == "bottom" || set == "top" ? 2 : 4;
    EXPECT_EQ(mesh.nodes() - before, 3 * (a + 1) * (b + 1)) << name;
    ASSERT_EQ(mesh.blocks.size(), 2U);
    EXPECT_EQ(mesh.blocks[1].type, CellType::Hex8CH);
    EXPECT_EQ(mesh.blocks[1].cells(), a * b);
    for (int node = before; node < mesh.nodes(); ++node) EXPECT_TRUE(mesh.is_derivative(node));
    expect_sound(mesh, name);
  }
}

TEST(EnrichHermiteFacesTest, OnARectangularGridTheMapIsThatOfThePlainHexahedron) {
  Mesh mesh = uneven(false);
  turn_cells(mesh);
  enrich(mesh, "bottom", ContactElement::Q1CH);
  expect_sound(mesh, "uneven");
  expect_plain_map(mesh, mesh.blocks[1]);
}

TEST(EnrichHermiteFacesTest, GradientsAreContinuousAcrossFacesOfAnySizeAndShape) {
  for (bool distorted : {false, true})
    for (bool turned : {false, true}) {
      Mesh mesh = uneven(distorted);
      if (turned) turn_cells(mesh);
      enrich(mesh, "bottom", ContactElement::Q1CH);
      EXPECT_NO_THROW(check_cells(mesh));
      const auto [jump, largest] = largest_jump(mesh);
      EXPECT_GT(largest, 1);
      EXPECT_LT(jump, 1e-12 * largest) << distorted << turned;
    }
  // Inside a tied rim too.
  Mesh mesh = brick({6, 5, 1});
  for (std::size_t n = 0; n < 42; ++n) mesh.coordinates[3 * n + 2] = 0;
  std::vector<std::size_t> inside;
  for (std::size_t j = 0; j < 5; ++j)
    for (std::size_t i = 1; i < 6; ++i) inside.push_back(6 * j + i);
  choose(mesh, "patch", "bottom", inside);
  enrich(mesh, "patch", ContactElement::Q1CH);
  expect_sound(mesh, "patch");
  const auto [jump, largest] = largest_jump(mesh);
  EXPECT_GT(largest, 1);
  EXPECT_LT(jump, 1e-12 * largest);
}

TEST(EnrichHermiteFacesTest, CubicsInXAndYAreHeldByTheWholePatch) {
  // On a rectangular grid all faces together hold x^k y^l, given their nodal values and derivatives.
  Mesh mesh = uneven(false);
  turn_cells(mesh);
  enrich(mesh, "bottom", ContactElement::Q1CH);
  const ElementBlock& block = mesh.blocks[1];
  const auto power = [](double x, int k) { return k < 0 ? 0.0 : std::pow(x, k); };
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l) {
      std::vector<double> field(static_cast<std::size_t>(mesh.nodes()), 0.0);
      for (int node = 0; node < mesh.nodes(); ++node) {
        const double* x = &mesh.coordinates[at_node(node, 0)];
        double& value = field[static_cast<std::size_t>(node)];
        if (!mesh.is_derivative(node)) {
          value = power(x[0], k) * power(x[1], l);
          continue;
        }
        const double* at = &mesh.coordinates[at_node(mesh.derivative_of[static_cast<std::size_t>(node)], 0)];
        const double slope[2] = {k * power(at[0], k - 1) * power(at[1], l), l * power(at[0], k) * power(at[1], l - 1)};
        value = slope[0] * x[0] + slope[1] * x[1];
        if (x[0] == 0 && x[1] == 0) value = std::nan("");  // mixed: below
      }
      // The mixed derivative has no direction of its own: its lengths are those of the node's other two.
      for (int cell = 0; cell < block.cells(); ++cell)
        for (int c = 0; c < 4; ++c) {
          const int* nodes = cell_nodes(block, cell);
          const double* first = &mesh.coordinates[at_node(nodes[8 + 3 * c], 0)];
          const double* second = &mesh.coordinates[at_node(nodes[9 + 3 * c], 0)];
          const double* at =
              &mesh.coordinates[at_node(mesh.derivative_of[static_cast<std::size_t>(nodes[8 + 3 * c])], 0)];
          field[static_cast<std::size_t>(nodes[10 + 3 * c])] =
              k * power(at[0], k - 1) * l * power(at[1], l - 1) * (first[0] + first[1]) * (second[0] + second[1]);
        }
      for (int cell = 0; cell < block.cells(); ++cell)
        for (const Place& xi : {Place{-0.3, 0.4, -1}, {0.8, -0.9, -1}, {0.1, 0.2, -1}}) {
          std::array<double, 3> x{};
          for (std::size_t d = 0; d < 3; ++d) {
            std::vector<double> component;
            for (int node = 0; node < mesh.nodes(); ++node) component.push_back(mesh.coordinates[at_node(node, d)]);
            x[d] = value_in(block, cell, xi, component);
          }
          const double expected = power(x[0], k) * power(x[1], l);
          EXPECT_NEAR(value_in(block, cell, xi, field), expected, 1e-13 * (1 + expected)) << k << l;
        }
    }
}

TEST(EnrichHermiteFacesTest, TheRimOfAPatchIsTiedAndAFreeRimIsNot) {
  // 2 x 2 faces inside a bottom of 4 x 4. Tied edges need no derivative along them: one node inside has three, a
  // corner only the mixed one, the middle of an edge the mixed one and that across.
  Mesh inside = brick({4, 4, 2});
  choose(inside, "patch", "bottom", {5, 6, 9, 10});
  const int before = inside.nodes();
  enrich(inside, "patch", ContactElement::Q1CH);
  EXPECT_EQ(inside.nodes() - before, 3 + 4 * 1 + 4 * 2);
  expect_sound(inside, "inside");
  // Half of a bottom of 4 x 3, up to a line of four nodes.
  Mesh half = brick({4, 3, 1});
  choose(half, "patch", "bottom", {0, 1, 4, 5, 8, 9});
  const int nodes = half.nodes();
  enrich(half, "patch", ContactElement::Q1CH);
  EXPECT_EQ(half.nodes() - nodes, 3 * 12 - 4);
  expect_sound(half, "half");
}

TEST(EnrichHermiteFacesTest, PatchesOfAnyShapeConform) { expect_patches_conform(ContactElement::Q1CH); }

TEST(EnrichHermiteFacesTest, ConformsWithSetsOfOtherElements) { expect_sets_conform(ContactElement::Q1CH); }

TEST(EnrichHermiteFacesTest, NodeSetsGetTheDerivativesBetweenTheirMembers) {
  // Derivatives along an edge of members, and the mixed ones of a face of members.
  Mesh mesh = brick({3, 2, 2});
  const int before = mesh.nodes();
  enrich(mesh, "bottom", ContactElement::Q1CH);
  const std::map<std::string, int> expected{{"bottom", 36}, {"surface", 36}, {"front", 4}, {"left", 3}, {"top", 0}};
  std::size_t sets = 0;
  for (const NodeSet& set : mesh.node_sets) {
    const auto found = expected.find(set.name);
    if (found == expected.end()) continue;
    ++sets;
    EXPECT_EQ(std::count_if(set.nodes.begin(), set.nodes.end(), [&](int node) { return node >= before; }),
              found->second)
        << set.name;
  }
  EXPECT_EQ(sets, expected.size());
}

}  // namespace
}  // namespace ixos

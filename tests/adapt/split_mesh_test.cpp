// Meshes and their trees: places of nodes, splits as values, and fields on other meshes.
#include "adapt/split_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "adapt/field_at.hpp"
#include "adapt/split_bodies.hpp"
#include "adapt/whole_field.hpp"
#include "mesh/fingerprint.hpp"
#include "mesh/local_mesh.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::split_box;

const std::vector<ContactElement> elements{ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                           ContactElement::Q1C4, ContactElement::Q2C2, ContactElement::Q2C4};

template <class Visit>
void for_each_mesh(const Visit& visit) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : elements)
      for (int kind = 0; kind < 4; ++kind) {
        SCOPED_TRACE(testing::Message() << dimension << "D, element " << static_cast<int>(element) << ", " << kind);
        visit(split_box(dimension, element, kind));
      }
  for (const test::SimplexKind& cells : test::simplex_kinds())
    for (int kind = 0; kind < 4; ++kind) {
      SCOPED_TRACE(testing::Message() << cells.cells << ", order " << cells.order
                                      << (cells.bubbles ? " with" : " without") << " bubbles, " << kind);
      visit(test::split_simplices(cells.cells, cells.order, cells.bubbles, kind));
    }
}

TEST(SplitMeshTest, EachNodeIsWhereItsPlaceIs) {
  for_each_mesh([](const SplitMesh& mesh) {
    const auto d = static_cast<std::size_t>(mesh.mesh().dimension);
    for (std::size_t node = 0; node < mesh.places().size(); ++node) {
      ASSERT_TRUE(mesh.places()[node]);
      std::array<double, 3> place{};
      evaluate(mesh, mesh.mesh().coordinates, d, *mesh.places()[node], place.data());
      for (std::size_t i = 0; i < d; ++i) EXPECT_NEAR(place[i], mesh.mesh().coordinates[node * d + i], 1e-14) << node;
    }
  });
}

TEST(SplitMeshTest, ReferencePointsAreThoseOfRootPoints) {
  for_each_mesh([](const SplitMesh& mesh) {
    for (std::size_t b = 0; b < mesh.mesh().blocks.size(); ++b)
      for (int cell = 0; cell < mesh.mesh().blocks[b].cells(); ++cell) {
        const SplitMesh::Cell own{static_cast<int>(b), cell};
        std::array<double, 3> xi{0.3, 0.4, mesh.mesh().dimension == 3 ? 0.2 : 0};  // in all shapes
        const RootPoint point = mesh.root_point(own, xi);
        EXPECT_EQ(mesh.tree().leaf_at(point), mesh.leaf_of(own));
        const std::array<double, 3> back = mesh.reference_point(own, point);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], xi[i], 1e-14);
      }
  });
}

TEST(SplitMeshTest, NodesOfHermiteSidesHaveNoPlace) {
  EXPECT_TRUE(reference_place(CellType::Quad4CH, 3));
  EXPECT_FALSE(reference_place(CellType::Quad4CH, 4));
}

TEST(CellSplitsTest, TheyMakeTheSameMeshAgain) {
  for (const int dimension : {2, 3})
    for (const int kind : {1, 2, 3}) {
      const SplitMesh mesh = split_box(dimension, ContactElement::Q1C1, kind);
      const CellSplits splits = mesh.tree().splits(), read = CellSplits::of_text(splits.text());
      EXPECT_GT(splits.size(), 0U);
      EXPECT_TRUE(read == splits);
      Mesh one = mesh.base(), other = mesh.base();
      EXPECT_TRUE(split(one, splits, 1).splits() == splits);
      split(other, read, 1);
      EXPECT_EQ(fingerprint(one), fingerprint(other));
      EXPECT_EQ(one.cells(), mesh.mesh().cells());
      EXPECT_EQ(one.nodes(), mesh.mesh().nodes());
      EXPECT_EQ(one.ties.size(), mesh.mesh().ties.size());
    }
}

TEST(CellSplitsTest, OtherTextsAreRefused) {
  for (const char* text :
       {"1 2 3", "0 0 0 0 0 0 0 0 3", "0 0 0 0 0 0 0 0 1 7", "0 0 0 0 0 0 0 -1 1", "a b c d e f g h i"})
    EXPECT_EQ(test::refusal([&] { CellSplits::of_text(text); }), "\"" + std::string(text) + "\" is no split of a cell");
}

double smooth(const double* x, std::size_t d) { return std::sin(x[0]) + x[1] * x[1] + (d == 3 ? x[2] * x[0] : 0); }

TEST(FieldAtTest, FinerCellsHaveTheSameFunction) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2})
      for (const int kind : {1, 2, 3}) {
        const SplitMesh coarse = split_box(dimension, element, 0), fine = split_box(dimension, element, kind);
        const auto d = static_cast<std::size_t>(dimension);
        std::vector<double> field;
        for (int node = 0; node < coarse.mesh().nodes(); ++node)
          field.push_back(smooth(&coarse.mesh().coordinates[static_cast<std::size_t>(node) * d], d));
        const std::vector<double> moved = interpolated(coarse, field, 1, fine);
        for (int root = 0; root < coarse.base().cells(); ++root)
          for (const double x : {-0.93, -0.2, 0.31, 0.77}) {
            const RootPoint point{0, root, {x, 0.9 - x * x, dimension == 3 ? -x / 2 : 0}};
            double before = 0, after = 0;
            evaluate(coarse, field, 1, point, &before);
            evaluate(fine, moved, 1, point, &after);
            EXPECT_NEAR(after, before, 2e-15 * 10);
          }
        // Back again: the nodes that stay have their values.
        EXPECT_EQ(interpolated(fine, moved, 1, coarse), field);
      }
}

TEST(WholeFieldTest, RanksSeeTheFieldOfAll) {
  const SplitMesh split = split_box(2, ContactElement::Q1C1, 1);
  const LocalMesh mesh = local_part(split.mesh(), test::world());
  std::vector<double> local;
  for (const int original : mesh.original_ids) {
    local.push_back(original);
    local.push_back(-2.0 * original);
  }
  const std::vector<double> whole = whole_field(mesh, test::world(), local, 2, split.mesh().nodes());
  for (std::size_t node = 0; node < whole.size() / 2; ++node) {
    EXPECT_EQ(whole[2 * node], static_cast<double>(node));
    EXPECT_EQ(whole[2 * node + 1], -2.0 * static_cast<double>(node));
  }
  EXPECT_EQ(local_field(mesh, whole, 2), local);
}

}  // namespace
}  // namespace ixos

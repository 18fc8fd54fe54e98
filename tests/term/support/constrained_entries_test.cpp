// The matrix entries of constrained degrees of freedom, against a walk over the whole matrix.
#include "term/support/constrained_entries.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

class ConstrainedEntriesTest : public testing::Test {
 protected:
  ConstrainedEntriesTest() : local_(part()), pattern_(local_) {
    // Components that are scattered over owned nodes and ghosts, equal on all ranks.
    for (int node = 0; node < local_.nodes(); ++node)
      for (int i = 0; i < 2; ++i)
        if ((3 * local_.original_ids[static_cast<std::size_t>(node)] + i) % 5 == 0)
          constraints_.add(2 * node + i, 1.0, nullptr);
    for (int k = 0; k < 4 * pattern_.pairs(); ++k) values_.push_back(std::sin(1.0 + k));
    for (int i = 0; i < 2 * local_.nodes(); ++i) x_.push_back(std::cos(2.0 * i));
  }
  static LocalMesh part() {
    BoxShape shape;
    shape.dimension = 2;
    shape.divisions = {5, 3, 1};
    const Mesh mesh = box(shape);
    const int ranks = world()->getSize();
    return localize(mesh, partition_nodes(mesh, ranks), world()->getRank(), ranks);
  }

  LocalMesh local_;
  Pattern pattern_;
  Constraints constraints_;
  std::vector<double> values_, x_;
};

TEST_F(ConstrainedEntriesTest, BecomeADiagonal) {
  std::vector<double> found = values_;
  ConstrainedEntries(pattern_, constraints_).constrain(7.0, found.data());
  std::size_t place = 0;
  pattern_.for_each_row(found.data(), [&](int row, const auto& entries) {
    entries([&](int column, double value) {
      const bool held = constraints_.holds(row) || constraints_.holds(column);
      EXPECT_EQ(value, !held ? values_[place] : row == column ? 7.0 : 0.0) << row << " " << column;
      ++place;
    });
  });
  EXPECT_EQ(place, values_.size());
}

TEST_F(ConstrainedEntriesTest, MultiplyTheirColumns) {
  std::vector<double> found(2 * static_cast<std::size_t>(pattern_.rows()), 99.0);
  const ConstrainedEntries entries_of(pattern_, constraints_);
  EXPECT_TRUE(entries_of.are_of(constraints_));
  entries_of.multiply(values_.data(), x_.data(), found.data());
  pattern_.for_each_row(values_.data(), [&](int row, const auto& entries) {
    double sum = 0;
    entries([&](int column, double value) {
      if (constraints_.holds(column) && !constraints_.holds(row)) sum += value * x_[static_cast<std::size_t>(column)];
    });
    EXPECT_NEAR(found[static_cast<std::size_t>(row)], sum, 1e-14) << row;
  });
}

TEST_F(ConstrainedEntriesTest, ProjectOntoThePlanesOfNodes) {
  Constraints planes;
  for (int node = 0; node < local_.nodes(); ++node)
    if (local_.original_ids[static_cast<std::size_t>(node)] % 3 == 0)
      planes.hold_in_plane(node, 2, {std::cos(1.0 * local_.original_ids[static_cast<std::size_t>(node)]), 0.7, 0});
  std::vector<double> found = values_;
  ConstrainedEntries(pattern_, planes).constrain(7.0, found.data());
  // (P K P + 7 (I - P)) x, with the projection of vectors.
  std::vector<double> inside = x_, expected(x_.size(), 0.0), product(x_.size(), 0.0);
  planes.planes().project(inside.data(), local_.nodes());
  add_matrix_product(pattern_, values_.data(), 1.0, inside.data(), expected.data());
  planes.planes().project(expected.data(), local_.owned_nodes);
  planes.planes().add_across(7.0, x_.data(), expected.data(), local_.owned_nodes);
  add_matrix_product(pattern_, found.data(), 1.0, x_.data(), product.data());
  for (int i = 0; i < 2 * local_.owned_nodes; ++i)
    EXPECT_NEAR(product[static_cast<std::size_t>(i)], expected[static_cast<std::size_t>(i)], 1e-12) << i;
}

}  // namespace
}  // namespace ixos

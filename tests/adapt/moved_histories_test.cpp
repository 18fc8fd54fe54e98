// The numbers that quadrature points keep move from mesh to mesh.
#include "adapt/moved_histories.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "adapt/split_bodies.hpp"
#include "fem/cell_info.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/half_space.hpp"
#include "material/elastic_law.hpp"
#include "mesh/cell_sides.hpp"
#include "model/surface_interaction.hpp"
#include "state/history.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using test::split_box;

/// A body with two branches that rubs on a wall with its bottom.
struct Body {
  explicit Body(SplitMesh own) : mesh(std::move(own)) {
    Material material = test::elastic(neo_hooke, 0.3);
    material.branches = {{0.5, 0.4}, {0.2, 2}};
    model = test::model_of(mesh.mesh(), material, Inertia::Consistent);
    const bool in_space = mesh.mesh().dimension == 3;
    SurfaceInteraction wall;
    wall.side_set = "bottom";
    wall.law = make_gap_law("Van der Waals", {{"Gamma L", 1}, {"Gamma W", 10}});
    wall.obstacle =
        flat_wall({{0, in_space ? 0 : -0.7, in_space ? -0.7 : 0}, {0, in_space ? 0.0 : 1.0, in_space ? 1.0 : 0.0}});
    wall.friction.type = FrictionType::ExtendedAmontons;
    wall.friction.coefficient = 0.3;
    add_interaction(*model, wall);
    histories = model->create_histories();
  }

  /// Calls visit(columns, row, point, its place in the undeformed body) for all points.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (std::size_t slot = 0; slot < histories.size(); ++slot)
      for (PointColumns& columns : histories.of(slot).points)
        for (std::size_t row = 0; row < columns.values.owners().size(); ++row)
          for (std::size_t q = 0; q < columns.values.points(); ++q)
            visit(columns, row, q, place(columns.values.owners()[row], columns.places[q]));
  }

  /// Between the corners of a cell or a side of a box, all of whose edges are straight.
  std::array<double, 3> place(const PointOwner& owner, const std::array<double, 3>& at) const {
    const Mesh& whole = mesh.mesh();
    const ElementBlock& block = whole.blocks[static_cast<std::size_t>(owner.block)];
    const auto d = static_cast<std::size_t>(whole.dimension);
    std::vector<int> corners;
    if (owner.side >= 0) {
      corners = nodes_of_side(whole, {owner.block, owner.cell, owner.side});
    } else {
      const int* const nodes = &block.nodes[cell_entry(owner.cell, nodes_per_cell(block.type))];
      corners.assign(nodes, nodes + nodes_per_cell(corner_type(block.type)));
    }
    const auto x = [&](std::size_t corner, std::size_t i) {
      return whole.coordinates[static_cast<std::size_t>(corners[corner]) * d + i];
    };
    const std::size_t directions = owner.side >= 0 ? d - 1 : d;
    std::array<double, 3> result{};
    if (!is_cube(block.type) && (owner.side < 0 || d == 3)) {  // triangles and tetrahedra
      for (std::size_t i = 0; i < d; ++i) {
        result[i] = x(0, i);
        for (std::size_t k = 0; k < directions; ++k) result[i] += at[k] * (x(k + 1, i) - x(0, i));
      }
      return result;
    }
    constexpr std::size_t neighbour[] = {1, 3, 4};  // of the first corner, along each direction
    for (std::size_t i = 0; i < d; ++i) {
      result[i] = x(0, i);
      for (std::size_t k = 0; k < directions; ++k) result[i] += (1 + at[k]) / 2 * (x(neighbour[k], i) - x(0, i));
    }
    return result;
  }

  SplitMesh mesh;
  std::unique_ptr<Model> model;
  TermHistories histories;
};

double linear(const std::array<double, 3>& x) { return 2 + 0.3 * x[0] - 0.2 * x[1] + 0.4 * x[2]; }

/// Numbers that are linear in the place; in branches the same C - I, of determinant 1, everywhere.
void fill(Body& body) {
  body.for_each([](PointColumns& columns, std::size_t row, std::size_t q, const std::array<double, 3>& x) {
    std::size_t first = 0;
    for (const Column& column : columns.columns) {
      for (std::size_t i = 0; i < column.count; ++i) {
        double value = linear(x);
        if (column.kind == ColumnKind::UnimodularTensor) {
          const double c[] = {1.25, 0, 0.8, 1}, space[] = {1.25, 0, 0, 0.8, 0, 1};
          value = column.count == 4 ? c[i] - (i == 1 ? 0 : 1) : space[i] - (i == 0 || i == 3 || i == 5 ? 1 : 0);
        }
        columns.values(row / pack_width, q, first + i)[row % pack_width] = value;
      }
      first += column.count;
    }
  });
}

void take(Body& after, const Body& before) {
  move_histories(before.mesh, *before.model, before.histories, after.mesh, *after.model, {}, after.histories);
}

TEST(MovedHistoriesTest, OnTheSameMeshNothingChanges) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C4}) {
      Body one(split_box(dimension, element, 1)), other(split_box(dimension, element, 1));
      fill(one);
      ASSERT_TRUE(one.histories != other.histories);
      take(other, one);
      EXPECT_TRUE(one.histories == other.histories) << dimension << "D";
    }
}

/// How far the numbers of a body are from those of fill().
struct Distance {
  int exact = 0, all = 0;
  double worst = 0;
};

/// Tractions are left out, which may lose a part; expects that branches have their strain to the last digits.
Distance distance_of(Body& body) {
  Distance found;
  body.for_each([&](PointColumns& columns, std::size_t row, std::size_t q, const std::array<double, 3>& x) {
    std::size_t first = 0;
    for (const Column& column : columns.columns) {
      for (std::size_t i = 0; i < column.count; ++i) {
        const auto value = double(columns.values(row / pack_width, q, first + i)[row % pack_width]);
        if (column.kind == ColumnKind::UnimodularTensor && i == 0) {
          EXPECT_NEAR(value, 0.25, 1e-14);
        }
        if (column.kind == ColumnKind::UnimodularTensor || column.kind == ColumnKind::SurfaceVector) continue;
        ++found.all;
        const double error = std::abs(value - linear(x));
        if (error < 1e-13) ++found.exact;
        found.worst = std::max(found.worst, error);
      }
      first += column.count;
    }
  });
  return found;
}

TEST(MovedHistoriesTest, NumbersThatAreLinearStaySoBetweenPointsAndKeepTheirRange) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2, ContactElement::Q1C2})
      for (const auto& [from, to] : {std::pair(0, 1), std::pair(1, 0), std::pair(1, 2), std::pair(2, 3)}) {
        SCOPED_TRACE(testing::Message() << dimension << "D, element " << static_cast<int>(element) << ", " << from
                                        << " to " << to);
        Body before(split_box(dimension, element, from)), after(split_box(dimension, element, to));
        fill(before);
        take(after, before);
        const auto [exact, all, worst] = distance_of(after);
        // Beyond the outermost points of a cell of 1 L0 the numbers are constant: over at most 0.22 L0 in a direction.
        EXPECT_LT(worst, 0.22 * (dimension == 2 ? 0.5 : 0.9));
        EXPECT_GT(exact, all / 10);
      }
}

TEST(MovedHistoriesTest, SimplicesKeepTheirNumbersOnTheSameMeshAndTheirRangeOnOthers) {
  for (const auto& [cells, order, bubbles] :
       {std::tuple("triangles", 2, false), std::tuple("triangles", 2, true), std::tuple("tetrahedra", 2, false),
        std::tuple("tetrahedra", 2, true), std::tuple("triangles", 1, false)}) {
    SCOPED_TRACE(testing::Message() << cells << ", order " << order << (bubbles ? ", bubbles" : ""));
    Body before(test::split_simplices(cells, order, bubbles, 1)), same(test::split_simplices(cells, order, bubbles, 1)),
        after(test::split_simplices(cells, order, bubbles, 2));
    fill(before);
    take(same, before);
    EXPECT_TRUE(same.histories == before.histories);
    take(after, before);
    const auto [exact, all, worst] = distance_of(after);
    // Cells of 1 L0; the gradient is 0.36 in the plane and 0.54 in space. One point stands for a whole linear triangle.
    EXPECT_LT(worst, order == 1 ? 0.36 : 0.3);
    EXPECT_GT(exact, all / 10);
  }
}

// Where nothing resists slip there is no traction; elsewhere it loses its part along the normal.
TEST(MovedHistoriesTest, TractionsFollowTheSurface) {
  for (const double cutoff : {1.0, 0.1}) {
    Body before(split_box(2, ContactElement::Q1C1, 0)), after(split_box(2, ContactElement::Q1C1, 1));
    fill(before);
    const auto nodes = static_cast<std::size_t>(after.mesh.mesh().nodes());
    SlidingSurface surface{std::vector<double>(2 * nodes, std::sqrt(0.5)), std::vector<double>(nodes, 0.5), cutoff};
    move_histories(before.mesh, *before.model, before.histories, after.mesh, *after.model, {{"interaction", surface}},
                   after.histories);
    double largest = 0;
    after.for_each([&](PointColumns& columns, std::size_t row, std::size_t q, const std::array<double, 3>&) {
      if (columns.columns.front().kind != ColumnKind::SurfaceVector) return;
      const auto at = [&](std::size_t i) { return double(columns.values(row / pack_width, q, i)[row % pack_width]); };
      EXPECT_NEAR(at(0) + at(1), 0, 1e-14);
      largest = std::max(largest, std::abs(at(2)));
      if (cutoff < 0.5) {
        EXPECT_EQ(at(0), 0);
        EXPECT_EQ(at(4), 0) << "sliding";
      }
    });
    after.model->space().sum(&largest, 1);
    EXPECT_GT(largest, 1) << "the slip so far stays";
  }
}

/// Returns a plane C - I of determinant 1 that differs from point to point.
std::array<double, 4> strain_at(const std::array<double, 3>& x) {
  const double stretch = 1 + 0.3 * std::sin(9 * x[0] + 5 * x[1]), angle = 4 * x[0] - 3 * x[1], c = std::cos(angle),
               s = std::sin(angle), one = stretch * stretch, two = 1 / one;
  return {c * c * one + s * s * two - 1, c * s * (one - two), s * s * one + c * c * two - 1, 0};
}

TEST(MovedHistoriesTest, AThousandChangesKeepStrainsAndRanges) {
  Body present(split_box(2, ContactElement::Q1C1, 1));
  present.for_each([](PointColumns& columns, std::size_t row, std::size_t q, const std::array<double, 3>& x) {
    const auto set = [&](std::size_t i, double value) {
      columns.values(row / pack_width, q, i)[row % pack_width] = value;
    };
    for (std::size_t i = 0; i < columns.values.numbers(); ++i) set(i, 0.5 + 0.5 * std::sin(7 * x[0]));
    if (columns.columns.front().kind == ColumnKind::UnimodularTensor)
      for (std::size_t i = 0; i < 8; ++i) set(i, strain_at(x)[i % 4]);
  });
  for (int n = 0; n < 1000; ++n) {
    Body next(split_box(2, ContactElement::Q1C1, n % 4));
    take(next, present);
    present = std::move(next);
  }
  double least = 1, largest = 0, strain = 0;
  present.for_each([&](PointColumns& columns, std::size_t row, std::size_t q, const std::array<double, 3>&) {
    const auto at = [&](std::size_t i) { return double(columns.values(row / pack_width, q, i)[row % pack_width]); };
    if (columns.columns.front().kind != ColumnKind::UnimodularTensor) {
      least = std::min(least, at(2));
      largest = std::max(largest, at(2));
      return;
    }
    for (const std::size_t first : {0U, 4U}) {
      const double xx = 1 + at(first), xy = at(first + 1), yy = 1 + at(first + 2), zz = 1 + at(first + 3);
      EXPECT_GT(xx, 0);
      EXPECT_NEAR((xx * yy - xy * xy) * zz, 1, 1e-11);
      strain = std::max(strain, std::abs(at(first)));
    }
  });
  present.model->space().sum(&strain, 1);
  EXPECT_GT(strain, 0.05) << "means take the waves, not the strain";
  EXPECT_GE(least, 0);
  EXPECT_LE(largest, 1);
}

}  // namespace
}  // namespace ixos

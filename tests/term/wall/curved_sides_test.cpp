// Places of quadrature points under affine motions, of which every element reproduces each value.
#include "term/wall/curved_sides.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "term/box_part.hpp"
#include "term/side_kinds.hpp"
#include "term/wall/curved_sides_of.hpp"
#include "term/wall/side_ends.hpp"

namespace ixos {
namespace {

/// The field h X + t of the places X.
struct Affine {
  double h[3][3];
  double t[3];

  double at(const double* x, std::size_t dimension, std::size_t i) const {
    double value = t[i];
    for (std::size_t j = 0; j < dimension; ++j) value += h[i][j] * x[j];
    return value;
  }
};

const Affine start{{{0.1, -0.2, 0.05}, {0.3, -0.1, 0.2}, {-0.15, 0.25, 0.1}}, {0.4, -0.3, 0.6}};
const Affine rate{{{-0.3, 0.1, 0.2}, {0.05, 0.2, -0.1}, {0.1, -0.4, 0.3}}, {-0.2, 0.5, 0.1}};
const Affine end{{{0.2, 0.4, -0.1}, {-0.25, 0.1, 0.3}, {0.05, -0.1, -0.2}}, {0.7, 0.2, -0.5}};

/// The surface of a box, on this rank.
struct Body {
  Body(int dimension, ContactElement element)
      : mesh(test::box_part(dimension, element)), pattern(mesh), from(nodal(start)), way(nodal(rate)), to(nodal(end)) {}

  /// Returns the field's nodal values, a local array. A derivative node's coordinates are derivatives.
  std::vector<double> nodal(const Affine& field) const {
    const auto dimension = static_cast<std::size_t>(mesh.dimension);
    std::vector<double> values(mesh.coordinates.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t node = k / dimension, i = k % dimension;
      values[k] = field.at(&mesh.coordinates[node * dimension], dimension, i);
      if (mesh.is_derivative(node)) values[k] -= field.t[i];
    }
    return values;
  }

  LocalMesh mesh;
  Pattern pattern;
  std::vector<double> from, way, to;  ///< nodal values of the fields
};

/// Calls check(body, sides, b, q, i, X) for each lane i of each quadrature point q, which has the place X in the
/// reference. The sides of a box are flat, so X is the mean of the corners by bilinear weights.
template <class Check>
void for_points(const Check& check) {
  for (int dimension : {2, 3})
    for (ContactElement element :
         {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH,
          ContactElement::Q2C2, ContactElement::Q2C4}) {
      const Body body(dimension, element);
      const LocalMesh& mesh = body.mesh;
      test::for_each_kind_of_side(
          mesh, mesh.side_sets[mesh.side_set("surface")], [&](auto side, const std::vector<LocalSide>& group) {
            using Sides = CurvedSides<typename decltype(side)::type>;
            using Corners = Multilinear<static_cast<int>(Sides::D) - 1>;
            const Sides sides(mesh, group, body.pattern, 0);
            for (std::size_t b = 0; b < sides.size(); ++b)
              for (std::size_t q = 0; q < sides.quadrature().size(); ++q) {
                std::array<double, Corners::nodes> weight;
                Small<double, Corners::nodes, Sides::D - 1> slope;
                Corners::evaluate(sides.quadrature().point[q], weight, slope);
                for (std::size_t i = 0; i < sides.batches().lanes(b); ++i) {
                  const LocalSide& own = group[b * static_cast<std::size_t>(pack_width) + i];
                  std::array<double, 3> x{};
                  for (std::size_t a = 0; a < weight.size(); ++a)
                    for (std::size_t d = 0; d < Sides::D; ++d)
                      x[d] += weight[a] * mesh.coordinates[static_cast<std::size_t>(own.nodes[a]) * Sides::D + d];
                  check(body, sides, b, q, i, x);
                }
              }
          });
    }
}

TEST(CurvedSidesTest, EndsAreWhereTheMotionTakesThem) {
  for_points([](const Body& body, const auto& sides, std::size_t b, std::size_t q, std::size_t i,
                const std::array<double, 3>& x) {
    using Sides = std::decay_t<decltype(sides)>;
    using Ends = SideEnds<Sides::D>;
    Ends ends(sides, Ends::Of::Places, {body.from.data(), nullptr, body.to.data()});
    ends.set(b);
    const PackPoint from = ends.from(q), to = ends.to(q);
    for (std::size_t d = 0; d < Sides::D; ++d) {
      EXPECT_NEAR(lane(from[d], i), x[d] + start.at(x.data(), Sides::D, d), 1e-13);
      EXPECT_NEAR(lane(to[d], i), x[d] + end.at(x.data(), Sides::D, d), 1e-13);
    }
    if (Sides::D == 2) {
      EXPECT_EQ(lane(to[2], i), 0);
    }
  });
}

TEST(CurvedSidesTest, PlacesOfTimePointsFollowTheRule) {
  for_points([](const Body& body, const auto& sides, std::size_t b, std::size_t q, std::size_t i,
                const std::array<double, 3>& x) {
    using Sides = std::decay_t<decltype(sides)>;
    using Ends = SideEnds<Sides::D>;
    Ends straight(sides, Ends::Of::Places, {body.from.data(), nullptr, body.to.data()});
    Ends bent(sides, Ends::Of::Places, {body.from.data(), body.way.data(), body.to.data()});
    straight.set(b);
    bent.set(b);
    const double xi = 0.3;
    const PackPoint linear = straight.at(q, {1, 1 - xi, 0, xi, xi});
    const PackPoint quadratic = bent.at(q, {1, 1 - xi * xi, xi - xi * xi, xi * xi, xi});
    for (std::size_t d = 0; d < Sides::D; ++d) {
      const double from = start.at(x.data(), Sides::D, d), to = end.at(x.data(), Sides::D, d);
      const double way = rate.at(x.data(), Sides::D, d);
      EXPECT_NEAR(lane(linear[d], i), x[d] + from + xi * (to - from), 1e-13);
      EXPECT_NEAR(lane(quadratic[d], i), x[d] + from + xi * way + xi * xi * (to - from - way), 1e-13);
    }
  });
}

TEST(CurvedSidesTest, WithoutAStartThePlaceOfTheEndCounts) {
  for_points([](const Body& body, const auto& sides, std::size_t b, std::size_t q, std::size_t i,
                const std::array<double, 3>&) {
    using Sides = std::decay_t<decltype(sides)>;
    using Ends = SideEnds<Sides::D>;
    Ends ends(sides, Ends::Of::Places, {nullptr, nullptr, body.to.data()});
    ends.set(b);
    const PackPoint to = ends.to(q), at = ends.at(q, {1, 0, 0, 1, 1});
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(lane(at[d], i), lane(to[d], i));
  });
}

}  // namespace
}  // namespace ixos

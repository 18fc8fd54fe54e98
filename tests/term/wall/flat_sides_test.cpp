#include "term/wall/flat_sides.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>

#include "term/box_part.hpp"
#include "term/side_kinds.hpp"

namespace ixos {
namespace {

/// The surface of a box before a wall, on this rank.
struct Body {
  Body(int dimension, ContactElement element, const std::array<double, 3>& normal)
      : mesh(test::box_part(dimension, element)), pattern(mesh), wall{{0.3, -0.7, 0.2}, normal} {}

  /// Calls visit(sides, group) for each kind of side, with the sides of that kind.
  template <class Visit>
  void for_sides(const Visit& visit) const {
    test::for_each_kind_of_side(mesh, mesh.side_sets[mesh.side_set("surface")],
                                [&](auto side, const std::vector<LocalSide>& group) {
                                  using SideElement = typename decltype(side)::type;
                                  visit(FlatSides<SideElement>(mesh, group, pattern, wall, 0), group);
                                });
  }

  /// A local array without order.
  std::vector<double> noise(double phase) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) values.push_back(std::sin(phase += 1.7));
    return values;
  }

  LocalMesh mesh;
  Pattern pattern;
  HalfSpace wall;
};

/// Normals of tilted walls, of walls along an axis, and of one that plane bodies do not see.
const std::array<double, 3> tilted = {0.48, 0.6, 0.64}, tilted_in_plane = {0.6, -0.8, 0.0},
                            between_axes = {0.6, 0.0, 0.8}, down = {0.0, -1.0, 0.0}, across = {0.0, 0.0, 1.0};

/// Runs a check on plane and solid bodies with every kind of side.
template <class Check>
void for_bodies(const Check& check) {
  for (int dimension : {2, 3})
    for (ContactElement element :
         {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH,
          ContactElement::Q2C2, ContactElement::Q2C4})
      for (const auto& normal : {dimension == 2 ? tilted_in_plane : tilted, between_axes, down, across})
        check(Body(dimension, element, normal));
}

TEST(FlatSidesTest, GapsOfPlacesAreTheirDistancesFromTheWall) {
  for_bodies([](const Body& body) {
    const std::vector<double> u = body.noise(0.3);
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>& group) {
      using Sides = std::decay_t<decltype(sides)>;
      for (std::size_t b = 0; b < sides.size(); ++b) {
        const auto gap = sides.gaps_of(b, u.data());
        for (std::size_t i = 0; i < sides.batches().lanes(b); ++i)
          for (std::size_t a = 0; a < Sides::N; ++a) {
            const auto node = static_cast<std::size_t>(group[b * static_cast<std::size_t>(pack_width) + i].nodes[a]);
            if (body.mesh.is_derivative(node)) continue;
            double distance = 0;
            for (std::size_t d = 0; d < Sides::D; ++d) {
              const std::size_t k = node * Sides::D + d;
              distance += (body.mesh.coordinates[k] + u[k] - body.wall.point[d]) * body.wall.normal[d];
            }
            EXPECT_NEAR(lane(gap[a], i), distance, 1e-13);
          }
      }
    });
  });
}

// The box moves by H X + t. Its sides are flat, so a point of a side is the mean of its corners by bilinear weights,
// whatever the element: interpolated gaps are distances for derivative nodes too.
TEST(FlatSidesTest, InterpolatedGapsAreDistancesUnderAnAffineMotion) {
  const double h[3][3] = {{0.1, -0.2, 0.05}, {0.3, -0.1, 0.2}, {-0.15, 0.25, 0.1}}, t[3] = {0.4, -0.3, 0.6};
  for_bodies([&](const Body& body) {
    const auto dimension = static_cast<std::size_t>(body.mesh.dimension);
    std::vector<double> u(body.mesh.coordinates.size());
    for (std::size_t k = 0; k < u.size(); ++k) {
      u[k] = body.mesh.is_derivative(k / dimension) ? 0.0 : t[k % dimension];
      for (std::size_t j = 0; j < dimension; ++j)
        u[k] += h[k % dimension][j] * body.mesh.coordinates[k - k % dimension + j];
    }
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>& group) {
      using Sides = std::decay_t<decltype(sides)>;
      using Corners = Multilinear<static_cast<int>(Sides::D) - 1>;
      for (std::size_t b = 0; b < sides.size(); ++b) {
        const auto gap = sides.gaps_of(b, u.data());
        for (std::size_t q = 0; q < sides.quadrature().size(); ++q) {
          std::array<double, Corners::nodes> weight;
          Small<double, Corners::nodes, Sides::D - 1> slope;
          Corners::evaluate(sides.quadrature().point[q], weight, slope);
          for (std::size_t i = 0; i < sides.batches().lanes(b); ++i) {
            std::array<double, Sides::D> x{};
            for (std::size_t a = 0; a < weight.size(); ++a)
              for (std::size_t d = 0; d < Sides::D; ++d) {
                const LocalSide& side = group[b * static_cast<std::size_t>(pack_width) + i];
                x[d] += weight[a] * body.mesh.coordinates[static_cast<std::size_t>(side.nodes[a]) * Sides::D + d];
              }
            double distance = 0, interpolated = 0;
            for (std::size_t d = 0; d < Sides::D; ++d) {
              double place = x[d] + t[d];
              for (std::size_t j = 0; j < Sides::D; ++j) place += h[d][j] * x[j];
              distance += (place - body.wall.point[d]) * body.wall.normal[d];
            }
            for (std::size_t a = 0; a < Sides::N; ++a) interpolated += sides.quadrature().value[q][a] * lane(gap[a], i);
            EXPECT_NEAR(interpolated, distance, 1e-13);
          }
        }
      }
    });
  });
}

TEST(FlatSidesTest, ChangesAreDifferencesOfGaps) {
  for_bodies([](const Body& body) {
    const std::vector<double> u = body.noise(0.3), v = body.noise(0.9);
    std::vector<double> end = u;
    for (std::size_t k = 0; k < u.size(); ++k) end[k] += v[k];
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>&) {
      using Sides = std::decay_t<decltype(sides)>;
      for (std::size_t b = 0; b < sides.size(); ++b) {
        const auto change = sides.change_of(b, v.data());
        const auto from = sides.gaps_of(b, u.data()), to = sides.gaps_of(b, end.data());
        for (std::size_t a = 0; a < Sides::N; ++a)
          for (std::size_t i = 0; i < Pack::size(); ++i)
            EXPECT_NEAR(lane(change[a], i), lane(to[a], i) - lane(from[a], i), 1e-13);
      }
    });
  });
}

// Forces along the normal do the work of the changes of the gaps: scattering is the transpose of gathering.
TEST(FlatSidesTest, ForcesDoTheWorkOfTheGaps) {
  for_bodies([](const Body& body) {
    const std::vector<double> v = body.noise(0.9);
    std::vector<double> force(v.size(), 0.0);
    double work = 0, phase = 0.5;
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>&) {
      using Sides = std::decay_t<decltype(sides)>;
      for (std::size_t b = 0; b < sides.size(); ++b) {
        const auto change = sides.change_of(b, v.data());
        typename Sides::Nodal along{};
        for (std::size_t a = 0; a < Sides::N; ++a)
          for (std::size_t i = 0; i < Pack::size(); ++i) {
            along[a][i] = std::sin(phase += 2.3);
            if (i < sides.batches().lanes(b)) work += lane(along[a], i) * lane(change[a], i);
          }
        sides.scatter_along(b, along, force.data());
      }
    });
    double of_force = 0;
    for (std::size_t k = 0; k < v.size(); ++k) of_force += force[k] * v[k];
    EXPECT_NEAR(of_force, work, 1e-12);
  });
}

// A wall along an axis takes a shorter way, to the entries that are not 0.
TEST(FlatSidesTest, TangentsAreThoseOfMatricesAlongTheNormal) {
  for_bodies([](const Body& body) {
    const auto size = static_cast<std::size_t>(body.pattern.pairs() * body.mesh.dimension * body.mesh.dimension);
    std::vector<double> values(size, 0.0), expected(size, 0.0);
    double phase = 0.2;
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>&) {
      using Sides = std::decay_t<decltype(sides)>;
      std::vector<Pack> k(sides.quadrature().size());
      for (std::size_t b = 0; b < sides.size(); ++b) {
        Small<Pack, Sides::N> along{};
        for (std::size_t q = 0; q < k.size(); ++q) {
          k[q] = std::sin(phase += 2.3);
          const auto& shape = sides.quadrature().value[q];
          for (std::size_t a = 0; a < Sides::N; ++a)
            for (std::size_t c = 0; c < Sides::N; ++c) along[a][c] += (shape[a] * shape[c]) * k[q];
        }
        Small<Pack, Sides::N * Sides::D> matrix{};
        sides.spread(along, matrix);
        sides.batches().scatter_tangent(b, matrix, expected.data());
        sides.add_tangent(b, k.data(), values.data());
      }
    });
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(values[i], expected[i], 1e-13);
  });
}

TEST(FlatSidesTest, VectorsStandAlongTheNormal) {
  for_bodies([](const Body& body) {
    body.for_sides([&](const auto& sides, const std::vector<LocalSide>&) {
      using Sides = std::decay_t<decltype(sides)>;
      EXPECT_EQ(sides.normal(), body.wall.normal);
      typename Sides::Nodal along{};
      for (std::size_t a = 0; a < Sides::N; ++a) along[a] = static_cast<double>(a) - 1.5;
      const auto vectors = sides.from_normal(along);
      for (std::size_t a = 0; a < Sides::N; ++a)
        for (std::size_t d = 0; d < Sides::D; ++d)
          EXPECT_EQ(lane(vectors[a][d], 0), (static_cast<double>(a) - 1.5) * body.wall.normal[d]);
    });
  });
}

}  // namespace
}  // namespace ixos

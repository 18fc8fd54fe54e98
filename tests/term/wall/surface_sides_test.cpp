#include "term/wall/surface_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "discretization/dof_space.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/selection.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"
#include "term/side_kinds.hpp"

namespace ixos {
namespace {

const ContactElement elements[] = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                   ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                   ContactElement::Q2C4};

/// This rank's part of a mesh.
struct Part {
  explicit Part(const Mesh& whole) : mesh(localized(whole)), space(mesh, test::world()), pattern(mesh) {}

  static LocalMesh localized(const Mesh& whole) {
    const Comm comm = test::world();
    return localize(whole, partition_nodes(whole, comm->getSize()), comm->getRank(), comm->getSize());
  }
  double sum(double value) const {
    space.sum(&value, 1);
    return value;
  }

  LocalMesh mesh;
  DofSpace space;
  Pattern pattern;
};

/// Calls visit(sides) for each kind of side of the set.
template <class Visit>
void for_sides(const Part& part, const std::string& set, int points, const Visit& visit) {
  test::for_each_kind_of_side(part.mesh, part.mesh.side_sets[part.mesh.side_set(set)],
                              [&](auto side, const std::vector<LocalSide>& group) {
                                using SideElement = typename decltype(side)::type;
                                visit(SurfaceSides<SideElement>(part.mesh, group, part.pattern, points));
                              });
}

double area(const Part& part, const std::string& set, int points = 0) {
  double sum = 0;
  for_sides(part, set, points, [&](const auto& sides) {
    for (std::size_t b = 0; b < sides.size(); ++b)
      for (std::size_t q = 0; q < sides.quadrature().size(); ++q)
        sum += total(Pack(sides.owned(b) * sides.measure(b)[q]));
  });
  return part.sum(sum);
}

/// Returns the volume that the set encloses, from the divergence of x: int x . n dA/D, with normals to the outside.
double enclosed(const Part& part, const std::string& set) {
  double sum = 0;
  for_sides(part, set, 0, [&](const auto& sides) {
    using Sides = std::decay_t<decltype(sides)>;
    const auto& table = sides.quadrature();
    for (std::size_t b = 0; b < sides.size(); ++b)
      for (std::size_t q = 0; q < table.size(); ++q) {
        Small<Pack, Sides::D> rows{};  // position, then tangents
        for (std::size_t a = 0; a < Sides::N; ++a)
          for (std::size_t d = 0; d < Sides::D; ++d) {
            rows[0][d] += table.value[q][a] * sides.reference(b)[a][d];
            for (std::size_t k = 0; k + 1 < Sides::D; ++k)
              rows[k + 1][d] += table.gradient[q][a][k] * sides.reference(b)[a][d];
          }
        sum += total(Pack(sides.owned(b) * table.weight[q] * determinant(rows)));
      }
  });
  return part.sum(sum) / part.mesh.dimension;
}

/// Returns the sums of int N_a dA X_a over all nodes, and of int N_a dA over those that are places.
std::vector<double> nodal_sums(const Part& part, const std::string& set) {
  std::vector<double> measure(static_cast<std::size_t>(part.mesh.nodes()), 0.0);
  CountedSides counted;
  for (int time = 0; time < 2; ++time)  // at the second time all sides are counted
    for_sides(part, set, 0, [&](const auto& sides) { sides.add_nodal_measure(counted, measure.data()); });
  const auto dimension = static_cast<std::size_t>(part.mesh.dimension);
  std::vector<double> sums(dimension + 1, 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(part.mesh.owned_nodes); ++node) {
    for (std::size_t d = 0; d < dimension; ++d) sums[d] += measure[node] * part.mesh.coordinates[node * dimension + d];
    if (!part.mesh.is_derivative(node)) sums[dimension] += measure[node];
  }
  part.space.sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

/// Edges of a parallelogram, in space of a parallelepiped; the last is the third.
const double edges[3][3] = {{1.5, -0.3, 0.2}, {0.4, 1.1, -0.1}, {-0.2, 0.5, 0.9}};

/// The body of these edges, its bottom enriched.
Mesh slanted(int dimension, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {3, 3, 1};
  Mesh mesh = box(shape);
  const auto D = static_cast<std::size_t>(dimension);
  for (std::size_t first = 0; first < mesh.coordinates.size(); first += D) {
    const std::vector<double> share(&mesh.coordinates[first], &mesh.coordinates[first] + D);
    for (std::size_t d = 0; d < D; ++d) {
      mesh.coordinates[first + d] = 0;
      for (std::size_t e = 0; e < D; ++e) mesh.coordinates[first + d] += share[e] * edges[e][d];
    }
  }
  test::give_contact_element(mesh, "bottom", element);
  return mesh;
}

double length(const double (&x)[3], std::size_t D) {
  double square = 0;
  for (std::size_t d = 0; d < D; ++d) square += x[d] * x[d];
  return std::sqrt(square);
}

double parallelogram(const double (&x)[3], const double (&y)[3]) {
  const double normal[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  return length(normal, 3);
}

double surface_of_slanted(int dimension) {
  if (dimension == 2) return 2 * (length(edges[0], 2) + length(edges[1], 2));
  return 2 *
         (parallelogram(edges[0], edges[1]) + parallelogram(edges[1], edges[2]) + parallelogram(edges[2], edges[0]));
}

double volume_of_slanted(int dimension) {
  const double plane = edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0];
  if (dimension == 2) return plane;
  return plane * edges[2][2] + (edges[0][1] * edges[1][2] - edges[0][2] * edges[1][1]) * edges[2][0] +
         (edges[0][2] * edges[1][0] - edges[0][0] * edges[1][2]) * edges[2][1];
}

TEST(SurfaceSidesTest, MeasureIsTheLengthOrTheArea) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements) {
      const Part part(slanted(dimension, element));
      EXPECT_NEAR(area(part, "surface"), surface_of_slanted(dimension), 1e-12);
      EXPECT_NEAR(area(part, "bottom"), dimension == 2 ? length(edges[0], 2) : parallelogram(edges[0], edges[1]),
                  1e-12);
    }
}

TEST(SurfaceSidesTest, NormalsPointOutOfTheBody) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements)
      EXPECT_NEAR(enclosed(Part(slanted(dimension, element)), "surface"), volume_of_slanted(dimension), 1e-12);
}

TEST(SurfaceSidesTest, NodalMeasuresSumToTheMeasureAndItsMoment) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements) {
      const std::vector<double> sums = nodal_sums(Part(slanted(dimension, element)), "surface");
      const double whole = surface_of_slanted(dimension);
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
        // The surface is symmetric about the centre of the body.
        const double centre = (edges[0][d] + edges[1][d] + (dimension == 3 ? edges[2][d] : 0.0)) / 2;
        EXPECT_NEAR(sums[d], whole * centre, 1e-12);
      }
      EXPECT_NEAR(sums.back(), whole, 1e-12);
    }
}

TEST(SurfaceSidesTest, EdgesAreTiedWhereTheSetEndsInsideTheSurface) {
  for (ContactElement element : elements) {
    BoxShape shape;
    shape.dimension = 3;
    shape.lengths = {4, 3, 2};
    shape.divisions = {4, 3, 2};
    Mesh mesh = box(shape);
    add_side_set(mesh, "patch", "bottom", {{}, {2.5, 3, 2}});  // up to x = 2
    test::give_contact_element(mesh, "patch", element);
    const Part part(mesh);
    EXPECT_NEAR(area(part, "patch"), 2 * 3, 1e-12);
    const std::vector<double> sums = nodal_sums(part, "patch"), expected{6 * 1.0, 6 * 1.5, 0.0, 6.0};
    for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(sums[d], expected[d], 1e-12) << d;
  }
}

// The bottom is bent to the height k x^2, which sides of order 2 and more reproduce.
TEST(SurfaceSidesTest, MeasureOfABentSurfaceIsThatOfTheParabola) {
  const double k = 0.3, end = 2, breadth = 1.5;
  const double arc = end / 2 * std::sqrt(1 + 4 * k * k * end * end) + std::asinh(2 * k * end) / (4 * k);
  for (std::size_t dimension : {2U, 3U})
    for (ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4}) {
      BoxShape shape;
      shape.dimension = static_cast<int>(dimension);
      shape.lengths = {end, dimension == 2 ? 4.0 : breadth, 4.0};
      shape.divisions = {4, 2, 1};
      Mesh mesh = box(shape);
      test::give_contact_element(mesh, "bottom", element);
      for (std::size_t first = 0; first < mesh.coordinates.size(); first += dimension)
        if (mesh.coordinates[first + dimension - 1] == 0)
          mesh.coordinates[first + dimension - 1] = k * mesh.coordinates[first] * mesh.coordinates[first];
      EXPECT_NEAR(area(Part(mesh), "bottom", 12), dimension == 2 ? arc : arc * breadth, 1e-11);
    }
}

TEST(SurfaceSidesTest, EachSideIsOwnedByOneRank) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements)
      for (const char* set : {"bottom", "surface"}) {
        const Mesh mesh = slanted(dimension, element);
        const Part part(mesh);
        double owned = 0;
        for_sides(part, set, 1, [&](const auto& sides) {
          for (std::size_t b = 0; b < sides.size(); ++b) owned += total(sides.owned(b));
        });
        EXPECT_EQ(part.sum(owned), static_cast<double>(side_set_named(mesh, set).sides.size())) << set;
      }
}

template <class SideElement>
std::size_t points(int count) {
  const Part part(slanted(static_cast<int>(SideElement::dimension) + 1, ContactElement::Q1C1));
  const SurfaceSides<SideElement> none(part.mesh, {}, part.pattern, count);
  EXPECT_EQ(none.size(), 0U);
  return none.quadrature().size();
}

TEST(SurfaceSidesTest, RicherSidesHaveMorePoints) {
  EXPECT_EQ(points<Line2>(0), 5U);
  EXPECT_EQ(points<LagrangeEdge<2>>(0), 5U);
  EXPECT_EQ(points<LagrangeEdge<3>>(0), 8U);
  EXPECT_EQ(points<HermiteEdge>(0), 8U);
  EXPECT_EQ(points<Quad4>(0), 25U);
  EXPECT_EQ(points<HermiteFace>(0), 64U);
  EXPECT_EQ(points<Line2>(3), 3U);
  EXPECT_EQ(points<HermiteFace>(3), 9U);
}

}  // namespace
}  // namespace ixos

// The lowest point of surfaces: at nodes and between them.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/contact_element.hpp"
#include "support/solids.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

/// A box whose bottom is 0.3 above the wall y = 0, in 3D z = 0; its faces have length 1.
std::unique_ptr<Model> box_model(int dimension, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {4, dimension == 2 ? 1.0 : 3.0, 1};
  shape.divisions = {4, dimension == 2 ? 1 : 3, 1};
  shape.lower = {0, dimension == 2 ? 0.3 : 0, 0.3};
  Mesh mesh = box(shape);
  test::give_contact_element(mesh, "bottom", element);
  return test::model_of(mesh, test::elastic(neo_hooke, 0.3), Inertia::None);
}

Interactions terms_of(const Model& model, bool curved) {
  const LocalMesh& mesh = model.mesh();
  HalfSpace wall;
  wall.normal = mesh.dimension == 2 ? std::array<double, 3>{0, 1, 0} : std::array<double, 3>{0, 0, 1};
  const auto& sides = mesh.side_sets[mesh.side_set("bottom")];
  const auto law = gap_law(VanDerWaals(2.5, 25));
  return curved ? make_curved_terms(mesh, sides, model.pattern(), law, flat_wall(wall), {})
                : make_surface_terms(mesh, sides, model.pattern(), law, flat_wall(wall), {});
}

/// The lowest point over all ranks; its place on the ranks that have it.
LowestPoint lowest(const Model& model, const std::vector<double>& u, bool curved) {
  LowestPoint point;
  for (const auto& term : terms_of(model, curved))
    if (const LowestPoint own = term->admissibility().lowest_point({u.data()}); own.gap < point.gap) point = own;
  const double gap = model.space().minimum(point.gap);
  if (point.gap > gap) point.place = {};
  point.gap = gap;
  return point;
}

const std::vector<ContactElement> elements = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                              ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                              ContactElement::Q2C4};

/// A displacement along the wall's normal.
template <class Function>
std::vector<double> raised(const Model& model, const Function& function) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> u = test::at_rest(model);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
    if (!mesh.is_derivative(node)) u[node * d + d - 1] = function(&mesh.coordinates[node * d]);
  return u;
}

TEST(LowestPointTest, ANodeBelowTheWallIsSeenWhereQuadraturePointsAreAboveIt) {
  for (int dimension : {2, 3})
    for (bool curved : {false, true}) {
      const auto model = box_model(dimension, ContactElement::Q1C1);
      const auto u = raised(*model, [&](const double* x) {
        return std::hypot(x[0] - 2, dimension == 3 ? x[1] - 1 : 0.0) < 0.1 ? -0.315 : 0.7;
      });
      InteractionReport report;
      for (const auto& term : terms_of(*model, curved)) term->reports().report({u.data()}, report);
      EXPECT_GT(report.least_gap, 0);
      const LowestPoint point = lowest(*model, u, curved);
      EXPECT_NEAR(point.gap, -0.015, 1e-15);
      if (point.place == std::array<double, 3>{}) continue;
      EXPECT_NEAR(point.place[0], 2, 1e-15);
      EXPECT_NEAR(point.place[static_cast<std::size_t>(dimension) - 1], -0.015, 1e-15);
    }
}

TEST(LowestPointTest, EnrichedSidesAreLowestBetweenTheirNodes) {
  // 0.3 + (x - 1.5)^2/5 - 0.31 on the side from 1 to 2, whose middle is a node of Q1C2 and Q1C4 and none of Q1C3.
  for (int dimension : {2, 3})
    for (ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4}) {
      const auto model = box_model(dimension, element);
      const auto u = raised(*model, [](const double* x) { return (x[0] - 1.5) * (x[0] - 1.5) / 5 - 0.31; });
      for (bool curved : {false, true}) {
        const LowestPoint point = lowest(*model, u, curved);
        EXPECT_NEAR(point.gap, -0.01, 1e-14);
        if (point.place == std::array<double, 3>{}) continue;
        EXPECT_NEAR(point.place[0], 1.5, 1e-14);
      }
    }
}

TEST(LowestPointTest, FlatAndCurvedPathsAgree) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements) {
      const auto model = box_model(dimension, element);
      std::vector<double> u(test::at_rest(*model));
      const LocalMesh& mesh = model->mesh();
      const auto d = static_cast<std::size_t>(dimension);
      for (std::size_t k = 0; k < u.size(); ++k)
        u[k] = 0.2 * std::sin(3.0 * mesh.original_ids[k / d] + static_cast<double>(k % d));
      EXPECT_NEAR(lowest(*model, u, false).gap, lowest(*model, u, true).gap, 1e-14);
    }
}

}  // namespace
}  // namespace ixos

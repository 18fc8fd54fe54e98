// Triangles, tetrahedra, prisms and pyramids: order of convergence, conservation, explicit steps, bodies of revolution.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/state_report.hpp"
#include "support/comparison.hpp"
#include "support/simplices.hpp"
#include "support/solids.hpp"
#include "support/tied_bodies.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A unit square or cube of split cells; inner nodes of quadratic ones are moved by a share of their size, and their
/// edges are bent.
Mesh unit_body(int dimension, const std::string& kind, int divisions, int order, bool bubbles) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {divisions, divisions, divisions};
  if (kind.find("hexahedra") == 0) shape.lower[0] = -0.5;  // kinds are split at x = 0
  Mesh mesh = test::split_cells(box(shape), kind);
  if (shape.lower[0] < 0)
    for (std::size_t k = 0; k < mesh.coordinates.size(); k += 3) mesh.coordinates[k] += 0.5;
  if (order == 2) test::distort(mesh, 0.1 / divisions);
  if (order == 2) raise_order(mesh);
  if (order == 2) test::bend(mesh, 0.02);
  if (bubbles) add_bubbles(mesh);
  return mesh;
}

double order_of(int dimension, const std::string& kind, int coarse, int order, bool bubbles, double nu = 0.3) {
  Material material = test::elastic(linear_elastic, nu);
  if (bubbles) material.formulation = Formulation::MeanDilatation;
  const auto error = [&](int divisions) {
    return test::squared_error(unit_body(dimension, kind, divisions, order, bubbles), test::harmonic(dimension),
                               material);
  };
  return std::log2(error(coarse) / error(2 * coarse)) / 2;
}

// The exact displacement changes no volume, so it is that of each Poisson's ratio.
TEST(SimplicesTest, ErrorsFallWithTheOrderOfTheCells) {
  EXPECT_GT(order_of(2, "triangles", 8, 1, false), 1.8);
  EXPECT_GT(order_of(2, "triangles", 4, 2, false), 2.7);
  for (const double nu : {0.3, 0.4999}) {
    EXPECT_GT(order_of(2, "triangles", 4, 2, true, nu), 2.7) << nu;
    EXPECT_GT(order_of(2, "quads and triangles", 4, 2, true, nu), 2.7) << nu;
  }
  EXPECT_GT(order_of(3, "tetrahedra", 6, 1, false), 1.7);
  for (const char* kind : {"tetrahedra", "prisms", "pyramids"}) {
    EXPECT_GT(order_of(3, kind, 2, 2, false), 2.6) << kind;
    EXPECT_GT(order_of(3, kind, 2, 2, true, 0.4999), 2.5) << kind;
  }
}

Mesh free_body(int dimension, const std::string& kind, bool bubbles) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 1, 1};
  shape.divisions = {4, 2, 1};
  Mesh mesh = test::split_cells(box(shape), kind);
  raise_order(mesh);
  if (bubbles) add_bubbles(mesh);
  return mesh;
}

TEST(SimplicesTest, EnergyAndMomentaAreKept) {
  test::expect_conserved(free_body(2, "triangles", false), energy_momentum(), 30, 1e-9, true);
  test::expect_conserved(free_body(3, "tetrahedra", false), energy_momentum(), 10, 1e-9, true);
  test::expect_conserved(free_body(3, "tetrahedra", false), average_vector_field(4, 5), 10, 1e-9, false);
  test::expect_conserved(free_body(3, "prisms", false), average_vector_field(4, 5), 10, 1e-9, false);
}

TEST(SimplicesLongTest, ErrorsOfMixedMeshesFallWithTheOrderOfTheCells) {
  EXPECT_GT(order_of(3, "hexahedra to tetrahedra", 4, 2, false), 2.6);
  EXPECT_GT(order_of(3, "hexahedra to tetrahedra", 4, 2, true, 0.4999), 2.6);
}

TEST(SimplicesLongTest, TenThousandStepsKeepTheEnergy) {
  test::expect_conserved(free_body(3, "tetrahedra", false), average_vector_field(4, 5), 10000, 1e-10, false);
  test::expect_conserved(free_body(2, "triangles", false), energy_momentum(), 10000, 1e-9, true);
}

/// The energy of a body that vibrates for so many explicit steps stays within this share.
void expect_bounded(const Mesh& mesh, int steps, double share) {
  const auto model = test::model_of(mesh, test::elastic(neo_hooke, 0.3), Inertia::Lumped);
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> u = test::at_rest(*model), v = u;
  for (std::size_t n = 0; n < u.size() / d; ++n) {
    const double* x = &model->mesh().coordinates[n * d];
    u[n * d] = 0.05 * std::sin(x[0]);
    v[n * d + 1] = 0.2 * x[0];
  }
  Integrator integrator = test::direct(*model, central_difference(0.5));
  integrator.initialize(u, v, 0);
  const auto energy = [&] {
    const StateReport report(*model, integrator.state());
    return report.momenta().kinetic_energy + report.elastic_energy();
  };
  const double first = energy();
  const double step = integrator.stable_step(1e9);
  for (int k = 0; k < steps; ++k) {
    ASSERT_TRUE(integrator.step(step).converged);
    if (k % 100 == 0) {
      ASSERT_NEAR(energy(), first, share * first) << k;
    }
  }
}

TEST(SimplicesLongTest, AHundredThousandExplicitStepsKeepTheEnergyBounded) {
  expect_bounded(free_body(2, "triangles", true), 100000, 0.02);
  expect_bounded(free_body(3, "tetrahedra", true), 100000, 0.02);
}

TEST(SimplicesTest, ExplicitStepsKeepTheEnergyBounded) {
  expect_bounded(free_body(2, "triangles", true), 2000, 0.02);
  expect_bounded(free_body(3, "tetrahedra", true), 500, 0.02);
}

}  // namespace
}  // namespace ixos

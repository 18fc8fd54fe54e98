// Bodies with hanging nodes: affine motions, conservation, solvers and ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "discretization/volume_squares.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "mesh/tied_nodes.hpp"
#include "model/state_report.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "support/comparison.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A box of 3 by 3 (by 3) cells, those in a corner of the bottom split twice, those in the middle once, and some in one
/// direction; inner nodes that are not tied are moved off the grid.
Mesh refined_box(int dimension, ContactElement element, bool distorted = true) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 3, 3};
  shape.divisions = {3, 3, 3};
  Mesh mesh = box(shape);
  if (test::is_of_quadratic_cells(element)) raise_order(mesh);
  RefinedRegion corner, middle, film;
  corner.levels = 2;
  corner.lower.assign(static_cast<std::size_t>(dimension), -1);
  corner.upper.assign(static_cast<std::size_t>(dimension), 0.3);
  middle.lower.assign(static_cast<std::size_t>(dimension), 1.4);
  middle.upper.assign(static_cast<std::size_t>(dimension), 1.6);
  film.directions = "x";
  film.lower.assign(static_cast<std::size_t>(dimension), 2.4);
  refine(mesh, {{"corner", corner}, {"middle", middle}, {"film", film}}, test::is_of_quadratic_cells(element) ? 2 : 1);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()) && distorted; ++n) {
    bool inside = true;
    for (std::size_t i = 0; i < d; ++i)
      inside = inside && mesh.coordinates[n * d + i] > 1e-9 && mesh.coordinates[n * d + i] < 3 - 1e-9;
    for (std::size_t i = 0; i < d && inside; ++i)
      mesh.coordinates[n * d + i] += 0.03 * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(i));
  }
  place_tied_nodes(mesh);
  enrich(mesh, "bottom", element);
  return mesh;
}

Integrator integrator_of(Model& model, const Table& table, bool matrix_free) {
  if (!matrix_free) return test::direct(model, table);
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Chebyshev").set("Operator", "Matrix-Free");
  return Integrator(model, table, std::make_shared<LinearSolverFactory>(completed_linear_solver(linear, {})), {});
}

void run_patch(int dimension, const Table& table, ContactElement element, Formulation formulation, bool matrix_free) {
  Material rubber = test::elastic(neo_hooke, 0.3);
  rubber.formulation = formulation;
  const auto model = test::model_of(refined_box(dimension, element), rubber, Inertia::Consistent);
  const LocalMesh& local = model->mesh();
  ASSERT_GT(local.global_tied, 0);
  const auto d = static_cast<std::size_t>(dimension);
  const double g[3][3] = {{0.2, -0.1, 0.05}, {0.15, -0.12, 0.1}, {-0.05, 0.08, 0.1}};
  std::vector<double> velocity(static_cast<std::size_t>(model->space().local()), 0.0);
  for (std::size_t n = 0; n < velocity.size() / d; ++n)
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) velocity[n * d + i] += g[i][j] * local.coordinates[n * d + j];
  const auto unit_rate = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);  // u = t
  for (const int node : local.node_sets[local.node_set("surface")])
    for (int i = 0; i < dimension && !local.is_tied(node); ++i) {
      const int dof = node * dimension + i;
      model->constraints().add(dof, velocity[static_cast<std::size_t>(dof)], unit_rate);
    }
  Integrator integrator = integrator_of(*model, table, matrix_free);
  integrator.initialize(std::vector<double>(velocity.size(), 0.0), velocity, 0.0);
  for (int step = 0; step < 4; ++step) ASSERT_TRUE(integrator.step(0.25).converged) << table.name;
  const double tolerance = matrix_free ? 1e-8 : 1e-10;
  EXPECT_LT(test::distance(integrator.state().u, velocity), tolerance) << table.name << ", " << dimension << "D";
  EXPECT_LT(test::distance(integrator.state().v, velocity), tolerance) << table.name << ", " << dimension << "D";
}

TEST(HangingNodesTest, AffineMotionsAreReproduced) {
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C4, ContactElement::Q2C2, ContactElement::Q2C4}) {
    SCOPED_TRACE(static_cast<int>(element));
    run_patch(2, newmark(0.25, 0.5), element, Formulation::Standard, false);
    run_patch(2, average_vector_field(4, 8), element, Formulation::Standard, false);
    run_patch(3, average_vector_field(4, 8), element, Formulation::Standard, false);
  }
  run_patch(2, energy_momentum(), ContactElement::Q1C1, Formulation::Standard, false);
}

TEST(HangingNodesTest, AffineMotionsAreReproducedByFormulationsAgainstLocking) {
  for (const int dimension : {2, 3}) {
    run_patch(dimension, newmark(0.25, 0.5), ContactElement::Q1C1, Formulation::Enhanced, false);
    run_patch(dimension, newmark(0.25, 0.5), ContactElement::Q1C1, Formulation::MeanDilatation, false);
  }
}

TEST(HangingNodesTest, AffineMotionsAreReproducedMatrixFree) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2})
      run_patch(dimension, newmark(0.25, 0.5), element, Formulation::Standard, true);
}

/// Spins and stretches a free body.
std::vector<double> spin_and_stretch(const Model& model, std::vector<double>& velocity) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> u = test::at_rest(model);
  velocity = u;
  for (std::size_t n = 0; n < u.size() / d; ++n) {
    const double* x = &mesh.coordinates[n * d];
    if (mesh.is_derivative(n)) continue;
    u[n * d] = 0.1 * std::sin(x[0]);
    u[n * d + 1] = 0.05 * x[0] * x[1] / 3;
    velocity[n * d] = 0.3 - 0.2 * x[1];
    velocity[n * d + 1] = 0.2 * x[0];
    if (d == 3) velocity[n * d + 2] = 0.1 * x[0];
  }
  model.space().interpolate_tied(u.data());
  model.space().interpolate_tied(velocity.data());
  return u;
}

void expect_conserved(int dimension, ContactElement element, const Table& table, int steps, double tolerance,
                      bool angular = true) {
  const auto model =
      test::model_of(refined_box(dimension, element), test::elastic(neo_hooke, 0.3), Inertia::Consistent);
  std::vector<double> velocity;
  const std::vector<double> u = spin_and_stretch(*model, velocity);
  Integrator integrator = test::direct(*model, table);
  integrator.initialize(u, velocity, 0.0);
  const auto report = [&] { return StateReport(*model, integrator.state()); };
  const Momenta before = report().momenta();
  const double energy = before.kinetic_energy + report().elastic_energy();
  for (int step = 0; step < steps; ++step) ASSERT_TRUE(integrator.step(0.1).converged) << table.name;
  const Momenta after = report().momenta();
  EXPECT_NEAR(after.kinetic_energy + report().elastic_energy(), energy, tolerance * energy) << table.name;
  for (std::size_t i = 0; i < before.linear.size(); ++i)
    EXPECT_NEAR(after.linear[i], before.linear[i], tolerance * 10) << table.name;
  for (std::size_t i = 0; i < before.angular.size() && angular; ++i)
    EXPECT_NEAR(after.angular[i], before.angular[i], tolerance * 10) << table.name;
}

TEST(HangingNodesTest, EnergyMomentumConservesBothMomentaAndEnergy) {
  expect_conserved(2, ContactElement::Q1C1, energy_momentum(), 50, 1e-9);
  expect_conserved(2, ContactElement::Q2C2, energy_momentum(), 20, 1e-9);
  expect_conserved(3, ContactElement::Q1C1, energy_momentum(), 5, 1e-9);
}

/// The integral of the squared error of a harmonic displacement, u = grad(exp(kx) cos y [cos z]), which solves the
/// equations of any linear material without a load, over that of the displacement.
double squared_error(int dimension, int order, int halvings) {
  BoxShape shape;
  shape.dimension = dimension;
  const int n = 2 << halvings;
  shape.divisions = {n, n, n};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  RefinedRegion corner;  // one level: with more, the coarsest mesh has hardly a coarse cell left
  corner.lower.assign(static_cast<std::size_t>(dimension), 0.6);
  refine(mesh, {{"corner", corner}}, order);
  const auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.3), Inertia::None);
  const LocalMesh& local = model->mesh();
  const auto d = static_cast<std::size_t>(dimension);
  const double k = std::sqrt(dimension - 1.0);
  const auto exact = [&](const double* x, std::size_t i) {
    const double z = d == 3 ? x[2] : 0, e = std::exp(k * x[0]);
    if (i == 0) return k * e * std::cos(x[1]) * std::cos(z);
    return i == 1 ? -e * std::sin(x[1]) * std::cos(z) : -e * std::cos(x[1]) * std::sin(z);
  };
  const auto once = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);
  for (const int node : local.node_sets[local.node_set("surface")])
    for (std::size_t i = 0; i < d && !local.is_tied(node); ++i)
      model->constraints().add(node * dimension + static_cast<int>(i),
                               exact(&local.coordinates[static_cast<std::size_t>(node) * d], i), once);
  Integrator integrator = test::direct(*model, static_equilibrium());
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0.0);
  EXPECT_TRUE(integrator.step(1.0).converged);
  std::vector<std::vector<double>> error(d), whole(d);
  for (std::size_t node = 0; node < static_cast<std::size_t>(local.nodes()); ++node)
    for (std::size_t i = 0; i < d; ++i) {
      const double u = exact(&local.coordinates[node * d], i);
      error[i].push_back(integrator.state().u[node * d + i] - u);
      whole[i].push_back(u);
    }
  double sums[] = {nodal_square(local, error), nodal_square(local, whole)};
  model->space().sum(sums, 2);
  return sums[0] / sums[1];
}

TEST(HangingNodesTest, ErrorsFallWithTheOrderOfTheCells) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      const int first = dimension == 2 ? 1 : 0;
      const double coarse = squared_error(dimension, order, first), fine = squared_error(dimension, order, first + 1);
      EXPECT_GT(std::log2(coarse / fine) / 2, order + 0.75) << dimension << "D, order " << order;
    }
}

TEST(HangingNodesLongTest, EnergyAndMomentaLast) {
  expect_conserved(2, ContactElement::Q1C1, energy_momentum(), 10000, 1e-9);
  expect_conserved(2, ContactElement::Q2C2, energy_momentum(), 10000, 1e-9);
  expect_conserved(2, ContactElement::Q1C1, average_vector_field(4, 8), 10000, 1e-7, false);
}

}  // namespace
}  // namespace ixos

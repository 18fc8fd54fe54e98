#include "support/tied_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "discretization/volume_squares.hpp"
#include "material/elastic_law.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "model/state_report.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos::test {
namespace {

/// A box whose inner nodes, and those of its sides at height 1, are off the grid.
Mesh distorted_box(int dimension, double bottom, int along, int order, const std::string& kind = "",
                   bool bubbles = false) {
  const auto d = static_cast<std::size_t>(dimension);
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower[d - 1] = bottom;
  shape.lengths = {3, 3, 3};
  shape.lengths[d - 1] = 1;
  shape.divisions = {along, along, along};
  shape.divisions[d - 1] = 2;
  Mesh mesh = box(shape);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()); ++n) {
    double* const x = &mesh.coordinates[n * d];
    bool inside = true;
    for (std::size_t i = 0; i + 1 < d; ++i) inside = inside && x[i] > 1e-9 && x[i] < 3 - 1e-9;
    const bool meets = std::abs(x[d - 1] - 1) < 1e-9;
    inside = inside && (meets || (x[d - 1] > bottom + 1e-9 && x[d - 1] < bottom + 1 - 1e-9));
    for (std::size_t i = 0; inside && i < (meets ? d - 1 : d); ++i)
      x[i] += 0.08 * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(i));
  }
  if (!kind.empty()) mesh = split_cells(mesh, kind);
  if (order == 2) raise_order(mesh, bubbles);
  return mesh;
}

/// Joins the boxes.
Mesh stacked(int dimension, const Mesh& lower, const Mesh& upper) {
  Mesh mesh = joined_parts({{"lower", lower}, {"upper", upper}});
  for (ElementBlock& block : mesh.blocks) block.name = "body";
  const auto d = static_cast<std::size_t>(dimension);
  NodeSet outer{"outer", {}};
  for (int node = 0; node < mesh.nodes(); ++node)
    for (std::size_t i = 0; i < d; ++i) {
      const double x = mesh.coordinates[static_cast<std::size_t>(node) * d + i], end = i + 1 == d ? 2 : 3;
      if (x > 1e-9 && x < end - 1e-9) continue;
      outer.nodes.push_back(node);
      break;
    }
  mesh.node_sets.push_back(outer);
  return mesh;
}

Integrator integrator_of(Model& model, const Table& table, bool matrix_free) {
  if (!matrix_free) return direct(model, table);
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Chebyshev").set("Operator", "Matrix-Free");
  return Integrator(model, table, std::make_shared<LinearSolverFactory>(completed_linear_solver(linear, {})), {});
}

/// Spins and stretches a free body.
std::vector<double> spin_and_stretch(const Model& model, std::vector<double>& velocity) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> u = at_rest(model);
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

}  // namespace

Mesh stacked_boxes(int dimension, int order) {
  return stacked(dimension, distorted_box(dimension, 0, 3, order),
                 distorted_box(dimension, 1, dimension == 2 ? 5 : 4, order));
}

Mesh stacked_boxes(const StackedCells& cells) {
  return stacked(3, distorted_box(3, 0, 3, cells.order, cells.lower, cells.bubbles),
                 distorted_box(3, 1, 4, cells.order, cells.upper, cells.bubbles));
}

std::vector<StackedCells> stacked_triangles() {
  return {{"tetrahedra", ""},           {"", "tetrahedra"},
          {"tetrahedra", "tetrahedra"}, {"prisms", "hexahedra and prisms"},
          {"tetrahedra", "", 2},        {"tetrahedra", "tetrahedra", 2, true},
          {"", "prisms", 2, true}};
}

void expect_affine_motion(const Mesh& mesh, const Material& material, const std::string& node_set, const Table& table,
                          bool matrix_free) {
  const auto model = model_of(mesh, material, Inertia::Consistent);
  const LocalMesh& local = model->mesh();
  const int dimension = mesh.dimension;
  ASSERT_GT(local.global_tied, 0);
  const auto d = static_cast<std::size_t>(dimension);
  const double g[3][3] = {{0.2, -0.1, 0.05}, {0.15, -0.12, 0.1}, {-0.05, 0.08, 0.1}};
  std::vector<double> velocity(static_cast<std::size_t>(model->space().local()), 0.0);
  for (std::size_t n = 0; n < velocity.size() / d; ++n)
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) velocity[n * d + i] += g[i][j] * local.coordinates[n * d + j];
  const auto unit_rate = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);  // u = t
  for (const int node : local.node_sets[local.node_set(node_set)])
    for (int i = 0; i < dimension && !local.is_tied(node); ++i) {
      const int dof = node * dimension + i;
      model->constraints().add(dof, velocity[static_cast<std::size_t>(dof)], unit_rate);
    }
  Integrator integrator = integrator_of(*model, table, matrix_free);
  integrator.initialize(std::vector<double>(velocity.size(), 0.0), velocity, 0.0);
  for (int step = 0; step < 4; ++step) ASSERT_TRUE(integrator.step(0.25).converged) << table.name;
  const double tolerance = matrix_free ? 1e-8 : 1e-10;
  EXPECT_LT(distance(integrator.state().u, velocity), tolerance) << table.name << ", " << dimension << "D";
  EXPECT_LT(distance(integrator.state().v, velocity), tolerance) << table.name << ", " << dimension << "D";
}

void expect_conserved(const Mesh& mesh, const Table& table, int steps, double tolerance, bool angular) {
  const auto model = model_of(mesh, elastic(neo_hooke, 0.3), Inertia::Consistent);
  std::vector<double> velocity;
  const std::vector<double> u = spin_and_stretch(*model, velocity);
  Integrator integrator = direct(*model, table);
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

Displacement harmonic(int dimension) {
  return [dimension, k = std::sqrt(dimension - 1.0)](const double* x, std::size_t i) {
    const double z = dimension == 3 ? x[2] : 0, e = std::exp(k * x[0]);
    if (i == 0) return k * e * std::cos(x[1]) * std::cos(z);
    return i == 1 ? -e * std::sin(x[1]) * std::cos(z) : -e * std::cos(x[1]) * std::sin(z);
  };
}

double squared_error(const Mesh& mesh, const Displacement& exact) {
  return squared_error(mesh, exact, elastic(linear_elastic, 0.3));
}

double squared_error(const Mesh& mesh, const Displacement& exact, const Material& material) {
  const auto model = model_of(mesh, material, Inertia::None);
  const int dimension = mesh.dimension;
  const LocalMesh& local = model->mesh();
  const auto d = static_cast<std::size_t>(dimension);
  const auto once = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);
  std::vector<std::vector<double>> error(d), whole(d);
  for (int node = 0; node < local.nodes(); ++node) {
    const double* const x = &local.coordinates[static_cast<std::size_t>(node) * d];
    bool outside = false;
    for (std::size_t i = 0; i < d; ++i) outside = outside || x[i] < 1e-9 || x[i] > 1 - 1e-9;
    for (std::size_t i = 0; i < d && outside && !local.is_tied(node); ++i)
      model->constraints().add(node * dimension + static_cast<int>(i), exact(x, i), once);
  }
  // Bulk stiffness costs digits of the forces.
  const Lame lame = material.law->lame();
  Integrator integrator =
      direct(*model, static_equilibrium(), lame.lambda < 10 * lame.mu ? NewtonOptions().tolerance : 1e-8);
  integrator.initialize(at_rest(*model), at_rest(*model), 0.0);
  EXPECT_TRUE(integrator.step(1.0).converged);
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

}  // namespace ixos::test

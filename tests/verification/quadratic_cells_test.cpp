// Quadratic cells: order of convergence, energy of a ball that bounces, explicit steps, results on several ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

using Point = std::array<double, 3>;

/// The gradient of exp(x) sin(y) in the plane, of exp(x) sin(0.6 y) sin(0.8 z) in space. These functions are harmonic:
/// without body forces the displacement is in equilibrium whatever the elastic constants are.
Point exact(const Point& x, int dimension) {
  const double e = std::exp(x[0]);
  if (dimension == 2) return {e * std::sin(x[1]), e * std::cos(x[1]), 0};
  const double s = std::sin(0.6 * x[1]), c = std::cos(0.6 * x[1]), t = std::sin(0.8 * x[2]), b = std::cos(0.8 * x[2]);
  return {e * s * t, 0.6 * e * c * t, 0.8 * e * s * b};
}

Point place_of(const LocalMesh& mesh, std::size_t node) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  Point x{};
  for (std::size_t i = 0; i < d; ++i) x[i] = mesh.coordinates[node * d + i];
  return x;
}

/// A unit box under a smooth map that bends the cells.
Mesh bent_box(int dimension, int order, int divisions, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {divisions, divisions, divisions};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  enrich(mesh, "bottom", element);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += d) {
    double* x = &mesh.coordinates[k];
    const double bend = 0.08 * std::sin(2 * x[0] + 3 * x[1]);
    x[0] += bend;
    x[d - 1] -= 0.5 * bend;
  }
  return mesh;
}

/// The square of the difference from the exact displacement, integrated over the cells that this rank counts.
template <class Element>
double squared_error(const LocalMesh& mesh, const LocalBlock& block, const std::vector<double>& u) {
  constexpr std::size_t D = Element::dimension;
  std::array<int, D> points;
  points.fill(5);
  const ShapeTable<Element> table(product_rule(points));
  double sum = 0;
  for (int cell = 0; cell < block.cells(); ++cell) {
    if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
    const int* nodes = &block.nodes[cell_entry(cell, Element::nodes)];
    for (std::size_t q = 0; q < table.size(); ++q) {
      Point x{}, value{};
      for (std::size_t a = 0; a < static_cast<std::size_t>(Element::nodes); ++a)
        for (std::size_t i = 0; i < D; ++i) {
          x[i] += table.value[q][a] * mesh.coordinates[static_cast<std::size_t>(nodes[a]) * D + i];
          value[i] += table.value[q][a] * u[static_cast<std::size_t>(nodes[a]) * D + i];
        }
      const Point right = exact(x, static_cast<int>(D));
      const double volume =
          determinant(jacobian<D>(mesh.coordinates, nodes, cell_scales<Element>(block, cell), table.gradient[q]));
      for (std::size_t i = 0; i < D; ++i)
        sum += table.weight[q] * volume * (value[i] - right[i]) * (value[i] - right[i]);
    }
  }
  return sum;
}

/// The L2 norm of the error of a static solution whose boundary has the exact displacement.
double static_error(int dimension, int order, int divisions, Formulation formulation = Formulation::Standard,
                    ContactElement element = ContactElement::Q1C1, double nu = 0.3) {
  Material material = test::elastic(linear_elastic, nu);
  material.formulation = formulation;
  const auto model = test::model_of(bent_box(dimension, order, divisions, element), material, Inertia::None);
  const LocalMesh& mesh = model->mesh();
  for (const int node : mesh.node_sets[mesh.node_set("surface")]) {
    const Point u = exact(place_of(mesh, static_cast<std::size_t>(node)), dimension);
    for (int i = 0; i < dimension; ++i)
      model->constraints().add(dimension * node + i, u[static_cast<std::size_t>(i)],
                               rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
  }
  // Bulk stiffness costs digits of the forces.
  Integrator integrator = test::direct(*model, static_equilibrium(), nu < 0.4 ? NewtonOptions().tolerance : 1e-8);
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0.0);
  EXPECT_TRUE(integrator.step(1.0).converged);
  double sum = 0;
  for (const LocalBlock& block : mesh.blocks)
    sum += with_element(block.type, [&](auto tag) {
      return squared_error<typename decltype(tag)::type>(mesh, block, integrator.state().u);
    });
  model->space().sum(&sum, 1);
  return std::sqrt(sum);
}

TEST(QuadraticCellsTest, DisplacementsConvergeWithTheThirdPower) {
  EXPECT_NEAR(std::log2(static_error(2, 2, 4) / static_error(2, 2, 8)), 3, 0.15);
  EXPECT_NEAR(std::log2(static_error(2, 1, 8) / static_error(2, 1, 16)), 2, 0.15);
  EXPECT_NEAR(std::log2(static_error(3, 2, 2) / static_error(3, 2, 4)), 3, 0.25);
  // With the nodes of linear cells they are far better.
  EXPECT_LT(static_error(2, 2, 8), 0.15 * static_error(2, 1, 16));
  EXPECT_LT(static_error(3, 2, 4), 0.3 * static_error(3, 1, 8));
}

// The exact displacement changes no volume, so it is that of each Poisson's ratio, and the error hardly depends on it.
TEST(QuadraticCellsTest, WithMeanDilatationTheyConvergeWithTheThirdPowerAtEachPoissonsRatio) {
  for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C4}) {
    const auto error = [&](int dimension, int divisions, double nu) {
      return static_error(dimension, 2, divisions, Formulation::MeanDilatation, element, nu);
    };
    const double fine = error(2, 8, 0.3), stiff = error(2, 8, 0.4999);
    EXPECT_NEAR(std::log2(error(2, 4, 0.3) / fine), 3, 0.25);
    EXPECT_NEAR(std::log2(error(2, 4, 0.4999) / stiff), 3, 0.25);
    EXPECT_LT(stiff, 1.5 * fine);
    EXPECT_NEAR(std::log2(error(3, 2, 0.3) / error(3, 4, 0.3)), 3, 0.4);
  }
  EXPECT_LT(static_error(2, 2, 8, Formulation::MeanDilatation), 1.5 * static_error(2, 2, 8));
}

// A contact side of fourth order conforms: it spoils no order, and does not add to the error.
TEST(QuadraticCellsTest, ContactSidesOfFourthOrderKeepTheOrder) {
  const auto error = [](int dimension, int divisions) {
    return static_error(dimension, 2, divisions, Formulation::Standard, ContactElement::Q2C4);
  };
  EXPECT_NEAR(std::log2(error(2, 4) / error(2, 8)), 3, 0.2);
  EXPECT_LT(error(2, 8), static_error(2, 2, 8));
  EXPECT_NEAR(std::log2(error(3, 2) / error(3, 4)), 3, 0.3);
}

/// A ball of rubber, in the plane or of revolution, that falls on to a wall; a cube in space.
std::string falling(const std::string& kind, const std::string& scheme, double step,
                    const std::string& element = "Q2C2", const std::string& formulation = "Standard") {
  const bool solid = kind == "cube", round = kind == "Axisymmetric";
  const std::string body =
      solid ? word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lower", {0, 0, 0.5}) +
                                                    numbers("Lengths", {1.5, 1, 1}) + counts("Divisions", {2, 1, 1}))
            : word("Type", "Disk") + word("Geometry", round ? "Axisymmetric" : "Plane Strain") +
                  list("Disk", number("Diameter", 2) + numbers("Center", {0, 1.4}) + count("Core Divisions", 2) +
                                   count("Rings", 2) + "<Parameter name=\"Half\" type=\"bool\" value=\"" +
                                   (round ? "true" : "false") + "\"/>");
  const std::vector<double> velocity = solid   ? std::vector<double>{0.1, 0, -0.5}
                                       : round ? std::vector<double>{0, -0.5}
                                               : std::vector<double>{0.1, -0.5};
  return list("Mesh", count("Cell Order", 2) + body) +
         list("Materials", list("Rubber", number("Density", 1) + word("Element Formulation", formulation))) +
         list("Interactions",
              list("Wall", word("Side Set", solid ? "bottom" : "surface") + word("Contact Element", element) +
                               numbers("Point", solid ? std::vector<double>{0, 0, 0} : std::vector<double>{0, 0}))) +
         list("Initial Conditions", numbers("Velocity", velocity)) +
         test::time_integrator(
             scheme, step, 4,
             scheme == "Average Vector Field" ? count("Elastic Points", 12) + count("Interaction Points", 0) : "");
}

/// Bodies and their contact elements.
std::vector<std::pair<std::string, std::string>> kinds() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const char* kind : {"Plane Strain", "Axisymmetric", "cube"})
    for (const char* element : {"Q2C2", "Q2C4"}) all.emplace_back(kind, element);
  return all;
}

void expect_energy_of_a_bounce(const std::string& kind, const std::string& element, const std::string& formulation) {
  Simulation s(test::scene(falling(kind, "Average Vector Field", 0.05, element, formulation)), world());
  const double energy = test::total_energy(s);
  double error = 0, stored = 0, before = 0;
  for (int step = 0; step < 60; ++step) {
    ASSERT_TRUE(s.integrator().step(0.05).converged) << kind << ' ' << step;
    error = std::max(error, std::abs(test::total_energy(s) - energy));
    const Momenta momenta = test::report_of(s).momenta();
    const std::size_t up = kind == "cube" ? 2 : 1;
    before = std::min(before, momenta.linear[up]);
    stored = std::max(stored, test::report_of(s).energy(Part::Elastic));
  }
  EXPECT_LT(error, 1e-9) << kind << ' ' << formulation;
  EXPECT_GT(stored, 1e-3) << kind << ": the body was not deformed";
  EXPECT_LT(before, -0.1) << kind;
}

TEST(QuadraticCellsTest, AverageVectorFieldKeepsTheEnergyOfABallThatBounces) {
  for (const auto& [kind, element] : kinds()) expect_energy_of_a_bounce(kind, element, "Standard");
  expect_energy_of_a_bounce("Plane Strain", "Q2C4", "Mean Dilatation");
  expect_energy_of_a_bounce("Axisymmetric", "Q2C2", "Mean Dilatation");
  expect_energy_of_a_bounce("cube", "Q2C2", "Mean Dilatation");
}

void expect_stable_explicit_steps(const std::string& kind, const std::string& element, const std::string& formulation) {
  Simulation quick(test::scene(falling(kind, "Central Difference", 0.01, element, formulation)), world());
  Simulation slow(test::scene(falling(kind, "Newmark", 0.002, element, formulation)), world());
  const double longest = quick.integrator().stable_step(0.01);
  EXPECT_GT(longest, 0.0) << kind;
  const double energy = test::total_energy(quick), step = 0.5 * std::min(longest, 0.004);
  const int steps = static_cast<int>(std::ceil(0.6 / step));
  for (int k = 0; k < steps; ++k) ASSERT_TRUE(quick.integrator().step(0.6 / steps).converged) << kind;
  for (int k = 0; k < 300; ++k) ASSERT_TRUE(slow.integrator().step(0.002).converged) << kind;
  EXPECT_NEAR(test::total_energy(quick), energy, 2e-3 * std::abs(energy)) << kind;
  // Lumped and consistent masses differ by the discretisation.
  const std::vector<double> u = test::gathered(quick.model(), quick.integrator().state().u);
  const std::vector<double> v = test::gathered(slow.model(), slow.integrator().state().u);
  EXPECT_LT(test::distance(u, v), 0.05) << kind;
}

TEST(QuadraticCellsTest, ExplicitStepsAreStableAndFollowImplicitOnes) {
  for (const auto& [kind, element] : kinds()) expect_stable_explicit_steps(kind, element, "Standard");
  expect_stable_explicit_steps("Plane Strain", "Q2C2", "Mean Dilatation");
}

TEST(QuadraticCellsTest, RanksShareOneResult) {
  for (const auto& [kind, element] : kinds()) {
    if (kind == "Axisymmetric") continue;
    Simulation shared(test::scene(falling(kind, "Average Vector Field", 0.05, element)), world());
    Simulation alone(test::scene(falling(kind, "Average Vector Field", 0.05, element)), test::self());
    for (int step = 0; step < 20; ++step) {
      ASSERT_TRUE(shared.integrator().step(0.05).converged);
      ASSERT_TRUE(alone.integrator().step(0.05).converged);
    }
    const std::vector<double> u = test::gathered(shared.model(), shared.integrator().state().u);
    const std::vector<double> v = test::gathered(alone.model(), alone.integrator().state().u);
    ASSERT_EQ(u.size(), v.size());
    EXPECT_LT(test::distance(u, v), 1e-9) << kind;
  }
}

// The lumped mass of curved cells and of rings is not int N_a dV; gravity acts on what the scheme divides by.
TEST(QuadraticCellsTest, AllNodesOfABodyFallAlike) {
  Simulation s(
      test::scene(list("Mesh", word("Type", "Disk") + word("Geometry", "Axisymmetric") + count("Cell Order", 2) +
                                   list("Disk", "<Parameter name=\"Half\" type=\"bool\" value=\"true\"/>")) +
                  list("Materials", list("Ball", number("Density", 3))) +
                  list("Boundary Conditions", list("Weight", word("Type", "Gravity") + numbers("Vector", {0, -0.5}))) +
                  test::time_integrator("Central Difference", 0.01, 1)),
      world());
  double time = 0;
  for (int n = 0; n < 100; ++n) {
    const StepResult result = s.integrator().step(0.001);
    ASSERT_TRUE(result.converged);
    time += 0.001;
  }
  const State& state = s.integrator().state();
  for (std::size_t i = 0; i < state.u.size(); ++i)
    ASSERT_NEAR(state.u[i], i % 2 == 0 ? 0 : -0.25 * time * time, 1e-13) << i;
}

}  // namespace
}  // namespace ixos

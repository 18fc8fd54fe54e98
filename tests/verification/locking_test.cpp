// Locking and its cures where it shows: Cook's membrane, nearly incompressible, and slender cantilevers.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "mesh/generators.hpp"
#include "model/nodal_measure.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::world;

struct Problem {
  Mesh mesh;
  Material material;
  double load;        ///< on the side set "right", along the last axis
  std::size_t probe;  ///< a node of the mesh
  int steps = 1;
};

/// Displacement of the probe along the last axis, "left" clamped.
double deflection(const Problem& problem, Formulation formulation) {
  Material material = problem.material;
  material.density = 1.0;
  material.formulation = formulation;
  const auto built = test::model_of(problem.mesh, material, Inertia::None);
  Model& model = *built;
  const LocalMesh& local = model.mesh();
  const int d = local.dimension;
  for (int node : local.node_sets[local.node_set("left")])
    for (int i = 0; i < d; ++i) model.constraints().add(node * d + i, 0.0, nullptr);
  std::vector<double> measure(static_cast<std::size_t>(local.nodes()), 0.0);
  add_side_measure(local, local.side_sets[local.side_set("right")], measure);
  double area = 0;
  for (int node = 0; node < local.owned_nodes; ++node) area += measure[static_cast<std::size_t>(node)];
  model.space().sum(&area, 1);
  const auto size = static_cast<std::size_t>(d);
  std::vector<double> forces(measure.size() * size, 0.0);
  for (std::size_t node = 0; node < measure.size(); ++node)
    forces[node * size + size - 1] = measure[node] * problem.load / area;
  model.loads().add(std::move(forces), value_ramp(1.0, 0.0, 1.0, RampShape::Linear));
  Integrator integrator = test::direct(model, static_equilibrium(), 1e-8);  // bulk stiffness costs digits
  integrator.initialize(test::at_rest(model), test::at_rest(model), 0.0);
  for (int step = 0; step < problem.steps; ++step) {
    const StepResult result = integrator.step(1.0 / problem.steps);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) return NAN;
  }
  return test::gathered(model, integrator.state().u)[problem.probe * size + size - 1];
}

/// Cook's membrane: corners (0, 0), (48, 44), (48, 60), (0, 44), sheared upwards on its right; the probe is the upper
/// right corner.
Problem membrane(int divisions, ElasticLaw law, const Lame& lame, double load, int steps = 1) {
  BoxShape shape;
  shape.divisions = {divisions, divisions, 1};
  Problem problem{box(shape), {}, load, 0, steps};
  std::vector<double>& place = problem.mesh.coordinates;
  for (std::size_t n = 0; n < place.size() / 2; ++n) {
    const double s = place[2 * n], t = place[2 * n + 1];
    if (s + t > 2 - 1e-9) problem.probe = n;
    place[2 * n] = 48 * s;
    place[2 * n + 1] = 44 * s + t * (44 - 28 * s);
  }
  problem.material.law = law;
  problem.material.lame = lame;
  return problem;
}

TEST(LockingVerification, CooksMembraneOfANearlyIncompressibleMaterial) {
  const Lame lame = lame_constants(1, 0.4999);
  const auto tip = [&](int divisions, Formulation formulation) {
    return deflection(membrane(divisions, ElasticLaw::Linear, lame, 1.0), formulation);
  };
  // The corner at the clamp is singular: first order at best.
  const double reference = tip(64, Formulation::Enhanced);
  EXPECT_NEAR(tip(64, Formulation::MeanDilatation), reference, 2e-3 * reference);
  for (Formulation cure : {Formulation::MeanDilatation, Formulation::Enhanced}) {
    double before = 0.3;
    for (int divisions : {4, 8, 16}) {
      const double error = 1 - tip(divisions, cure) / reference;
      EXPECT_GT(error, 0) << divisions;
      EXPECT_LT(error, 0.5 * before) << divisions;
      before = error;
    }
    EXPECT_LT(before, 0.02);
  }
  for (int divisions : {4, 8, 16}) EXPECT_LT(tip(divisions, Formulation::Standard), 0.35 * reference) << divisions;
}

TEST(LockingVerification, CooksMembraneAtLargeDisplacements) {
  const double mu = 80.1938;
  const auto tip = [&](int divisions, double nu, Formulation formulation) {
    const Lame lame{mu, mu * 2 * nu / (1 - 2 * nu)};
    return deflection(membrane(divisions, ElasticLaw::NeoHooke, lame, 100, 4), formulation);
  };
  for (double nu : {0.4, 0.49, 0.499}) {
    const double mean = tip(16, nu, Formulation::MeanDilatation);
    EXPECT_NEAR(tip(16, nu, Formulation::Enhanced), mean, 5e-3 * mean) << nu;
    EXPECT_LT(tip(16, nu, Formulation::Standard), (nu < 0.45 ? 0.99 : 0.9) * mean) << nu;
  }
  // Lambda = 5000 mu, where Newton's iteration of enhanced elements may break down.
  const double coarse = tip(16, 0.4999, Formulation::MeanDilatation);
  EXPECT_NEAR(tip(32, 0.4999, Formulation::MeanDilatation), coarse, 0.01 * coarse);
  EXPECT_LT(tip(16, 0.4999, Formulation::Standard), 0.4 * coarse);
}

/// A cantilever 20 by 1 by 1 of one element's thickness.
Problem cantilever(int dimension, int divisions, double nu) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {20, 1, 1};
  shape.divisions = {divisions, 1, 1};
  Problem problem{box(shape), {}, 1e-3, 0};
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < problem.mesh.coordinates.size() / d; ++n)
    if (problem.mesh.coordinates[n * d] > 20 - 1e-9) problem.probe = n;
  problem.material.law = ElasticLaw::Linear;
  problem.material.lame = lame_constants(1, nu);
  return problem;
}

// Bernoulli's and Timoshenko's: P L^3/(3 E I) + P L/(kappa G A), kappa = 10 (1 + nu)/(12 + 11 nu) (Cowper 1966).
TEST(LockingVerification, CantileversOfOneElementsThickness) {
  for (int dimension : {2, 3})
    for (double nu : {0.0, 0.3}) {
      const double modulus = dimension == 2 ? 1 / (1 - nu * nu) : 1, shear = 1 / (2 * (1 + nu));
      const double correction = 10 * (1 + nu) / (12 + 11 * nu);
      const double theory = 1e-3 * (8000 / (3 * modulus / 12) + 20 / (correction * shear));
      const auto ratio = [&](int elements, Formulation formulation) {
        return deflection(cantilever(dimension, elements, nu), formulation) / theory;
      };
      // Constant curvature in each of n elements: 1 - 1/(4 n^2), and what the clamp holds of the lateral contraction.
      const double clamp = nu == 0 ? 1e-3 : dimension == 2 ? 2e-3 : 0.025;
      for (int n : {5, 10, 20}) EXPECT_NEAR(ratio(n, Formulation::Enhanced), 1 - 0.25 / (n * n), clamp) << nu;
      // Parasitic shear; and a single layer without volumetric stiffness is too soft where elements are short.
      EXPECT_LT(ratio(5, Formulation::Standard), 0.15);
      EXPECT_LT(ratio(5, Formulation::MeanDilatation), 0.2);
      EXPECT_GT(ratio(40, Formulation::MeanDilatation), 1.4);
    }
}

/// A spinning, stretching block; in 2D its bottom may have a contact element, away from the wall.
std::string block(const std::string& formulation, int dimension, const std::string& element = "Q1C1") {
  using test::list;
  using test::numbers;
  using test::word;
  const bool plane = dimension == 2;
  const std::string shape = test::count("Dimension", dimension) +
                            (plane ? numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2})
                                   : numbers("Lengths", {2, 1, 1}) + test::counts("Divisions", {2, 1, 1}));
  const std::string rubber =
      test::number("Poisson's Ratio", 0.45) + test::number("Density", 1) + word("Element Formulation", formulation);
  const std::string wall = word("Side Set", "bottom") + word("Contact Element", element) +
                           (plane ? numbers("Point", {0, -50}) : numbers("Point", {0, 0, -50}));
  const std::string gradient = plane ? numbers("Velocity Gradient", {0.15, -0.5, 0.5, -0.05})
                                     : numbers("Velocity Gradient", {0.1, -0.5, 0.2, 0.5, 0, -0.1, -0.2, 0.1, -0.1});
  return list("Mesh", word("Type", "Box") + list("Box", shape)) + list("Materials", list("Rubber", rubber)) +
         list("Interactions", list("Wall", wall)) + list("Initial Conditions", gradient);
}

// The forces derive from the energy that is reported: their mean over a step's straight path conserves it.
TEST(LockingVerification, AverageVectorFieldKeepsTheEnergyOfTheCures) {
  for (const char* formulation : {"Mean Dilatation", "Enhanced"})
    for (const std::string element : {"Q1C1", "Q1C3", "solid"}) {
      const bool solid = element == "solid";
      Simulation s(
          test::scene(block(formulation, solid ? 3 : 2, solid ? "Q1C1" : element) +
                      test::time_integrator("Average Vector Field", 0.02, 1, test::count("Elastic Points", 8))),
          world());
      const double start = test::total_energy(s);
      for (int step = 0; step < 30; ++step) ASSERT_TRUE(s.integrator().step(0.02).converged) << formulation;
      EXPECT_NEAR(test::total_energy(s), start, 1e-11) << formulation << ' ' << element;
      EXPECT_GT(s.model().elastic_energy(s.integrator().state().u.data()), 1e-4);
    }
}

TEST(LockingVerification, WhatTheCuresDoNotOfferIsRefused) {
  const auto message = [](const std::string& scene) -> std::string {
    try {
      const Simulation s(test::scene(scene), world());
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const std::string formulation : {"Mean Dilatation", "Enhanced"})
    EXPECT_EQ(message(block(formulation, 2) + test::time_integrator("Energy-Momentum", 0.1, 1)),
              "Materials/Rubber/Element Formulation: \"" + formulation +
                  "\" has no discrete gradient, which the scheme \"Energy-Momentum\" takes of the elastic energy; use "
                  "\"Standard\", or the scheme \"Average Vector Field\"");
  EXPECT_EQ(message(block("Standard", 2) + test::time_integrator("Energy-Momentum", 0.1, 1)), "accepted");
  const std::string matrix_free =
      test::list("Linear Solver", test::word("Linear Solver Type", "Belos") + test::word("Operator", "Matrix-Free"));
  EXPECT_NE(message(block("Enhanced", 3) + matrix_free + test::time_integrator("Newmark", 0.1, 1))
                .find("is not offered for this scene's element formulation"),
            std::string::npos);
}

}  // namespace
}  // namespace ixos

// Locking and its remedies where it shows: Cook's membrane, nearly incompressible, and slender cantilevers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "discretization/nodal_measure.hpp"
#include "mesh/cell_bending.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
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
Problem membrane(int divisions, test::ElasticLawOfConstants law, const Lame& lame, double load, int steps = 1) {
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
  problem.material.law = law(lame);
  return problem;
}

TEST(LockingSerialTest, CooksMembraneOfANearlyIncompressibleMaterial) {
  const Lame lame = lame_constants(1, 0.4999);
  const auto tip = [&](int divisions, Formulation formulation) {
    return deflection(membrane(divisions, linear_elastic, lame, 1.0), formulation);
  };
  const Formulation remedies[] = {Formulation::MeanDilatation, Formulation::Enhanced};
  double coarsest[2], finest[2], last_change[2];
  for (std::size_t k = 0; k < 2; ++k) {
    // The corner at the clamp is singular: first order at best. The tip is always too stiff.
    double before = coarsest[k] = tip(4, remedies[k]);
    double change = before;
    for (int divisions : {8, 16, 32}) {
      const double now = tip(divisions, remedies[k]);
      EXPECT_GT(now, before) << divisions;
      EXPECT_LT(now - before, 0.6 * change) << divisions;
      change = now - before;
      before = now;
    }
    finest[k] = before;
    last_change[k] = change;
  }
  EXPECT_NEAR(finest[0], finest[1], last_change[0] + last_change[1]);
  EXPECT_LT(tip(16, Formulation::Standard), std::min(coarsest[0], coarsest[1])) << "it locks";
}

TEST(LockingSerialTest, CooksMembraneAtLargeDisplacements) {
  const double mu = 80.1938;
  const auto tip = [&](int divisions, double nu, Formulation formulation) {
    const Lame lame{mu, mu * 2 * nu / (1 - 2 * nu)};
    return deflection(membrane(divisions, neo_hooke, lame, 100, 4), formulation);
  };
  double share = 1;  // of the right deflection that standard elements reach: the less, the stiffer the bulk
  for (double nu : {0.4, 0.49, 0.499, 0.4999}) {
    const double coarse = tip(8, nu, Formulation::MeanDilatation), mean = tip(16, nu, Formulation::MeanDilatation);
    const double standard = tip(16, nu, Formulation::Standard) / mean;
    EXPECT_LT(standard, share) << nu;
    share = standard;
    // Lambda = 5000 mu: here Newton's iteration of enhanced elements may break down.
    if (nu == 0.4999) {
      EXPECT_LT(std::abs(tip(32, nu, Formulation::MeanDilatation) - mean), 0.6 * std::abs(mean - coarse));
    } else {
      EXPECT_NEAR(tip(16, nu, Formulation::Enhanced), mean, std::abs(mean - coarse)) << nu;
    }
  }
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
  problem.material.law = linear_elastic(lame_constants(1, nu));
  return problem;
}

/// Returns the bending energy of an element with this formulation and length, of height and width 1, over that of the
/// beam. In plane strain u_x = xy; in three dimensions also u_z = -c yz, with the c of least energy.
double stiffening(int dimension, Formulation formulation, double nu, double length) {
  const double s = length * length, mu = 1 / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
  const bool standard = formulation == Formulation::Standard;
  if (dimension == 2) return standard ? (1 - nu) * (1 - nu) / (1 - 2 * nu) + (1 - nu) / 2 * s : (1 - nu) / 2 * (1 + s);
  return standard ? 3 * lambda * mu / (lambda + 3 * mu) + (2 + s) * mu : (8.0 / 7 + s) * mu;
}

// Bernoulli's and Timoshenko's: P L^3/(3 E I) + P L/(kappa G A), kappa = 10 (1 + nu)/(12 + 11 nu) (Cowper 1966).
TEST(LockingVerification, CantileversOfOneElementsThickness) {
  for (int dimension : {2, 3})
    for (double nu : {0.0, 0.3}) {
      const double modulus = dimension == 2 ? 1 / (1 - nu * nu) : 1, shear = 1 / (2 * (1 + nu));
      const double correction = 10 * (1 + nu) / (12 + 11 * nu);
      const double bending = 1e-3 * 8000 / (3 * modulus / 12), sliding = 1e-3 * 20 / shear;
      const double theory = bending + sliding / correction;
      const auto ratio = [&](int elements, Formulation formulation) {
        return deflection(cantilever(dimension, elements, nu), formulation) / theory;
      };
      // Constant curvature in each of n elements: 1 - 1/(4 n^2), and what the clamp holds of the lateral contraction.
      const double clamp = nu == 0 ? 1e-3 : dimension == 2 ? 2e-3 : 0.025;
      for (int n : {5, 10, 20}) EXPECT_NEAR(ratio(n, Formulation::Enhanced), 1 - 0.25 / (n * n), clamp) << nu;
      // Parasitic shear; and a single layer without volumetric stiffness is too soft where elements are short.
      const auto expect = [&](int n, Formulation formulation) {
        const double curved = (1 - 0.25 / (n * n)) / stiffening(dimension, formulation, nu, 20.0 / n);
        const double expected = (bending * curved + sliding) / theory;
        // In 3D the clamp holds u_z, and the curvature varies along the beam.
        const double tolerance = (dimension == 2 ? 1e-5 : 0.01) * expected;
        EXPECT_NEAR(ratio(n, formulation), expected, tolerance) << dimension << "D, nu " << nu << ", " << n;
      };
      expect(5, Formulation::Standard);
      expect(5, Formulation::MeanDilatation);
      expect(40, Formulation::MeanDilatation);
    }
}

/// A cantilever 10 by 1, nearly incompressible; the probe is the middle of its end.
Problem incompressible_cantilever(int along, int across, int order, test::ElasticLawOfConstants law = linear_elastic) {
  BoxShape shape;
  shape.lengths = {10, 1, 1};
  shape.divisions = {along, across, 1};
  Problem problem{box(shape), {}, 1e-5, 0};
  if (order == 2) raise_order(problem.mesh);
  const std::vector<double>& place = problem.mesh.coordinates;
  for (std::size_t n = 0; n < place.size() / 2; ++n)
    if (place[2 * n] > 10 - 1e-9 && std::abs(place[2 * n + 1] - 0.5) < 1e-9) problem.probe = n;
  problem.material.law = law(lame_constants(1, 0.499));
  return problem;
}

// With one volume ratio a cell, quadratic cells would bend without energy: a single layer would not converge at all.
TEST(LockingVerification, QuadraticCellsOfANearlyIncompressibleCantilever) {
  const double reference = deflection(incompressible_cantilever(80, 8, 1), Formulation::Enhanced);
  const auto tip = [](int along, int across, test::ElasticLawOfConstants law = linear_elastic) {
    return deflection(incompressible_cantilever(along, across, 2, law), Formulation::MeanDilatation);
  };
  EXPECT_NEAR(tip(20, 1), reference, 0.02 * reference);
  EXPECT_NEAR(tip(20, 2), reference, 0.005 * reference);
  EXPECT_NEAR(tip(40, 4), reference, 0.005 * reference);
  // The strains are small.
  EXPECT_NEAR(tip(20, 1, neo_hooke), tip(20, 1), 1e-3 * reference);
  EXPECT_LT(deflection(incompressible_cantilever(20, 2, 2), Formulation::Standard), 0.98 * reference) << "it locks";
}

/// A cantilever 20 by 1 of several layers in plane strain.
Problem layered(int divisions, int layers, double nu) {
  BoxShape shape;
  shape.lengths = {20, 1, 1};
  shape.divisions = {divisions, layers, 1};
  Problem problem{box(shape), {}, 1e-3, 0};
  for (std::size_t n = 0; n < problem.mesh.coordinates.size() / 2; ++n)
    if (problem.mesh.coordinates[2 * n] > 20 - 1e-9) problem.probe = n;
  problem.material.law = linear_elastic(lame_constants(1, nu));
  return problem;
}

// Timoshenko's deflection with a bending stiffness that is larger by the factor of the warning. Nearly incompressible
// layers also constrain each other, so that the factor is then a lower bound.
TEST(LockingVerification, TheFactorOfTheWarningIsThatOfTheDeflection) {
  for (double nu : {0.0, 0.3, 0.4995})
    for (int divisions : {10, 20})
      for (int layers : {1, 2, 4}) {
        const Problem problem = layered(divisions, layers, nu);
        const double mu = 1 / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu), modulus = 1 / (1 - nu * nu);
        BendingQuery query;
        query.block = "body";
        query.moduli = {lambda + mu, mu, modulus};
        query.slenderness = 4;
        const double factor = typical_bending(problem.mesh, query).body;
        const double curved = 1e-3 * 8000 / (3 * modulus / 12) * (1 - 0.25 / (divisions * divisions));
        const double predicted = curved / factor + 1e-3 * 20 / mu, found = deflection(problem, Formulation::Standard);
        const double coupling = nu < 0.4 || layers == 1 ? 0.01 : 0.3;
        EXPECT_LT(found, 1.005 * predicted) << nu << ", " << divisions << " x " << layers;
        EXPECT_GT(found, (1 - coupling) * predicted) << nu << ", " << divisions << " x " << layers;
      }
}

/// A spinning, stretching block; in 2D its bottom may have a contact element, away from the wall.
std::string block(const std::string& formulation, int dimension, const std::string& element = "Q1C1", int order = 1) {
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
  return list("Mesh", test::count("Cell Order", order) + word("Type", "Box") + list("Box", shape)) +
         list("Materials", list("Rubber", rubber)) + list("Interactions", list("Wall", wall)) +
         list("Initial Conditions", gradient);
}

// The forces derive from the energy that is reported: their mean over a step's straight path conserves it.
TEST(LockingVerification, AverageVectorFieldKeepsTheEnergyOfTheRemedies) {
  const auto expect_energy = [](const std::string& body) {
    Simulation s(
        test::scene(body + test::time_integrator("Average Vector Field", 0.02, 1, test::count("Elastic Points", 8))),
        world());
    const double start = test::total_energy(s);
    for (int step = 0; step < 30; ++step) ASSERT_TRUE(s.integrator().step(0.02).converged) << body;
    EXPECT_NEAR(test::total_energy(s), start, 1e-11) << body;
    EXPECT_GT(test::report_of(s).energy(Part::Elastic), 1e-4);
  };
  for (const char* formulation : {"Mean Dilatation", "Enhanced"}) {
    for (const char* element : {"Q1C1", "Q1C3"}) expect_energy(block(formulation, 2, element));
    expect_energy(block(formulation, 3));
  }
  for (const char* element : {"Q2C2", "Q2C4"}) expect_energy(block("Mean Dilatation", 2, element, 2));
}

TEST(LockingVerification, WhatTheRemediesDoNotOfferIsRefused) {
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
                  "\" has no discrete gradient, which the scheme \"Energy-Momentum\" needs; use "
                  "\"Standard\", or the scheme \"Average Vector Field\"");
  EXPECT_EQ(message(block("Standard", 2) + test::time_integrator("Energy-Momentum", 0.1, 1)), "accepted");
  const std::string matrix_free =
      test::list("Linear Solver", test::word("Linear Solver Type", "Belos") + test::word("Operator", "Matrix-Free"));
  EXPECT_NE(message(block("Enhanced", 3) + matrix_free + test::time_integrator("Newmark", 0.1, 1))
                .find("is not offered for Materials/Rubber/Element Formulation \"Enhanced\"; use \"Assembled\""),
            std::string::npos);
}

}  // namespace
}  // namespace ixos

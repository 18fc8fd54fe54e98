// Bicubic Hermite contact faces in whole scenes: a strip in plane strain, ranks, what is conserved, accuracy.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fem/quadrature.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

Momenta momenta(const Simulation& s) { return test::report_of(s).momenta(); }

/// A strip whose contact ends inside its bottom, held at its left end and drawn up at its right one; in 3D of depth
/// 1.5, its y held.
std::string strip(bool solid, const std::string& integrator) {
  const auto vector = [&](double x, double y, double z) { return solid ? std::vector{x, y, z} : std::vector{x, z}; };
  const std::string sets = list("patch", word("From", "bottom") + numbers("Upper", vector(9.5, 2, 1))) +
                           (solid ? list("every", word("Kind", "Nodes")) : std::string());
  const std::string plane = solid ? list("Plane", word("Node Set", "every") + word("Components", "y")) : std::string();
  return list("Mesh", word("Type", "Box") +
                          list("Box", count("Dimension", solid ? 3 : 2) + numbers("Lengths", vector(12, 1.5, 1)) +
                                          counts("Divisions", solid ? std::vector{8, 2, 2} : std::vector{8, 2})) +
                          list("Sets", sets)) +
         list("Materials", list("Rubber", number("Density", 0.1))) +
         list("Interactions", list("Wall", word("Side Set", "patch") + word("Contact Element", "Q1CH") +
                                               count("Bulk Points", 5) + numbers("Point", vector(0, 0, -0.26)))) +
         list("Histories", list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 1) + number("Length", 1)))) +
         list("Boundary Conditions",
              list("Held", word("Node Set", "left") + word("Components", solid ? "xz" : "xy")) +
                  list("Drawn",
                       word("Node Set", "right") + word("Components", solid ? "z" : "y") + word("History", "Up")) +
                  plane) +
         integrator;
}

TEST(HermiteFacesTest, InPlaneStrainTheyAreTheQuadrilateralsOfTwoDimensions) {
  // The program in two dimensions is the independent computation: nothing of the faces is in it.
  const std::string integrator = test::time_integrator("Average Vector Field", 0.05, 1);
  Simulation solid(test::scene(strip(true, integrator)), world()), flat(test::scene(strip(false, integrator)), world());
  for (int step = 0; step < 20; ++step) {
    ASSERT_TRUE(solid.integrator().step(0.05).converged);
    ASSERT_TRUE(flat.integrator().step(0.05).converged);
    const auto report = [](const Simulation& s) { return test::report_of(s).interaction_report(); };
    const InteractionReport three = report(solid), two = report(flat);
    EXPECT_NEAR(three.least_gap, two.least_gap, 1e-9);
    EXPECT_NEAR(three.force[2], 1.5 * two.force[1], 1e-9);
    EXPECT_NEAR(test::total_energy(solid), 1.5 * test::total_energy(flat), 1e-9);
  }
}

/// A block over a tilted wall that draws down a patch of its bottom, held at its top.
std::string drawn(const std::string& element, int faces, const std::string& integrator) {
  return list("Mesh", word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lengths", {4, 4, 1}) +
                                                            counts("Divisions", {faces, faces, 4}))) +
         list("Materials", list("Rubber", number("Young's Modulus", 0.2))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + word("Contact Element", element) +
                                               numbers("Point", {0, 0, -0.3}) + numbers("Normal", {0.2, 0.1, 1}) +
                                               count("Surface Points", 12))) +
         list("Boundary Conditions", list("Held", word("Node Set", "top"))) + integrator;
}

TEST(HermiteFacesTest, RanksAgree) {
  const std::string scene = drawn("Q1CH", 4, test::time_integrator("Bathe Composite", 0.05, 1));
  Simulation whole(test::scene(scene), world()), alone(test::scene(scene), test::self());
  for (int step = 0; step < 10; ++step) {
    ASSERT_TRUE(whole.integrator().step(0.05).converged);
    ASSERT_TRUE(alone.integrator().step(0.05).converged);
  }
  EXPECT_NEAR(test::total_energy(whole), test::total_energy(alone), 1e-10);
  EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                           test::gathered(alone.model(), alone.integrator().state().u)),
            1e-8);
}

/// The wall's pull on the block at rest.
double pull(const std::string& element, int faces) {
  Simulation s(test::scene(drawn(element, faces, test::time_integrator("Static", 1, 1))), world());
  EXPECT_TRUE(s.integrator().step(1).converged) << element;
  return test::report_of(s).interaction_report().force[2];
}

TEST(HermiteFacesTest, OfABodyInEquilibriumTheyNeedFewerFacesThanBilinearOnes) {
  // Against faces of order 4 on the same hexahedra, so that the error of those does not count.
  const double cubic = pull("Q1CH", 4) / pull("Q1C4", 4) - 1, linear = pull("Q1C1", 8) / pull("Q1C4", 8) - 1;
  EXPECT_GT(std::abs(linear), 1e-3);
  EXPECT_LT(std::abs(cubic), std::abs(linear) / 2);
}

TEST(HermiteFacesTest, AFreeSpinningBodyKeepsMomentaAndEnergy) {
  // The wall is too weak to be felt.
  Simulation s(test::scene(test::block_3d(1.0) +
                           list("Interactions",
                                list("Wall", word("Side Set", "bottom") + number("Gamma W", 1e20) +
                                                 word("Contact Element", "Q1CH") + numbers("Point", {0, 0, -50}))) +
                           test::time_integrator("Energy-Momentum", 0.05, 5)),
               world());
  const Momenta before = momenta(s);
  const double energy = test::total_energy(s);
  for (int step = 0; step < 60; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged);
  const Momenta after = momenta(s);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.linear[i], before.linear[i], 1e-10);
    EXPECT_NEAR(after.angular[i], before.angular[i], 1e-10);
  }
  EXPECT_NEAR(test::total_energy(s), energy, 1e-10);
}

/// The underside of a sphere, seen from the wall: value, slopes and curvatures.
struct Sphere {
  double radius = 4, gap = 0.3, x = 1.7, y = 2.2;
  double height(double a, double b) const { return std::sqrt(radius * radius - (a - x) * (a - x) - (b - y) * (b - y)); }
  double value(double a, double b) const { return gap + radius - height(a, b); }
  std::array<double, 2> slope(double a, double b) const { return {(a - x) / height(a, b), (b - y) / height(a, b)}; }
  double mixed(double a, double b) const { return (a - x) * (b - y) / std::pow(height(a, b), 3); }
};

const VanDerWaals law(2.5, 25);

/// The wall's pull on a square of n x n faces of two widths that hold the sphere's values, and its slopes.
double pull(ContactElement element, int n, const Sphere& sphere) {
  Mesh mesh = box({3, {}, {4, 4, 1}, {n, n, 1}});
  const double h = 4.0 / n;
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k)  // 3 : 1 in turn
    if (k % 3 < 2 && std::lround(mesh.coordinates[k] / h) % 2 == 1) mesh.coordinates[k] += h / 2;
  enrich(mesh, "bottom", element);
  Material rubber;
  rubber.density = 1;
  rubber.block = "body";
  rubber.law = neo_hooke(lame_constants(1.0, 0.3));
  const Comm comm = world();
  Model model(localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()), comm, {rubber});
  HalfSpace wall;
  wall.normal = {0, 0, 1};
  SurfaceOptions options;
  options.points = 16;
  const LocalMesh& local = model.mesh();
  const auto& sides = local.side_sets[local.side_set("bottom")];
  for (auto& term : make_surface_terms(local, sides, model.pattern(), gap_law(law), flat_wall(wall), options))
    model.add_interaction(std::move(term));

  std::vector<double> u(local.coordinates.size(), 0.0);
  for (std::size_t node = 0; node < u.size() / 3; ++node)
    if (!local.is_derivative(node))
      u[3 * node + 2] = sphere.value(local.coordinates[3 * node], local.coordinates[3 * node + 1]);
  // Derivatives along the lines of the grid, which are those of x and y; the mixed one has the lengths of both.
  for (const LocalSide& side : sides)
    for (std::size_t c = 0; c < 4 && is_hermite(local.blocks[static_cast<std::size_t>(side.block)].type); ++c) {
      const auto node = [&](std::size_t a) { return 3 * static_cast<std::size_t>(side.nodes[a]); };
      const double *x = &local.coordinates[node(c)], *first = &local.coordinates[node(4 + 3 * c)],
                   *second = &local.coordinates[node(5 + 3 * c)];
      const auto slope = sphere.slope(x[0], x[1]);
      u[node(4 + 3 * c) + 2] = slope[0] * first[0] + slope[1] * first[1];
      u[node(5 + 3 * c) + 2] = slope[0] * second[0] + slope[1] * second[1];
      u[node(6 + 3 * c) + 2] = sphere.mixed(x[0], x[1]) * (first[0] + first[1]) * (second[0] + second[1]);
    }
  return test::ReportAt(model, u.data()).interaction_report().force[2];
}

TEST(HermiteFacesTest, ThePullOnASphereIsOfFourthOrder) {
  // Against the integral itself, by another quadrature on finer squares.
  const Sphere sphere;
  const Quadrature gauss = gauss_legendre_unit(20);
  double exact = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (std::size_t p = 0; p < 20; ++p)
        for (std::size_t q = 0; q < 20; ++q)
          exact += gauss.weights[p] * gauss.weights[q] / 4 *
                   law.traction(sphere.value((i + gauss.points[p]) / 2, (j + gauss.points[q]) / 2));
  const auto error = [&](ContactElement element, int n) { return std::abs(pull(element, n, sphere) / exact - 1); };
  const double linear = error(ContactElement::Q1C1, 16), finer = error(ContactElement::Q1C1, 32);
  const double coarse = error(ContactElement::Q1CH, 8), cubic = error(ContactElement::Q1CH, 16);
  EXPECT_NEAR(std::log2(linear / finer), 2, 0.3);
  EXPECT_NEAR(std::log2(coarse / cubic), 4, 0.5);
  EXPECT_LT(coarse, finer);  // with a sixteenth of the faces
}

}  // namespace
}  // namespace ixos

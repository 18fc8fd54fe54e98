// Solids of three dimensions before the wall against closed forms: rigid spheres and blocks, Hertz's contact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "term/wall/surface_terms.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::at_rest;
using test::elastic;
using test::model_of;

const VanDerWaals paper_law(2.5, 25);

/// Returns the terms of a wall before that side set.
Interactions wall_terms(const Model& model, const std::string& set, const VanDerWaals& law, const HalfSpace& wall,
                        int surface_points) {
  const LocalMesh& mesh = model.mesh();
  SurfaceOptions options;
  options.points = surface_points;
  return make_surface_terms(mesh, mesh.side_sets[mesh.side_set(set)], model.pattern(), gap_law(law), flat_wall(wall),
                            options);
}

void add_wall(Model& model, const std::string& set, const VanDerWaals& law, const HalfSpace& wall, int surface_points) {
  for (auto& term : wall_terms(model, set, law, wall, surface_points)) model.add_interaction(std::move(term));
}

/// Returns the report of a wall that is not part of the model, for the body at rest. Collective.
InteractionReport report_of_wall(const Model& model, const std::string& set, const HalfSpace& wall,
                                 int surface_points) {
  InteractionReport report;
  for (const auto& term : wall_terms(model, set, paper_law, wall, surface_points))
    term->reports().report({at_rest(model).data()}, report);
  model.space().sum(report.force.data(), 3);
  report.least_gap = model.space().minimum(report.least_gap);
  return report;
}

/// A ball whose centre is the origin: the lattice of a cube, finer at the poles, each of its cubical shells blown up to
/// a sphere.
Mesh ball(double radius, int divisions) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lower = {-1, -1, -1};
  shape.lengths = {2, 2, 2};
  shape.divisions = {divisions, divisions, divisions};
  Mesh mesh = box(shape);
  std::vector<double>& x = mesh.coordinates;
  for (std::size_t n = 0; n < x.size(); n += 3) {
    double largest = 0;
    for (std::size_t i = n; i < n + 3; ++i) {
      x[i] *= 0.15 + 0.85 * x[i] * x[i];
      largest = std::max(largest, std::abs(x[i]));
    }
    const double length = std::hypot(x[n], x[n + 1], x[n + 2]);
    for (std::size_t i = n; i < n + 3; ++i) x[i] *= length > 0 ? radius * largest / length : 0;
  }
  return mesh;
}

// The area of a sphere between two heights is 2 pi R times their difference: int T dA = 2 pi R (psi(D) - psi(D + 2R)).
TEST(SolidContactTest, ForceOnARigidSphereIsTheDifferenceOfEnergies) {
  const double radius = 10, gaps[] = {0.18, 0.2547093, 0.4, 3.0};
  std::vector<double> errors[4];
  for (int divisions : {8, 16, 32}) {
    const auto model = model_of(ball(radius, divisions), elastic(linear_elastic, 0.2), Inertia::None);
    for (std::size_t k = 0; k < 4; ++k) {
      const double gap = gaps[k];
      const double exact = 2 * M_PI * radius * (paper_law.energy(gap) - paper_law.energy(gap + 2 * radius));
      const HalfSpace wall{{0, 0, -radius - gap}, {0, 0, 1}};
      const InteractionReport report = report_of_wall(*model, "surface", wall, 8);
      errors[k].push_back(report.force[2] / exact - 1);
      EXPECT_NEAR(report.force[0], 0, 1e-12);
      EXPECT_NEAR(report.force[1], 0, 1e-12);
      EXPECT_GT(report.least_gap, gap);  // beside the pole
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    // Of second order in the facets' size, without which Richardson's extrapolation would be no better.
    EXPECT_NEAR(errors[k][1] / errors[k][0], 0.25, 0.06) << gaps[k];
    EXPECT_NEAR(errors[k][2] / errors[k][1], 0.25, 0.015) << gaps[k];
    EXPECT_NEAR((4 * errors[k][2] - errors[k][1]) / 3, 0, 3e-3) << gaps[k];
    EXPECT_LT(std::abs(errors[k][2]), 0.04) << gaps[k];
  }
}

/// Force of the wall on a block of edge 1 at the origin, along the wall's normal. The block's lower corner is that near
/// the wall, at the distance `gap` cos(tilt); the normal's first two components are given.
double force_on_block(double nx, double ny, double gap, int surface_points) {
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {2, 2, 1};
  const auto model = model_of(box(shape), elastic(linear_elastic, 0.2), Inertia::None);
  const std::array<double, 3> normal{nx, ny, std::sqrt(1 - nx * nx - ny * ny)};
  add_wall(*model, "bottom", paper_law, {{0, 0, -gap}, normal}, surface_points);
  const auto force = test::ReportAt(*model, at_rest(*model).data()).interaction_report().force;
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += force[i] * normal[i];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(force[i], along * normal[i], 1e-14);
  return along;
}

TEST(SolidContactTest, ForceOnABlockTiltedAboutOneAxisIsTheDifferenceOfEnergies) {
  // Along the face the gap runs linearly from r0 to r1: int T = (psi(r0) - psi(r1))/(r1 - r0).
  const double gap = 0.3, tilt = 0.3, r0 = gap * std::cos(tilt), r1 = r0 + std::sin(tilt);
  const double exact = (paper_law.energy(r0) - paper_law.energy(r1)) / (r1 - r0);
  for (bool about_y : {true, false}) {
    const double nx = about_y ? std::sin(tilt) : 0, ny = about_y ? 0 : std::sin(tilt);
    double before = 1;
    for (int points : {2, 4, 8, 16}) {
      const double error = std::abs(force_on_block(nx, ny, gap, points) / exact - 1);
      EXPECT_LT(error, 0.2 * before) << points;
      before = error;
    }
    EXPECT_LT(before, 1e-9);
  }
}

TEST(SolidContactTest, ForceOnABlockTiltedAboutTwoAxesIsTheIntegralOfTheTraction) {
  const double nx = 0.25, ny = -0.1, nz = std::sqrt(1 - nx * nx - ny * ny), gap = 0.45;
  // T = c1/r^9 - c2/r^3 with r0 = 0.4, W0 = E0/25 (Sauer 2011), over the unit square by Simpson's rule.
  const auto traction = [](double r) {
    const double s = 0.4 / r;
    return M_PI / 25 * (std::pow(s, 9) / 45 - std::pow(s, 3) / 3);
  };
  const int n = 200;
  const auto weight = [n](int i) { return (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * n); };
  double exact = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) exact += weight(i) * weight(j) * traction(nz * gap + nx * i / n + ny * j / n);
  EXPECT_NEAR(force_on_block(nx, ny, gap, 16) / exact, 1, 1e-8);
  EXPECT_NEAR(force_on_block(nx, ny, gap, 4) / exact, 1, 1e-2);
}

/// Lattice lines in [0, end]: `fine` cells of the length h, then ever twice as long ones.
std::vector<double> graded(double h, int fine, double end) {
  std::vector<double> x{0};
  for (int i = 1; i <= fine; ++i) x.push_back(i * h);
  for (double length = 2 * h; x.back() + 1.5 * length < end; length *= 2) x.push_back(x.back() + length);
  x.push_back(end);
  return x;
}

/// A quarter of a large block whose bottom is a paraboloid of that radius near the origin, with cells of length h
/// there.
Mesh punch(double radius, double h, int fine) {
  const double size = 40;
  const std::vector<double> across = graded(h, fine, size), up = graded(h, fine / 2, size);
  BoxShape shape;
  shape.dimension = 3;
  const int n = static_cast<int>(across.size()) - 1, m = static_cast<int>(up.size()) - 1;
  shape.divisions = {n, n, m};
  Mesh mesh = box(shape);
  std::vector<double>& x = mesh.coordinates;
  const auto place = [](const std::vector<double>& lines, double s) {
    return lines[static_cast<std::size_t>(std::lround(s * static_cast<double>(lines.size() - 1)))];
  };
  for (std::size_t k = 0; k < x.size(); k += 3) {
    x[k] = place(across, x[k]);
    x[k + 1] = place(across, x[k + 1]);
    x[k + 2] = place(up, x[k + 2]);
    // Flat away from the contact: the parabola b becomes tanh b, less by b^3/3, b <= 0.05 in the contact.
    const double bump = std::tanh((x[k] * x[k] + x[k + 1] * x[k + 1]) / (2 * radius));
    x[k + 2] += bump * (1 - x[k + 2] / size);
  }
  return mesh;
}

/// Contact forces over Hertz's at some indentations.
std::vector<double> hertz_ratios(double h, int fine, const std::vector<double>& indentations) {
  const double radius = 10, nu = 0.2, reduced = 1 / (1 - nu * nu), gap = 0.02;
  // Work of adhesion 2e-7: a pull of 2 pi R times that, 1e-5, against forces of 0.03 to 0.14.
  const VanDerWaals law(50, 1e5);
  const auto model = model_of(punch(radius, h, fine), elastic(neo_hooke, nu), Inertia::None);
  add_wall(*model, "bottom", law, {{0, 0, -gap}, {0, 0, 1}}, 5);
  const LocalMesh& mesh = model->mesh();
  const auto down = rate_ramp(-1.0, 0.0, 0.0, RampShape::Linear);  // u = -t
  for (const auto& [set, axis, motion] :
       {std::tuple("left", 0, std::shared_ptr<const TimeFunction>()),
        std::tuple("front", 1, std::shared_ptr<const TimeFunction>()), std::tuple("top", 2, down)})
    for (int node : mesh.node_sets[mesh.node_set(set)]) model->constraints().add(3 * node + axis, 1.0, motion);
  Integrator integrator = test::direct(*model, static_equilibrium(), 1e-8);
  integrator.initialize(at_rest(*model), at_rest(*model), 0.0);
  std::vector<double> ratios;
  for (double indentation : indentations) {
    // The wall is where its traction is Hertz's mean pressure, 4/(3 pi) E* sqrt(d/R).
    const double pressure = 4 / (3 * M_PI) * reduced * std::sqrt(indentation / radius);
    const double surface = std::pow(law.c1() / pressure, 1.0 / 9);
    const double end = indentation + gap - surface;
    const int steps = 4;
    const double dt = (end - integrator.time()) / steps;
    for (int step = 0; step < steps; ++step) {
      const StepResult result = integrator.step(dt);
      EXPECT_TRUE(result.converged) << result.reason;
      if (!result.converged) return std::vector<double>(indentations.size(), NAN);
    }
    const double force = 4 * StateReport(*model, integrator.state()).interaction_report().force[2];
    ratios.push_back(force / (4.0 / 3 * reduced * std::sqrt(radius) * std::pow(indentation, 1.5)));
  }
  return ratios;
}

// Johnson, Contact Mechanics (1985), section 4.2: F = 4/3 E* sqrt(R) d^(3/2), E* = E/(1 - nu^2) at a rigid plane. The
// contact's radius is sqrt(R d) = 1 at d = 0.1, five cells of the fine mesh. A half-space under the force F moves by
// (1 + nu)(3 - 2 nu) F/(2 pi E z) at the depth z (Boussinesq); the top of the block, at 40, does not: F grows by 3/2 of
// that over d, 1.8 and 2.6 %.
TEST(SolidContactSerialTest, ElasticContactTendsToHertz) {
  const std::vector<double> indentations{0.05, 0.1};
  const auto coarse = hertz_ratios(0.5, 4, indentations), fine = hertz_ratios(0.2, 8, indentations);
  for (std::size_t i = 0; i < indentations.size(); ++i) {
    const double hertz = 4.0 / 3 / 0.96 * std::sqrt(10) * std::pow(indentations[i], 1.5);
    const double expected = 1 + 1.5 * 1.2 * 2.6 * hertz / (2 * M_PI * 40) / indentations[i];
    EXPECT_NEAR(fine[i], expected, 0.02) << indentations[i];
    EXPECT_LT(std::abs(fine[i] - expected), 0.5 * std::abs(coarse[i] - expected)) << indentations[i];
  }
}

}  // namespace
}  // namespace ixos

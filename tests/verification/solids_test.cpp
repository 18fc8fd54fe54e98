// Solids of three dimensions against closed forms: rigid ones before the wall, Hertz's contact, beams, free flight.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

#include "mesh/generators.hpp"
#include "model/half_space_term.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::world;

bool second_run() { return world()->getSize() > 1; }

std::unique_ptr<Model> model_of(const Mesh& mesh, Material material, Inertia inertia) {
  const Comm comm = world();
  const int ranks = comm->getSize();
  material.block = "body";
  return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm,
                                 std::vector<Material>{material}, inertia);
}

Material elastic(ElasticLaw law, double nu) {
  Material material;
  material.law = law;
  material.lame = lame_constants(1, nu);
  material.density = 1;
  return material;
}

void add_wall(Model& model, const std::string& set, const VanDerWaals& law, const std::array<double, 3>& point,
              const std::array<double, 3>& normal, int surface_points) {
  const LocalMesh& mesh = model.mesh();
  SurfaceOptions options;
  options.points = surface_points;
  for (auto& term :
       make_half_space_terms(mesh, mesh.side_sets[mesh.side_set(set)], model.pattern(), law, {point, normal}, options))
    model.add_interaction(std::move(term));
}

std::vector<double> at_rest(const Model& model) {
  return std::vector<double>(static_cast<std::size_t>(model.space().local()), 0.0);
}

Integrator direct(const Model& model, const Table& table, double tolerance) {
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  return {model, table, std::make_shared<LinearSolverFactory>(linear), NewtonOptions{tolerance, 100, {}}};
}

const VanDerWaals paper_law(2.5, 25);

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
TEST(SolidsTest, ForceOnARigidSphereIsTheDifferenceOfEnergies) {
  const double radius = 10;
  for (double gap : {0.18, 0.2547093, 0.4, 3.0}) {
    const double exact = 2 * M_PI * radius * (paper_law.energy(gap) - paper_law.energy(gap + 2 * radius));
    std::vector<double> errors;
    for (int divisions : {8, 16, 32}) {
      const auto model = model_of(ball(radius, divisions), elastic(ElasticLaw::Linear, 0.2), Inertia::None);
      add_wall(*model, "surface", paper_law, {0, 0, -radius - gap}, {0, 0, 1}, 8);
      const InteractionReport report = model->interaction_report(at_rest(*model).data());
      errors.push_back(report.force[2] / exact - 1);
      EXPECT_NEAR(report.force[0], 0, 1e-12);
      EXPECT_NEAR(report.force[1], 0, 1e-12);
      EXPECT_GT(report.least_gap, gap);  // beside the pole
    }
    // Of second order in the facets' size, without which Richardson's extrapolation would be no better.
    EXPECT_NEAR(errors[1] / errors[0], 0.25, 0.06) << gap;
    EXPECT_NEAR(errors[2] / errors[1], 0.25, 0.015) << gap;
    EXPECT_NEAR((4 * errors[2] - errors[1]) / 3, 0, 3e-3) << gap;
    EXPECT_LT(std::abs(errors[2]), 0.04) << gap;
  }
}

/// Force of the wall on a block of edge 1 at the origin, along the wall's normal. The block's lower corner is that near
/// the wall, at the distance `gap` cos(tilt); the normal's first two components are given.
double force_on_block(double nx, double ny, double gap, int surface_points) {
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {2, 2, 1};
  const auto model = model_of(box(shape), elastic(ElasticLaw::Linear, 0.2), Inertia::None);
  const std::array<double, 3> normal{nx, ny, std::sqrt(1 - nx * nx - ny * ny)};
  add_wall(*model, "bottom", paper_law, {0, 0, -gap}, normal, surface_points);
  const auto force = model->interaction_report(at_rest(*model).data()).force;
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += force[i] * normal[i];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(force[i], along * normal[i], 1e-14);
  return along;
}

TEST(SolidsTest, ForceOnABlockTiltedAboutOneAxisIsTheDifferenceOfEnergies) {
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

TEST(SolidsTest, ForceOnABlockTiltedAboutTwoAxesIsTheIntegralOfTheTraction) {
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
  const auto model = model_of(punch(radius, h, fine), elastic(ElasticLaw::NeoHooke, nu), Inertia::None);
  add_wall(*model, "bottom", law, {0, 0, -gap}, {0, 0, 1}, 5);
  const LocalMesh& mesh = model->mesh();
  const auto down = rate_ramp(-1.0, 0.0, 0.0, RampShape::Linear);  // u = -t
  for (const auto& [set, axis, motion] :
       {std::tuple("left", 0, std::shared_ptr<const TimeFunction>()),
        std::tuple("front", 1, std::shared_ptr<const TimeFunction>()), std::tuple("top", 2, down)})
    for (int node : mesh.node_sets[mesh.node_set(set)]) model->constraints().add(3 * node + axis, 1.0, motion);
  Integrator integrator = direct(*model, static_equilibrium(), 1e-8);
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
    const double force = 4 * model->interaction_report(integrator.state().u.data()).force[2];
    ratios.push_back(force / (4.0 / 3 * reduced * std::sqrt(radius) * std::pow(indentation, 1.5)));
  }
  return ratios;
}

// Johnson, Contact Mechanics (1985), section 4.2: F = 4/3 E* sqrt(R) d^(3/2), E* = E/(1 - nu^2) at a rigid plane. The
// contact's radius is sqrt(R d) = 1 at d = 0.1, five cells of the fine mesh. A half-space under the force F moves by
// (1 + nu)(3 - 2 nu) F/(2 pi E z) at the depth z (Boussinesq); the top of the block, at 40, does not: F grows by 3/2 of
// that over d, 1.8 and 2.6 %.
TEST(SolidsTest, ElasticContactTendsToHertz) {
  if (second_run()) GTEST_SKIP();
  const std::vector<double> indentations{0.05, 0.1};
  const auto coarse = hertz_ratios(0.5, 4, indentations), fine = hertz_ratios(0.2, 8, indentations);
  for (std::size_t i = 0; i < indentations.size(); ++i) {
    const double hertz = 4.0 / 3 / 0.96 * std::sqrt(10) * std::pow(indentations[i], 1.5);
    const double expected = 1 + 1.5 * 1.2 * 2.6 * hertz / (2 * M_PI * 40) / indentations[i];
    EXPECT_NEAR(fine[i], expected, 0.02) << indentations[i];
    EXPECT_LT(std::abs(fine[i] - expected), 0.5 * std::abs(coarse[i] - expected)) << indentations[i];
  }
}

enum class Ends { Cantilever, Free };

/// det(omega) of Timoshenko's beam (length L, 1 x 1, E = rho = 1, nu = 0, so G = 1/2): w' = phi + V/(kappa G A),
/// phi' = M/(E I), M' = -V - rho I omega^2 phi, V' = -rho A omega^2 w, from one end to the other by Runge and Kutta's
/// method. kappa = 1, as the shear of one layer of elements is uniform through the thickness.
double timoshenko_determinant(Ends ends, double length, double omega) {
  using State = std::array<double, 4>;  // w, phi, M, V
  const double inertia = 1.0 / 12, shear = 0.5;
  const auto slope = [&](const State& y) {
    return State{y[1] + y[3] / shear, y[2] / inertia, -y[3] - inertia * omega * omega * y[1], -omega * omega * y[0]};
  };
  const auto sum = [](const State& y, double h, const State& k) {
    State z = y;
    for (std::size_t i = 0; i < 4; ++i) z[i] += h * k[i];
    return z;
  };
  const auto at_end = [&](State y) {
    const int n = 400;
    const double h = length / n;
    for (int i = 0; i < n; ++i) {
      const State a = slope(y), b = slope(sum(y, h / 2, a)), c = slope(sum(y, h / 2, b)), d = slope(sum(y, h, c));
      y = sum(sum(sum(sum(y, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return y;
  };
  const bool clamped = ends == Ends::Cantilever;
  const State p = at_end(clamped ? State{0, 0, 1, 0} : State{1, 0, 0, 0});
  const State q = at_end(clamped ? State{0, 0, 0, 1} : State{0, 1, 0, 0});
  return p[2] * q[3] - p[3] * q[2];
}

/// Euler and Bernoulli's lowest: k^2 sqrt(E I/(rho A))/L^2.
double bernoulli_frequency(Ends ends, double length) {
  const double k = ends == Ends::Cantilever ? 1.875104069 : 4.730040745;
  return k * k / std::sqrt(12.0) / (length * length);
}

double timoshenko_frequency(Ends ends, double length) {
  double high = bernoulli_frequency(ends, length), low = 0.8 * high;
  const bool rises = timoshenko_determinant(ends, length, high) > 0;
  EXPECT_NE(timoshenko_determinant(ends, length, low) > 0, rises);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((timoshenko_determinant(ends, length, middle) > 0) == rises ? high : low) = middle;
  }
  return low;
}

/// Bernoulli's mode at x/L = s.
double bending_mode(Ends ends, double s) {
  if (ends == Ends::Cantilever) {
    const double k = 1.875104069, ratio = 0.734095514;
    return std::cosh(k * s) - std::cos(k * s) - ratio * (std::sinh(k * s) - std::sin(k * s));
  }
  const double k = 4.730040745, ratio = 0.982502215;
  return std::cosh(k * s) + std::cos(k * s) - ratio * (std::sinh(k * s) + std::sin(k * s));
}

/// Of the box, length x 1 x 1, from its motion by the trapezoid: of every mode q_n+1 + q_n-1 = 2 cos(theta) q_n with
/// tan(theta/2) = omega dt/2, so the period error is none. q is the momentum's moment with the mode, to which the other
/// modes that the start excites contribute little.
double measured_frequency(Ends ends, double length, const std::array<int, 3>& divisions, Formulation formulation) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {length, 1, 1};
  shape.divisions = divisions;
  Material material = elastic(ElasticLaw::Linear, 0);  // nu = 0: no lateral contraction for the clamp to hold
  material.formulation = formulation;
  const auto model = model_of(box(shape), material, Inertia::Consistent);
  const LocalMesh& mesh = model->mesh();
  if (ends == Ends::Cantilever)
    for (int node : mesh.node_sets[mesh.node_set("left")])
      for (int i = 0; i < 3; ++i) model->constraints().add(3 * node + i, 0.0, nullptr);
  std::vector<double> mode = at_rest(*model), weighted(mode.size(), 0.0);
  const double step = 1e-4;  // sections stay plane and turn with the axis
  for (std::size_t n = 0; n < mode.size(); n += 3) {
    const double s = mesh.coordinates[n] / length;
    const double slope = (bending_mode(ends, s + step) - bending_mode(ends, s - step)) / (2 * step * length);
    mode[n] = -(mesh.coordinates[n + 2] - 0.5) * slope;
    mode[n + 2] = bending_mode(ends, s);
  }
  model->mass()->multiply(mode.data(), weighted.data());
  Integrator integrator = direct(*model, newmark(0.25, 0.5), 1e-11);
  integrator.initialize(at_rest(*model), mode, 0.0);
  const double dt = 2 * M_PI / bernoulli_frequency(ends, length) / 40;
  std::vector<double> q{0};
  for (int n = 0; n < 24; ++n) {
    const StepResult result = integrator.step(dt);
    EXPECT_TRUE(result.converged) << result.reason;
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); ++i)
      sum += weighted[i] * integrator.state().u[i];
    model->space().sum(&sum, 1);
    q.push_back(sum);
  }
  double numerator = 0, denominator = 0;
  for (std::size_t n = 1; n + 1 < q.size(); ++n) {
    numerator += q[n] * (q[n + 1] + q[n - 1]);
    denominator += q[n] * q[n];
  }
  return 2 * std::tan(std::acos(numerator / denominator / 2) / 2) / dt;
}

TEST(SolidsTest, LowestBendingFrequenciesAreThoseOfTimoshenkosBeam) {
  const double length = 16;
  for (Ends ends : {Ends::Cantilever, Ends::Free}) {
    const double exact = timoshenko_frequency(ends, length);
    EXPECT_NEAR(exact / bernoulli_frequency(ends, length), 1, 0.015);
    std::vector<double> errors;
    for (int n : {8, 16, 32})
      errors.push_back(measured_frequency(ends, length, {n, 1, 1}, Formulation::Enhanced) / exact - 1);
    EXPECT_NEAR(errors[1] / errors[0], 0.25, 0.02);
    EXPECT_NEAR(errors[2] / errors[1], 0.25, 0.01);
    EXPECT_NEAR(errors[2], 0, 2e-3);
    // Parasitic shear of standard elements of length l: the bending stiffness grows by the factor 1 + G/E l^2/1^2.
    for (int n : {32, 64}) {
      const double l = length / n, ratio = measured_frequency(ends, length, {n, 1, 1}, Formulation::Standard) / exact;
      EXPECT_NEAR(ratio, std::sqrt(1 + l * l / 2), 2e-3) << n;
    }
  }
}

/// The spatula without a wall.
std::string free_spatula(const std::string& motion) {
  return test::list("Mesh", test::word("Type", "Spatula") + test::list("Spatula", test::count("Target Cells", 400))) +
         test::list("Materials", test::list("Keratin", "")) + test::list("Initial Conditions", motion);
}

/// Steps of 0.01, 0.02, 0.04, ... 1.28: the first is short as Newton's tolerance knows what rounding does to the forces
/// of a body that has moved, but not of one that moves in the step.
void fly(Simulation& s, const std::string& scheme) {
  for (double step = 0.01; step < 1.5; step *= 2) ASSERT_TRUE(s.integrator().step(step).converged) << scheme;
}

Momenta momenta(const Simulation& s) {
  return s.model().momenta(s.integrator().state().u.data(), s.integrator().state().v.data());
}

TEST(SolidsTest, ASpatulaInUniformMotionKeepsItsMomentaAndItsShape) {
  const std::vector<double> velocity{1.0, -0.5, 2.0};
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"}) {
    Simulation s(
        test::scene(free_spatula(test::numbers("Velocity", velocity)) + test::time_integrator(scheme, 1.0, 10)),
        world());
    const Momenta before = momenta(s);
    const double mass = before.linear[0] / velocity[0];
    // In steps of a thousand times the elastic time: nothing but rounding moves in the body.
    for (int step = 0; step < 3; ++step) ASSERT_TRUE(s.integrator().step(1.0).converged) << scheme;
    const Momenta after = momenta(s);
    EXPECT_NEAR(before.kinetic_energy, mass * 5.25 / 2, 1e-12 * mass);
    EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-10 * before.kinetic_energy) << scheme;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(before.linear[i], mass * velocity[i], 1e-12 * mass);
      EXPECT_NEAR(after.linear[i], before.linear[i], 1e-10 * mass) << scheme;
      EXPECT_NEAR(after.angular[i], before.angular[i], 1e-7 * mass) << scheme;  // arms of 300
    }
    double largest = 0;
    const std::vector<double>& u = s.integrator().state().u;
    for (std::size_t k = 0; k < u.size(); ++k)
      largest = std::max(largest, std::abs(u[k] - s.integrator().time() * velocity[k % 3]));
    EXPECT_LT(s.model().space().maximum(largest), 1e-9) << scheme;
    EXPECT_LT(s.model().elastic_energy(u.data()), 1e-15) << scheme;
  }
}

// Spin stretches it, so it breathes; these schemes keep its angular momentum nevertheless, in steps of up to
// 0.14 rad.
TEST(SolidsTest, ASpinningSpatulaKeepsItsAngularMomentum) {
  for (const char* scheme : {"Midpoint", "Energy-Momentum"}) {
    Simulation s(test::scene(free_spatula(test::numbers("Velocity Gradient", {0, -0.1, 0.05, 0.1, 0, 0, -0.05, 0, 0}) +
                                          test::numbers("Origin", {0, 0, 60})) +
                             test::time_integrator(scheme, 1.0, 10)),
                 world());
    const Momenta before = momenta(s);
    const double energy = test::total_energy(s);
    const double size = std::hypot(before.angular[0], before.angular[1], before.angular[2]);
    fly(s, scheme);
    const Momenta after = momenta(s);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after.angular[i], before.angular[i], 1e-9 * size) << scheme;
    EXPECT_GT(s.model().elastic_energy(s.integrator().state().u.data()), 0) << scheme;
    if (scheme == std::string("Midpoint")) continue;  // its steps are too long to hold the energy
    EXPECT_NEAR(test::total_energy(s), energy, 1e-9 * energy) << scheme;
  }
}

}  // namespace
}  // namespace ixos

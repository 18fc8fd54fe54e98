#include <gtest/gtest.h>

#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <string>

#include "model/state_report.hpp"
#include "solve/bordered/bordered_operator.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/rigid_scene.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"
#include "time/catalogue.hpp"
#include "time/integrator.hpp"

namespace ixos {
namespace {

using test::ball_on_block;
using test::RigidScene;

std::size_t first_of(const Simulation& s) { return static_cast<std::size_t>(s.model().space().first_global()); }

/// Expects that the derivative of a stage's residual along a direction that moves nodes and bodies is the bordered
/// tangent's product with it, after three steps.
void expect_tangent(const Teuchos::ParameterList& scene, const std::string& label) {
  Simulation s(scene, test::world());
  Integrator& integrator = s.integrator();
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(integrator.step(0.05).converged) << label;
  integrator.acceleration();
  Model& model = const_cast<Model&>(s.model());
  StageProblem problem(model, integrator.table(), false, false);
  std::vector<State> states(integrator.table().stages.size() + 1);
  states[0] = integrator.state();
  StepMemories memories = model.create_memories();
  const double dt = 0.1;
  model.begin_step({known_states(states, 1).front(), dt, &states[0].histories}, memories);
  problem.arm(0, states, dt, memories);
  Vector x(problem.map()), direction(problem.map()), f(problem.map()), g(problem.map()), product(problem.map());
  std::vector<double> u = states[0].u, d(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    d[i] = std::sin(1.3 * static_cast<double>(i) + 0.4);
    if (i >= first_of(s)) d[i] = 0.3 + 0.1 * static_cast<double>(i - first_of(s));  // alike on all ranks
    if (i >= first_of(s) && (i - first_of(s)) % RigidBody::numbers >= RigidBody::attitude) d[i] = 0;
    u[i] += 0.01 * d[i];
  }
  // The unknowns of carried nodes are those of their body.
  for (const int dof : model.constraints().entrusted()) d[static_cast<std::size_t>(dof)] = 0;
  model.space().take(u.data(), x);
  model.space().take(d.data(), direction);
  const auto w = problem.create_operator();
  ASSERT_TRUE(problem.residual(x, f)) << label;
  problem.tangent(x, *w);
  const auto& bordered = dynamic_cast<const BorderedOperator&>(*w);
  EXPECT_TRUE(bordered.has_columns()) << label << ": the obstacle acts";
  w->apply(direction, product);
  const double h = 1e-6;
  Vector there(x, Teuchos::Copy);
  there.update(h, direction, 1.0);
  ASSERT_TRUE(problem.residual(there, f));
  there.update(-2 * h, direction, 1.0);
  ASSERT_TRUE(problem.residual(there, g));
  f.update(-1.0, g, 1.0);
  f.scale(1 / (2 * h));
  f.update(-1.0, product, 1.0);
  EXPECT_LT(f.normInf(), 2e-7 * product.normInf()) << label;
  // Each part for itself: the bodies' rows are large.
  const std::vector<double> row = bordered.globals_of(f);
  for (const double value : row) EXPECT_LT(std::abs(value), 2e-7 * product.normInf()) << label;
}

TEST(RigidBodiesTest, TheTangentIsTheDerivativeOfTheResidual) {
  for (const auto& [dimension, plate] : {std::pair{2, 0.0}, {3, 0.0}, {2, 7.0}, {3, 7.0}})
    for (const char* const scheme : {"Energy-Momentum", "Average Vector Field", "Midpoint", "Newmark",
                                     "Generalized-Alpha", "Bathe Composite", "Gautam-Sauer Composite"}) {
      if (plate > 0 && scheme == std::string("Generalized-Alpha")) continue;  // refused
      RigidScene options;
      options.dimension = dimension;
      options.scheme = scheme;
      options.step = 0.05;
      options.gap = 0.15;
      options.plate = plate;
      expect_tangent(ball_on_block(options), scheme + std::to_string(dimension));
    }
}

/// Other obstacles, contact elements, and a second body before the same surface.
TEST(RigidBodiesTest, ObstaclesOfEachKindHaveTheirTangent) {
  using Numbers = Teuchos::Array<double>;
  RigidScene options;
  options.dimension = 3;
  options.step = 0.05;
  options.gap = 0.25;
  const double top = 2 + options.gap;  // where the ball begins
  for (const char* const scheme : {"Energy-Momentum", "Average Vector Field", "Newmark"}) {
    options.scheme = scheme;
    const auto expect = [&](const std::string& label, const auto& change) {
      Teuchos::ParameterList scene = ball_on_block(options);
      change(scene, scene.sublist("Interactions").sublist("Wall"));
      expect_tangent(scene, scheme + (' ' + label));
    };
    expect("Cylinder", [&](auto&, auto& wall) {
      wall.remove("Sphere");
      wall.set("Obstacle", "Cylinder");
      wall.sublist("Cylinder").set("Radius", 2.0);
      wall.sublist("Cylinder").set("Center", Numbers(Teuchos::tuple(2.2, 2.2, top + 2)));
      wall.sublist("Cylinder").set("Axis", Numbers(Teuchos::tuple(1.0, 0.3, 0.02)));
    });
    expect("Cone", [&](auto&, auto& wall) {
      wall.remove("Sphere");
      wall.set("Obstacle", "Cone");
      wall.sublist("Cone").set("Tip", Numbers(Teuchos::tuple(2.2, 2.2, top)));
      wall.sublist("Cone").set("Axis", Numbers(Teuchos::tuple(0.1, 0.0, -1.0)));
      wall.sublist("Cone").set("Half Angle", 60.0).set("Radius", 0.5);
    });
    expect("Half-Space", [&](auto&, auto& wall) {
      wall.remove("Sphere");
      wall.set("Obstacle", "Half-Space");
      wall.set("Point", Numbers(Teuchos::tuple(2.0, 2.0, top + 0.3)));
      wall.set("Normal", Numbers(Teuchos::tuple(0.05, 0.0, -1.0)));
    });
    for (const char* const rough : {"Sine Wall", "Height Field"})
      expect(rough, [&](auto&, auto& wall) {
        wall.remove("Sphere");
        wall.set("Obstacle", rough);
        Teuchos::ParameterList& shape = wall.sublist(rough);
        shape.set("Point", Numbers(Teuchos::tuple(2.0, 2.0, top + 0.3)));
        shape.set("Normal", Numbers(Teuchos::tuple(0.0, 0.0, -1.0))).set("Gap", "Vertical");
        if (rough == std::string("Sine Wall")) {
          shape.set("Amplitude", 0.05).set("Period", 5.0);
        } else {
          shape.set("File", std::string(IXOS_XML_DIRECTORY) + "/afm-rough.gsf")
              .set("Periodic", true)
              .set("Metre", 1e9)
              .set("Level", "Top");
        }
      });
    expect("Hermite", [&](auto&, auto& wall) { wall.set("Contact Element", "Q1CH"); });
    expect("two bodies", [&](auto& scene, auto& wall) {
      scene.sublist("Rigid Bodies").sublist("Other") = scene.sublist("Rigid Bodies").sublist("Ball");
      scene.sublist("Rigid Bodies").sublist("Other").set("Centre", Numbers(Teuchos::tuple(0.5, 0.5, top + 2)));
      Teuchos::ParameterList& other = scene.sublist("Interactions").sublist("Other") = wall;
      other.set("Rigid Body", "Other");
      other.sublist("Sphere").set("Center", Numbers(Teuchos::tuple(0.5, 0.5, top + 2)));
    });
  }
}

double energy_of(const Simulation& s) { return test::total_energy(s); }

/// A ball and a block that nothing else touches.
TEST(RigidBodiesTest, ImpactsKeepEnergyAndMomenta) {
  for (const auto& [dimension, plate] : {std::pair{2, 0.0}, {3, 0.0}, {2, 7.0}, {3, 7.0}})
    for (const char* const scheme : {"Energy-Momentum", "Average Vector Field"}) {
      RigidScene options;
      options.dimension = dimension;
      options.scheme = scheme;
      options.plate = plate;
      Simulation s(ball_on_block(options), test::world());
      const double energy = energy_of(s);
      const Momenta before = test::report_of(s).momenta();
      double deepest = 1;
      for (int step = 0; step < 60; ++step) {
        ASSERT_TRUE(s.integrator().step(0.02).converged) << scheme << step;
        deepest = std::min(deepest, test::report_of(s).interaction_report().least_gap);
      }
      EXPECT_LT(deepest, 0.3) << "they have met";
      const Momenta after = test::report_of(s).momenta();
      EXPECT_NEAR(energy_of(s), energy, 1e-9 * energy) << scheme << ' ' << dimension;
      for (std::size_t i = 0; i < before.linear.size(); ++i)
        EXPECT_NEAR(after.linear[i], before.linear[i], 1e-9) << scheme;
      const double tolerance = scheme == std::string("Energy-Momentum") ? 1e-8 : 0.05;  // of about 100: second order
      for (std::size_t i = 0; i < before.angular.size(); ++i)
        EXPECT_NEAR(after.angular[i], before.angular[i], tolerance) << scheme << ' ' << dimension;
    }
}

/// Far from the block the body turns freely.
TEST(RigidBodiesTest, TumblingKeepsEnergyAndMomenta) {
  for (const char* const scheme : {"Energy-Momentum", "Average Vector Field", "Midpoint"}) {
    Simulation s(ball_on_block({3, scheme, 0.1, 30, "", "", false, 1000}), test::world());
    const double energy = energy_of(s);
    const Momenta before = test::report_of(s).momenta();
    for (int step = 0; step < 200; ++step) ASSERT_TRUE(s.integrator().step(0.1).converged);
    const Momenta after = test::report_of(s).momenta();
    EXPECT_NEAR(energy_of(s), energy, 1e-12 * energy) << scheme;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(after.linear[i], before.linear[i], 1e-11) << scheme;
      EXPECT_NEAR(after.angular[i], before.angular[i], 1e-9 * 3e4) << scheme;
    }
  }
}

/// A plate that turns carries the block: the accelerations satisfy the balance, so that schemes which begin with them
/// keep their order.
TEST(RigidBodiesTest, CarriedNodesKeepTheOrder) {
  const auto end = [](const char* scheme, int steps) {
    RigidScene options;
    options.scheme = scheme;
    options.step = 1.0 / steps;
    options.plate = 7;
    options.mass = 3;
    options.gap = 0.4;
    Simulation s(ball_on_block(options), test::world());
    for (int step = 0; step < steps; ++step) EXPECT_TRUE(s.integrator().step(1.0 / steps).converged);
    return s.integrator().state().u;
  };
  const std::vector<double> reference = end("Energy-Momentum", 1600);
  for (const char* const scheme : {"Energy-Momentum", "Newmark", "Bathe Composite"}) {
    const double coarse = test::distance(end(scheme, 100), reference),
                 fine = test::distance(end(scheme, 200), reference);
    EXPECT_NEAR(coarse / fine, 4, 0.6) << scheme;
  }
}

/// Halving the step divides the error by four.
TEST(RigidBodiesTest, EverySchemeTumblesToSecondOrder) {
  const auto end = [](const char* scheme, int steps) {
    Simulation s(ball_on_block({3, scheme, 4.0 / steps, 30, "", "", false, 1000}), test::world());
    for (int step = 0; step < steps; ++step) EXPECT_TRUE(s.integrator().step(4.0 / steps).converged);
    const std::vector<double>& u = s.integrator().state().u;
    return std::vector<double>(u.begin() + static_cast<std::ptrdiff_t>(first_of(s)), u.end());
  };
  const std::vector<double> reference = end("Energy-Momentum", 3200);
  for (const char* const scheme : {"Energy-Momentum", "Average Vector Field", "Midpoint", "Newmark",
                                   "Generalized-Alpha", "HHT-Alpha", "Bathe Composite", "Gautam-Sauer Composite"}) {
    const double coarse = test::distance(end(scheme, 50), reference),
                 fine = test::distance(end(scheme, 100), reference);
    EXPECT_GT(coarse, 1e-5) << scheme << ": something turns";
    EXPECT_NEAR(coarse / fine, 4, 0.5) << scheme;
  }
}

}  // namespace
}  // namespace ixos

// Enriched elements in the model: mass, momenta, gaps, null space, probes.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "discretization/material_point.hpp"
#include "interaction/van_der_waals.hpp"
#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "solve/iterative/rigid_body_modes.hpp"
#include "support/bodies.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

#include <Tpetra_MultiVector.hpp>

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

/// The block of 3 by 2, its bottom with that contact element at a gap from a wall.
Simulation block(const std::string& element, double gap = 50) {
  Teuchos::ParameterList scene =
      test::scene(test::block_2d(0.7) +
                  list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -gap}) +
                                                        word("Contact Element", element))) +
                  test::time_integrator("Newmark", 0.1, 1));
  if (element == "Q2C2" || element == "Q2C4") scene.sublist("Mesh").set("Cell Order", 2);
  return Simulation(scene, world());
}

const char* const elements[] = {"Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH", "Q2C2", "Q2C4"};

TEST(EnrichedModelTest, MassAndMomentaOfAnAffineVelocityAreExact) {
  for (const char* element : elements) {
    Simulation s = block(element);
    const State& state = s.integrator().state();  // v = V + L (X - O), L with a spin of 0.7
    const Momenta momenta = StateReport(s.model(), state).momenta();
    EXPECT_NEAR(momenta.linear[0], 6 * 0.3, 1e-12) << element;
    EXPECT_NEAR(momenta.linear[1], 6 * -0.2, 1e-12) << element;
    // About the origin: X_c x P and 0.7 times the moment of inertia about the centre.
    EXPECT_NEAR(momenta.angular[0], 1.5 * 6 * -0.2 - 1.0 * 6 * 0.3 + 0.7 * 6 * (9 + 4) / 12.0, 1e-12) << element;
    const double stretch = (0.15 * 0.15 + 0.49) * 9 / 12.0 + (0.05 * 0.05 + 0.49) * 4 / 12.0;
    EXPECT_NEAR(momenta.kinetic_energy, 0.5 * 6 * (0.09 + 0.04 + stretch), 1e-12) << element;
  }
}

/// Returns the sum of (X + u) x f over all nodes, f the elastic force at another displacement. Collective.
double torque(const Model& model, const std::vector<double>& u, const std::vector<double>& elastic_at) {
  std::vector<double> f(u.size());
  EXPECT_TRUE(TermSums(model).force(Part::Elastic, {nullptr, nullptr, elastic_at.data()}, end_rule(), f.data()));
  const std::vector<double>& x = model.mesh().coordinates;
  double sum = 0;
  for (std::size_t n = 0; n < static_cast<std::size_t>(model.mesh().owned_nodes); ++n)
    sum += (x[2 * n] + u[2 * n]) * f[2 * n + 1] - (x[2 * n + 1] + u[2 * n + 1]) * f[2 * n];
  model.space().sum(&sum, 1);
  return sum;
}

// Newmark's trapezoid changes the angular momentum by the cross torques -dt/4 (x_n x f_n+1 + x_n+1 x f_n) only.
TEST(EnrichedModelTest, LinearMomentumIsKeptAndAngularChangesByTheCrossTorques) {
  // The wall acts on a length of 3, from 49 away or more, with an arm of less than 4.
  const double impulse = 3 * std::abs(VanDerWaals(2.5, 25).traction(49.0)) * 0.4;
  for (const char* element : elements) {
    Simulation s = block(element);
    const auto momenta = [&s] { return test::report_of(s).momenta(); };
    const Momenta start = momenta();
    double change = 0;
    for (int n = 0; n < 20; ++n) {
      const std::vector<double> before = s.integrator().state().u;
      ASSERT_TRUE(s.integrator().step(0.02).converged) << element;
      const std::vector<double>& after = s.integrator().state().u;
      change -= 0.02 / 4 * (torque(s.model(), before, after) + torque(s.model(), after, before));
    }
    EXPECT_NEAR(momenta().linear[0], start.linear[0], 1e-11) << element;
    EXPECT_NEAR(momenta().linear[1], start.linear[1], impulse + 1e-11) << element;
    EXPECT_NEAR(momenta().angular[0], start.angular[0] + change, 4 * impulse + 1e-10) << element;
  }
}

TEST(EnrichedModelTest, GapAndForceOfAParallelSideAreThoseOfTheLaw) {
  const VanDerWaals law(2.5, 25);
  for (const char* element : elements) {
    Simulation s = block(element, 0.28);
    const std::vector<double> rest(static_cast<std::size_t>(s.model().space().local()), 0.0);
    const InteractionReport report = test::ReportAt(s.model(), rest.data()).interaction_report();
    EXPECT_NEAR(report.least_gap, 0.28, 1e-14) << element;
    EXPECT_NEAR(report.measure, 3.0, 1e-13) << element;
    EXPECT_NEAR(report.force[1], 3 * law.traction(0.28), 1e-13) << element;
    EXPECT_NEAR(test::ReportAt(s.model(), rest.data()).energy(Part::Interaction), 3 * law.energy(0.28), 1e-13)
        << element;
  }
}

TEST(EnrichedModelTest, RigidBodyModesCarryNoForce) {
  for (const char* element : elements) {
    Simulation s = block(element);
    const auto modes = rigid_body_modes(s.model());
    const auto local = static_cast<std::size_t>(s.model().space().local());
    for (std::size_t m = 0; m < 3; ++m) {
      std::vector<double> u(local), f(local);
      s.model().space().import(*modes->getVector(m), u.data());
      for (double& value : u) value *= 1e-6;
      TermSums(s.model()).force(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), f.data());
      // A small rotation strains by its square.
      for (std::size_t i = 0; i < static_cast<std::size_t>(s.model().space().owned()); ++i)
        EXPECT_LT(std::abs(f[i]), 2e-11) << element << ", mode " << m;
    }
  }
}

TEST(EnrichedModelTest, AProbeInterpolatesAnAffineField) {
  for (const char* element : elements) {
    Simulation s = block(element);
    const Model& model = s.model();
    for (const std::vector<double>& x : {std::vector{0.0, 0.0}, {2.2, 0.0}, {1.3, 0.4}, {3.0, 2.0}, {0.1, 1.7}}) {
      const MaterialPoint point = locate(model.mesh(), model.space(), x);
      const auto place = point.value(model.space(), s.integrator().state().v);
      EXPECT_NEAR(place[0], 0.3 + 0.15 * (x[0] - 1.5) - 0.7 * (x[1] - 1), 1e-12) << element;
      EXPECT_NEAR(place[1], -0.2 + 0.7 * (x[0] - 1.5) - 0.05 * (x[1] - 1), 1e-12) << element;
    }
    EXPECT_THROW(locate(model.mesh(), model.space(), {3.001, 1.0}), InputError);
    EXPECT_THROW(locate(model.mesh(), model.space(), {-0.5, -0.5}), InputError);
  }
}

}  // namespace
}  // namespace ixos

// The paper's strip on a coarser mesh: every scheme peels it off without cutting a step, on any number of ranks alike;
// quasi-statically it agrees with a beam that knows nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/van_der_waals.hpp"
#include "scene/read/probes.hpp"
#include "scene/simulation.hpp"
#include "support/beam_on_wall.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

std::vector<std::string> settings(const std::string& scheme, const std::string& element, double step,
                                  const std::string& divisions = "{160, 8}") {
  return {"Time Integrator/Type=" + scheme, "Interactions/Wall/Contact Element=" + element,
          "Time Integrator/Time Step Control/Time Step=" + std::to_string(step), "Mesh/Box/Divisions=" + divisions};
}

double pull_off_force(const Simulation& s) {
  const LocalMesh& mesh = s.model().mesh();
  const std::vector<double>& reaction = s.integrator().state().reaction;
  double sum = 0;
  for (int node : mesh.node_sets[mesh.node_set("right")])
    if (node < mesh.owned_nodes) sum += reaction[2 * static_cast<std::size_t>(node) + 1];
  s.model().space().sum(&sum, 1);
  return sum;
}

double lift(const Simulation& s) { return probe_value(s.probes().front(), "uy", s.model(), s.integrator().state()); }

/// Pulls in steps of 1 until the far end of the strip has risen. No step may fail, and nothing may adhere at the end.
void peel_off(const std::string& scheme, const std::string& element, const std::string& divisions) {
  SCOPED_TRACE(scheme + ", " + element);
  Simulation s(test::scene_file("strip.xml", settings(scheme, element, 1.0, divisions)), world());
  ASSERT_EQ(s.probes().front().name, "P");
  while (lift(s) < 9.8 && s.integrator().time() < 159) {
    const StepResult result = s.integrator().step(1.0);
    ASSERT_TRUE(result.converged) << "t = " << s.integrator().time() << ": " << result.reason;
  }
  ASSERT_GE(lift(s), 9.8);
  EXPECT_EQ(test::report_of(s).interaction_report().measure, 0);
}

TEST(StripSerialTest, SchemesPeelItOffAtALargeStepWithoutACut) {
  peel_off("Bathe Composite", "Q1C1", "{160, 8}");
  peel_off("Gautam-Sauer Composite", "Q1C4", "{160, 8}");
}

TEST(StripLongTest, EverySchemePeelsItOffAtALargeStepWithoutACut) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"})
    for (const char* element : {"Q1C1", "Q1C4"}) peel_off(scheme, element, "{160, 8}");
}

TEST(StripSerialTest, QuasiStaticPullOffForceIsThatOfATimoshenkoBeam) {
  const VanDerWaals law(2.5, 25);
  const auto beam = test::peel(test::BeamOnWall{}, law, 0.05, 20.0);
  const auto force = [](const test::PullOff& a, const test::PullOff& b) { return a.force < b.force; };
  const double expected = std::max_element(beam.begin(), beam.end(), force)->force;
  Simulation s(test::scene_file("strip.xml", settings("Static", "Q1C2", 0.5, "{80, 4}")), world());
  double peak = 0;
  while (s.integrator().time() < 45) {
    ASSERT_TRUE(s.integrator().step(0.5).converged);
    peak = std::max(peak, pull_off_force(s));
  }
  EXPECT_NEAR(peak, expected, 0.15 * expected);
  // On the body act the pull and the wall, and nothing else.
  const double wall = test::report_of(s).interaction_report().force[1];
  EXPECT_NEAR(pull_off_force(s), -wall, 1e-9);
}

TEST(StripLongTest, SlowPeelingTendsToTheStaticOne) {
  // Force at one displacement of the edge, soon after the peak, for rates of 1, 1/4 and 0; ramp and step grow alike.
  const auto force = [](const std::string& scheme, double rate) {
    auto list = settings(scheme, "Q1C2", 0.5 / rate);
    list.push_back("Histories/Pull/Rate Ramp/Rate=" + std::to_string(rate));
    list.push_back("Histories/Pull/Rate Ramp/Length=" + std::to_string(55 / rate));
    list.push_back("Time Integrator/Time Step Control/Final Time=" + std::to_string(160 / rate));
    Simulation s(test::scene_file("strip.xml", list), world());
    for (int n = 0; n < 90; ++n) EXPECT_TRUE(s.integrator().step(0.5 / rate).converged);
    return pull_off_force(s);
  };
  const double slow = force("Static", 1.0);
  const double one = std::abs(force("Newmark", 1.0) - slow), quarter = std::abs(force("Newmark", 0.25) - slow);
  EXPECT_LT(quarter, 0.35 * one) << one;
}

TEST(StripSerialTest, EnergyOfTheDrivenStripIsItsWork) {
  Simulation s(test::scene_file("strip.xml", settings("Average Vector Field", "Q1C4", 0.2, "{80, 4}")), world());
  const double start = test::total_energy(s);
  while (s.integrator().time() < 20) {
    ASSERT_TRUE(s.integrator().step(0.2).converged);
    ASSERT_NEAR(test::total_energy(s) - start, s.integrator().external_work(), 1e-8);
  }
  EXPECT_GT(s.integrator().external_work(), 1e-3) << "the balance was tested on nothing";
}

TEST(StripTest, RanksAgree) {
  for (const char* element : {"Q1C1", "Q1C4", "Q1CH"}) {
    const auto scene = test::scene_file("strip.xml", settings("Bathe Composite", element, 1.0, "{80, 4}"));
    Simulation whole(scene, world());
    Simulation alone(scene, test::self());
    for (int n = 0; n < 45; ++n) {
      ASSERT_TRUE(whole.integrator().step(1.0).converged) << element;
      ASSERT_TRUE(alone.integrator().step(1.0).converged) << element;
    }
    EXPECT_NEAR(pull_off_force(whole), pull_off_force(alone), 1e-8);
    EXPECT_NEAR(whole.integrator().external_work(), alone.integrator().external_work(), 1e-8);
    EXPECT_NEAR(lift(whole), lift(alone), 1e-8);
    EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                             test::gathered(alone.model(), alone.integrator().state().u)),
              1e-7)
        << element;
  }
}

}  // namespace
}  // namespace ixos

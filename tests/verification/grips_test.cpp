// Grips against closed forms: bodies that turn rigidly, and bodies on springs and dashpots.
#include <gtest/gtest.h>

#include <cmath>

#include "model/grips.hpp"
#include "run/history.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;
using test::world;

/// A block of 3 by 2 with a corner at the origin, density 1, E 1: mass 6, moment of inertia 6.5 about its centre.
std::string block() {
  return list("Mesh", word("Type", "Box") +
                          list("Box", numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2})) +
                          list("Sets", list("all", word("Kind", "Nodes")))) +
         list("Materials", list("Rubber", number("Poisson's Ratio", 0.3) + number("Density", 1)));
}

std::string grip(const std::string& name, const std::string& set, const std::string& contents) {
  return list("Grips", list(name, word("Node Set", set) + contents));
}

Simulation simulation(const std::string& scheme, double dt, double final_time, const std::string& lists) {
  return {test::scene(block() + lists + test::time_integrator(scheme, dt, final_time)), world()};
}

GripReaction reaction(const Simulation& s) {
  const State& state = s.integrator().state();
  return grip_reaction(s.model(), s.model().grips().at(0), s.integrator().time(), state.u, state.v, state.reaction);
}

double total_energy(const Simulation& s) {
  const State& state = s.integrator().state();
  return StateReport(s.model(), state).momenta().kinetic_energy + test::report_of(s).elastic_energy();
}

double balance(const Simulation& s) {
  return total_energy(s) - s.integrator().external_work() + s.integrator().dissipated_energy();
}

void take_steps(Simulation& s, double dt, int count) {
  for (int n = 0; n < count; ++n) {
    const StepResult result = s.integrator().step(dt);
    ASSERT_TRUE(result.converged) << s.integrator().table().name << ", step " << n << ": " << result.reason;
  }
}

std::string turning_block() {
  return list("Histories", test::expression("Turn", "0.5*t^2", "t", "1")) +
         grip("Jaw", "all", word("Rotation", "Turn") + numbers("Point", {1.5, 1}));
}

// Three radians in all: no strain, and nothing but inertia resists.
TEST(GripsTest, ABodyThatTurnsRigidlyHasNoStrain) {
  const double dt = 0.01;
  Simulation s = simulation("Newmark", dt, 3, turning_block());
  EXPECT_NEAR(reaction(s).moment.at(0), 6.5, 1e-12);
  take_steps(s, dt, 245);
  const State& state = s.integrator().state();
  const double rate = 2.45;
  EXPECT_NEAR(StateReport(s.model(), state).energy(Part::Elastic), 0, 1e-14);
  EXPECT_NEAR(StateReport(s.model(), state).momenta().kinetic_energy, 6.5 * rate * rate / 2, 1e-11);
  const GripReaction own = reaction(s);
  EXPECT_NEAR(own.moment.at(0), 6.5, 1e-10);
  EXPECT_NEAR(own.force.at(0), 0, 1e-10);
  EXPECT_NEAR(own.force.at(1), 0, 1e-10);
  EXPECT_NEAR(s.integrator().external_work(), 6.5 * rate * rate / 2, 1e-3);
}

TEST(GripsTest, TheBalanceOfARigidRotationClosesInEveryScheme) {
  for (const std::string& scheme : test::moving_schemes()) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const double dt = 0.02 / (k + 1);
      Simulation s = simulation(scheme, dt, 1, turning_block());
      const double first = balance(s);
      take_steps(s, dt, 50 * (k + 1));
      error[k] = std::abs(balance(s) - first);
    }
    // The error of the scheme itself, the energy is 3.25. Reactions of alpha schemes are weighted means over the step,
    // whose work is of first order.
    const bool alpha = scheme.find("Alpha") != std::string::npos;
    EXPECT_LT(error[0], alpha ? 0.02 : 2e-3) << scheme;
    EXPECT_LT(error[1], (alpha ? 0.55 : 0.3) * error[0] + 1e-10) << scheme;
  }
}

TEST(GripsTest, ABodyOnSpringsVibratesWithTheFrequencyOfItsMass) {
  const double stiffness = 6e-6, w = std::sqrt(stiffness / 6), dt = 0.1 / w;
  Simulation s =
      simulation("Newmark", dt, 100 * dt,
                 grip("Machine", "all", word("Type", "Springs") + numbers("Stiffness", {stiffness, stiffness})) +
                     list("Initial Conditions", numbers("Velocity", {0, 1e-4})));
  const double own = 2 / dt * std::atan(w * dt / 2);  // the frequency of the trapezoidal rule
  for (int n = 1; n <= 10; ++n) {
    take_steps(s, dt, 10);
    EXPECT_NEAR(reaction(s).force.at(1), -stiffness * 1e-4 / w * std::sin(own * 10 * n * dt), 2e-4 * 6e-7);
  }
}

TEST(GripsTest, DashpotsBrakeABodyExponentially) {
  const double damping = 6e-3, v0 = 1e-3, dt = 1;
  Simulation s = simulation("Newmark", dt, 500,
                            grip("Brake", "all", word("Type", "Springs") + numbers("Damping", {damping, 0})) +
                                list("Initial Conditions", numbers("Velocity", {v0, 0})));
  take_steps(s, dt, 500);
  const State& state = s.integrator().state();
  const double share = std::exp(-0.5);
  EXPECT_NEAR(StateReport(s.model(), state).momenta().linear.at(0), 6 * v0 * share, 6 * v0 * 1e-3);
  ASSERT_EQ(s.model().dissipation_names(), std::vector<std::string>{"dashpots of Brake"});
  EXPECT_NEAR(s.integrator().dissipations().at(0), 3 * v0 * v0 * (1 - share * share), 3 * v0 * v0 * 2e-3);
  EXPECT_EQ(s.integrator().external_work(), 0);
}

// m v' = c (V - v): what the machine works is not what the dashpots dissipate.
TEST(GripsTest, AMovingDashpotDragsABodyAlong) {
  const double damping = 6e-3, speed = 1e-3, dt = 1;
  for (const std::string& scheme : test::moving_schemes()) {
    if (scheme == "Central Difference") continue;  // its steps are short
    Simulation s = simulation(
        scheme, dt, 400,
        list("Histories", test::expression("Go", "0.001*t", "0.001", "0")) +
            grip("Tow", "all",
                 word("Type", "Springs") + texts("Translation", "{Go, -}") + numbers("Damping", {damping, 0})));
    take_steps(s, dt, 400);
    const double share = std::exp(-0.4), energy = 6 * speed * speed;
    EXPECT_NEAR(s.integrator().external_work(), energy * (1 - share), 2e-3 * energy) << scheme;
    EXPECT_NEAR(s.integrator().dissipated_energy(), energy / 2 * (1 - share * share), 2e-3 * energy) << scheme;
    EXPECT_NEAR(total_energy(s), energy / 2 * (1 - share) * (1 - share), 2e-3 * energy) << scheme;
  }
}

// A linear spring in series with the body: work W = F w/2, stored in both.
TEST(GripsTest, ATestingMachineStoresItsShareOfTheWork) {
  Simulation s = simulation(
      "Static", 1, 1,
      list("Histories",
           list("Pull", word("Type", "Ramp") + list("Ramp", number("Value", 1e-5) + number("Length", 1)))) +
          list("Boundary Conditions", list("Hold", word("Node Set", "right"))) +
          grip("Machine", "left",
               word("Type", "Springs") + texts("Translation", "{Pull, -}") + numbers("Stiffness", {0.5, 0.5})));
  take_steps(s, 1, 1);
  const double force = reaction(s).force.at(0), work = force * 1e-5 / 2;
  EXPECT_GT(force, 1e-6);
  EXPECT_NEAR(s.integrator().external_work() / work, 1, 1e-4);
  EXPECT_NEAR(total_energy(s) / work, 1, 1e-4);
}

TEST(GripsTest, TheBalanceOfADrivenMachineClosesInEveryScheme) {
  for (const std::string& scheme : test::moving_schemes()) {
    const double dt = 0.01;
    Simulation s = simulation(
        scheme, dt, 1,
        list("Histories",
             test::expression("Go", "0.1*t^2", "0.2*t", "0.2") + test::expression("Turn", "0.5*t^2", "t", "1")) +
            grip("Tow", "left",
                 word("Type", "Springs") + texts("Translation", "{Go, -}") + word("Rotation", "Turn") +
                     numbers("Point", {0, 1}) + numbers("Stiffness", {3, 2}) + numbers("Damping", {0.1, 0.2})));
    const double first = balance(s);
    take_steps(s, dt, 100);
    EXPECT_GT(s.integrator().external_work(), 1e-3) << scheme;
    EXPECT_GT(s.integrator().dissipated_energy(), 1e-5) << scheme;
    const bool alpha = scheme.find("Alpha") != std::string::npos;  // of first order, see above
    EXPECT_NEAR(balance(s), first, (alpha ? 2e-2 : 2e-4) * s.integrator().external_work()) << scheme;
  }
}

TEST(GripsTest, TheMomentIsThatOfTheForcesOnTheOtherSide) {
  Simulation s = simulation(
      "Static", 1, 1,
      list("Boundary Conditions",
           list("Push", word("Type", "Point Force") + word("Node Set", "right") + numbers("Vector", {0.002, 0.004}))) +
          grip("Jaw", "left", numbers("Point", {-1, 0.5})));
  take_steps(s, 1, 1);
  const LocalMesh& mesh = s.model().mesh();
  double moment = 0;
  for (const int node : mesh.node_sets[mesh.node_set("right")]) {
    if (node >= mesh.owned_nodes) continue;
    const std::size_t i = 2 * static_cast<std::size_t>(node);
    const std::vector<double>& u = s.integrator().state().u;
    moment += (mesh.coordinates[i] + u[i] + 1) * 0.004 - (mesh.coordinates[i + 1] + u[i + 1] - 0.5) * 0.002;
  }
  s.model().space().sum(&moment, 1);
  const GripReaction own = reaction(s);
  EXPECT_NEAR(own.force.at(0), -3 * 0.002, 1e-12);
  EXPECT_NEAR(own.force.at(1), -3 * 0.004, 1e-12);
  EXPECT_NEAR(own.moment.at(0), -moment, 1e-11);
}

TEST(GripsTest, MatrixFreeAndAssembledStepsAgree) {
  std::vector<double> ends[2];
  for (const bool free : {false, true}) {
    Simulation s = simulation(
        "Newmark", 0.2, 4,
        list("Histories", test::expression("Go", "0.1*t^2", "0.2*t", "0.2")) +
            grip("Tow", "left",
                 word("Type", "Springs") + texts("Translation", "{Go, -}") + numbers("Stiffness", {3, 2}) +
                     numbers("Damping", {1, 2})) +
            list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev") +
                                      word("Operator", free ? "Matrix-Free" : "Assembled")));
    take_steps(s, 0.2, 20);
    ends[free ? 1 : 0] = s.integrator().state().u;
  }
  for (std::size_t i = 0; i < ends[0].size(); ++i) EXPECT_NEAR(ends[1][i], ends[0][i], 1e-8);
}

TEST(GripsTest, AnAngleMayBeGivenInDegrees) {
  Simulation s = simulation(
      "Static", 1, 1,
      list("Histories",
           list("Turn", word("Type", "Ramp") + list("Ramp", word("Value", "90 deg") + number("Length", 1)))) +
          grip("Jaw", "left", word("Rotation", "Turn") + numbers("Point", {-1, 0})));
  std::vector<double> u(static_cast<std::size_t>(s.model().space().local()));
  s.model().constraints().set(1, u.data(), nullptr, nullptr);
  const LocalMesh& mesh = s.model().mesh();
  for (const int node : mesh.node_sets[mesh.node_set("left")]) {
    const std::size_t i = 2 * static_cast<std::size_t>(node);
    const double y = mesh.coordinates[i + 1];  // r = (1, y) goes to (-y, 1)
    EXPECT_NEAR(u[i], -y - 1, 1e-14);
    EXPECT_NEAR(u[i + 1], 1 - y, 1e-14);
  }
}

TEST(GripsTest, BadScenesAreRefusedWithTheirPlace) {
  const auto message = [](const std::string& lists) {
    return test::refusal([&] { simulation("Static", 1, 1, lists); });
  };
  test::expect_contains(message(grip("Jaw", "lft", "")), "Grips/Jaw/Node Set: ");
  test::expect_contains(message(grip("Jaw", "", "")), "Grips/Jaw/Node Set is missing");
  test::expect_contains(message(grip("Jaw", "left", word("Rotation", "Trn"))), "Grips/Jaw/Rotation: history \"Trn\"");
  test::expect_contains(message(grip("Jaw", "left", texts("Translation", "{Go}"))),
                        "Grips/Jaw/Translation has 1 elements, not 2");
  test::expect_contains(message(grip("Jaw", "left", numbers("Axis", {0, 0, 1}))), "Grips/Jaw/Axis: an axis is given");
  test::expect_contains(message(grip("Jaw", "left", word("Type", "Springs"))),
                        "Grips/Jaw: the grip has neither a stiffness nor a damping");
  test::expect_contains(message(grip("Jaw", "left", numbers("Stiffness", {1, 1}))), "Grips/Jaw");
  test::expect_contains(message(grip("Jaw", "left", word("Type", "Springs") + numbers("Damping", {1, 1}))),
                        "Grips/Jaw: the grip has a damping, but without inertia");
  test::expect_contains(
      message(list("Histories", test::expression("Go", "t", "1", "0")) + grip("Jaw", "left", "") +
              list("Boundary Conditions", list("Hold", word("Node Set", "left") + word("History", "Go")))),
      "two conditions prescribe different motions");
  test::expect_contains(message(grip("left", "left", "") + list("Output", texts("Reactions", "{left}"))),
                        "Grips/left: history.csv has a column \"reaction_left_x\" already");
}

// The nodes that a contact element adds, derivatives along the side among them, turn with the body. A node set that the
// mesh had before holds them too.
TEST(GripsTest, EnrichedSidesTurnRigidly) {
  for (const char* element : {"Q1C2", "Q1C4", "Q1CH"}) {
    Simulation s = simulation("Newmark", 0.02, 1,
                              turning_block() + list("Interactions", list("Wall", word("Side Set", "bottom") +
                                                                                      word("Contact Element", element) +
                                                                                      numbers("Point", {0, -100}))));
    const double moment = reaction(s).moment.at(0);
    EXPECT_NEAR(moment, 6.5, 1e-6) << element;
    take_steps(s, 0.02, 50);
    const State& state = s.integrator().state();
    EXPECT_NEAR(StateReport(s.model(), state).energy(Part::Elastic), 0, 1e-13) << element;
    EXPECT_NEAR(StateReport(s.model(), state).momenta().kinetic_energy, 3.25, 1e-6) << element;
    EXPECT_NEAR(reaction(s).moment.at(0), 6.5, 1e-6) << element;
  }
}

TEST(GripsTest, HistoryHasForceAndMomentOfEachGrip) {
  Simulation s = simulation("Newmark", 0.1, 1, turning_block());
  History history(s);
  history.record({});
  ASSERT_EQ(history.forces().size(), 2U);
  EXPECT_EQ(history.forces()[0].first, "reaction_Jaw_x");
  EXPECT_EQ(history.max_forces()[1].first, "reaction_Jaw_y");
}

TEST(GripsTest, TheExplanationNamesThem) {
  const Simulation s = simulation("Newmark", 0.1, 1, turning_block());
  test::expect_contains(explain(s), "Grip Jaw: node set \"all\", rigid, driven by history Turn");
}

}  // namespace
}  // namespace ixos

// Rigid bodies that move by themselves: springs, prescribed motions, extreme masses, symmetries, equilibrium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/grips.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/rigid_scene.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {
namespace {

double closed_balance(const Simulation& s) {
  const StateReport report = report_of(s);
  return report.momenta().kinetic_energy + report.elastic_energy() + report.energy(Part::Interaction) -
         s.integrator().external_work() + s.integrator().dissipated_energy();
}

const double* body_u(const Simulation& s) { return &s.integrator().state().u[s.model().first_number(0)]; }
const double* body_v(const Simulation& s) { return &s.integrator().state().v[s.model().first_number(0)]; }

void go(Simulation& s, double step, int count) {
  for (int i = 0; i < count; ++i) {
    const StepResult result = s.integrator().step(step);
    ASSERT_TRUE(result.converged) << result.reason;
  }
}

/// A body of mass 4 on a spring of stiffness 1, far from all others: T = -0.5 sin(t/2)/0.5 along y.
TEST(RigidBodiesTest, ABodyOnASpringOscillates) {
  for (const char* const scheme : {"Energy-Momentum", "Newmark", "Bathe Composite"}) {
    RigidScene options;
    options.scheme = scheme;
    options.mass = 4;
    options.gap = 1e4;
    options.body = numbers("Stiffness", {0, 1});
    const auto error = [&](int steps) {
      options.step = 4.0 / steps;
      Simulation s(ball_on_block(options), world());
      const double start = total_energy(s);
      go(s, options.step, steps);
      if (scheme == std::string("Energy-Momentum")) {
        EXPECT_NEAR(closed_balance(s), start, 1e-12) << scheme;
      }
      return std::abs(body_u(s)[1] + std::sin(2.0));
    };
    EXPECT_NEAR(error(50) / error(100), 4, 0.2) << scheme;
  }
}

/// The base of spring and dashpot moves: its work is external.
TEST(RigidBodiesTest, ABaseWorksOnTheBody) {
  RigidScene options;
  options.mass = 4;
  options.gap = 1e4;
  options.body = numbers("Stiffness", {0, 1}) + numbers("Damping", {0, 0.3}) + texts("Base", "{-, Up}");
  options.more = list("Histories", expression("Up", "0.2*sin(t)", "0.2*cos(t)", "-0.2*sin(t)"));
  Simulation s(ball_on_block(options), world());
  const double start = total_energy(s);
  go(s, 0.02, 200);
  EXPECT_GT(std::abs(s.integrator().external_work()), 0.01);
  EXPECT_GT(s.integrator().dissipated_energy(), 0.01);
  // The load of the base is a mean by Gauss points, the spring's force is not: second order.
  EXPECT_NEAR(closed_balance(s), start, 1e-4);
}

/// A body all of whose directions are prescribed or held is the obstacle with that motion.
TEST(RigidBodiesTest, APrescribedBodyIsAMovedObstacle) {
  for (const int dimension : {2, 3}) {
    const std::string histories =
        list("Histories", expression("Down", "-0.3*t", "-0.3", "0") + expression("Turn", "0.2*t", "0.2", "0"));
    const bool solid = dimension == 3;
    const std::string ways = texts("Translation", solid ? "{-, -, Down}" : "{-, Down}") + word("Rotation", "Turn") +
                             (solid ? numbers("Axis", {1, 2, 2}) : "");
    RigidScene options;
    options.dimension = dimension;
    options.ball_rests = true;
    options.body = ways + texts("Held", solid ? "{x, y}" : "{x}");
    options.more = histories;
    Simulation carried(ball_on_block(options), world());
    Teuchos::ParameterList scene = ball_on_block(options);
    Teuchos::ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
    wall.remove("Rigid Body");
    wall.sublist("Motion").setParameters(test::scene(list("Mesh", ways)).sublist("Mesh"));
    wall.sublist("Motion").set("Point",
                               scene.sublist("Rigid Bodies").sublist("Ball").get<Teuchos::Array<double>>("Centre"));
    scene.remove("Rigid Bodies");
    Simulation moved(scene, world());
    go(carried, 0.02, 50);
    go(moved, 0.02, 50);
    EXPECT_EQ(carried.integrator().state().u, moved.integrator().state().u);
    EXPECT_EQ(carried.integrator().external_work(), moved.integrator().external_work());
    EXPECT_GT(std::abs(moved.integrator().external_work()), 1e-3);
  }
}

/// Driven downwards by a history, free along the block and about itself.
TEST(RigidBodiesTest, WhatDrivesABodyWorks) {
  for (const char* const scheme : {"Energy-Momentum", "Average Vector Field"}) {
    RigidScene options;
    options.scheme = scheme;
    options.mass = 3;
    options.ball_rests = true;
    options.body = texts("Translation", "{-, Down}") + numbers("Velocity", {0.2, 0}) + numbers("Spin", {0.3});
    options.more = list("Histories", expression("Down", "-0.5*t + 0.02*t^3", "-0.5 + 0.06*t^2", "0.12*t"));
    Simulation s(ball_on_block(options), world());
    const double start = total_energy(s);
    go(s, 0.02, 60);
    EXPECT_NEAR(body_u(s)[1], -0.5 * 1.2 + 0.02 * 1.728, 1e-14);
    EXPECT_GT(std::abs(s.integrator().external_work()), 1e-3) << scheme;
    EXPECT_NEAR(closed_balance(s), start, 1e-9) << scheme;
    EXPECT_NE(body_u(s)[0], 0);
  }
}

/// Driven, too, in schemes with the exact velocities of what is driven; a held body moves one side of the block on some
/// ranks only.
TEST(RigidBodiesTest, WhatDrivesABodyWorksToSecondOrderInNewmark) {
  const auto error = [](double step) {
    RigidScene options;
    options.scheme = "Newmark";
    options.mass = 30;
    options.step = step;
    options.ball_rests = true;
    options.gap = 2;
    options.body = texts("Translation", "{-, Down}") + texts("Held", "{x}");
    options.more = list("Histories", expression("Down", "-0.5*sin(t)", "-0.5*cos(t)", "0.5*sin(t)")) +
                   list("Boundary Conditions",
                        list("Side", word("Node Set", "left") + word("Components", "x") + word("History", "Down")));
    Simulation s(ball_on_block(options), world());
    const double start = closed_balance(s);
    double largest = 0;
    for (int i = 0; i < std::lround(1 / step); ++i) {
      go(s, step, 1);
      largest = std::max(largest, std::abs(closed_balance(s) - start));
    }
    return largest;
  };
  EXPECT_GT(error(0.02) / error(0.01), 3);
}

/// The block has the mass 32, the bodies 1e-6 and 1e6 of it.
TEST(RigidBodiesTest, LightAndHeavyBodiesKeepTheEnergy) {
  for (const double ratio : {1e-6, 1e6}) {
    RigidScene options;
    options.mass = 32 * ratio;
    options.step = 0.01;
    options.held = ratio > 1;
    options.gap = 0.3;
    Simulation s(ball_on_block(options), world());
    const double start = total_energy(s);
    double largest = 0;
    for (int step = 0; step < 60; ++step) {
      go(s, 0.01, 1);
      largest = std::max({largest, report_of(s).momenta().kinetic_energy, report_of(s).elastic_energy()});
    }
    EXPECT_NEAR(total_energy(s), start, 1e-10 * largest) << ratio;
    EXPECT_LT(report_of(s).interaction_report().least_gap, 0.3) << ratio;
  }
}

/// The scene in a mirror x -> 8 - x.
TEST(RigidBodiesTest, AMirrorChangesNothing) {
  RigidScene options;
  options.mass = 3;
  Teuchos::ParameterList scene = ball_on_block(options);
  Simulation s(scene, world());
  using Numbers = Teuchos::Array<double>;
  Teuchos::ParameterList& ball = scene.sublist("Rigid Bodies").sublist("Ball");
  const Numbers centre = ball.get<Numbers>("Centre"), velocity = ball.get<Numbers>("Velocity");
  const Numbers mirrored = Teuchos::tuple(8 - centre[0], centre[1]);
  ball.set("Centre", mirrored);
  ball.set("Velocity", Numbers(Teuchos::tuple(-velocity[0], velocity[1])));
  ball.set("Spin", Numbers(Teuchos::tuple(-ball.get<Numbers>("Spin")[0])));
  scene.sublist("Interactions").sublist("Wall").sublist("Sphere").set("Center", mirrored);
  Simulation t(scene, world());
  go(s, 0.02, 60);
  go(t, 0.02, 60);
  EXPECT_NEAR(total_energy(s), total_energy(t), 1e-12);
  const double signs[] = {-1, 1, 0, 0, 0, -1};
  for (const std::size_t i : {0, 1, 5}) EXPECT_NEAR(body_v(s)[i], signs[i] * body_v(t)[i], 1e-10) << i;
}

/// The scene in space with its axes renamed, z, x, y for x, y, z: a turn by 120 degrees.
TEST(RigidBodiesTest, ATurnChangesNothing) {
  RigidScene options;
  options.dimension = 3;
  options.mass = 3;
  Teuchos::ParameterList scene = ball_on_block(options);
  Simulation s(scene, world());
  const auto turn = [](Teuchos::ParameterList& list, const char* name, const auto& of) {
    Teuchos::Array<std::decay_t<decltype(of)>> values = list.get<Teuchos::Array<std::decay_t<decltype(of)>>>(name);
    std::rotate(values.begin(), values.end() - 1, values.end());
    list.set(name, values);
  };
  Teuchos::ParameterList& box = scene.sublist("Mesh").sublist("Box");
  turn(box, "Lengths", 0.0);
  turn(box, "Divisions", 0);
  Teuchos::ParameterList& ball = scene.sublist("Rigid Bodies").sublist("Ball");
  for (const char* const name : {"Inertia", "Centre", "Velocity", "Spin"}) turn(ball, name, 0.0);
  Teuchos::ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
  wall.set("Side Set", "right");
  turn(wall.sublist("Sphere"), "Center", 0.0);
  Simulation t(scene, world());
  go(s, 0.02, 60);
  go(t, 0.02, 60);
  EXPECT_NEAR(total_energy(s), total_energy(t), 1e-11);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(body_v(s)[i], body_v(t)[(i + 1) % 3], 1e-9) << i;
    EXPECT_NEAR(body_v(s)[3 + i], body_v(t)[3 + (i + 1) % 3], 1e-9) << i;
  }
}

/// Lengths in units that are 10 times smaller, stresses 100 times larger, times 3 times longer.
TEST(RigidBodiesTest, UnitsChangeNothing) {
  const double length = 10, stress = 0.01, time = 1.0 / 3;  // of old units in new ones
  RigidScene options;
  options.mass = 3;
  Teuchos::ParameterList scene = ball_on_block(options);
  Simulation s(scene, world());
  using Numbers = Teuchos::Array<double>;
  const auto scale = [](Teuchos::ParameterList& list, const char* name, double factor) {
    Numbers values = list.get<Numbers>(name);
    for (double& value : values) value *= factor;
    list.set(name, values);
  };
  scale(scene.sublist("Mesh").sublist("Box"), "Lengths", length);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Block");
  material.set("Density", stress * time * time / (length * length));
  material.set("Young's Modulus", stress);
  Teuchos::ParameterList& ball = scene.sublist("Rigid Bodies").sublist("Ball");
  const double mass = stress * time * time;  // per depth
  ball.set("Mass", 3 * mass);
  scale(ball, "Inertia", mass * length * length);
  scale(ball, "Centre", length);
  scale(ball, "Velocity", length / time);
  scale(ball, "Spin", 1 / time);
  Teuchos::ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
  scale(wall.sublist("Sphere"), "Center", length);
  wall.sublist("Sphere").set("Radius", 2 * length);
  wall.set("Gamma L", 2.5 / length).set("Gamma W", 25 / stress);
  scene.sublist("Time Integrator")
      .sublist("Time Step Control")
      .set("Time Step", 0.02 * time)
      .set("Final Time", 2 * time);
  Simulation t(scene, world());
  EXPECT_NEAR(total_energy(t), total_energy(s) * stress * length * length, 1e-12);
  go(s, 0.02, 60);
  go(t, 0.02 * time, 60);
  EXPECT_NEAR(body_u(t)[1], length * body_u(s)[1], 1e-9);
  EXPECT_NEAR(body_v(t)[5], length / time * body_v(s)[5], 1e-8);
}

/// A force presses the ball on a held block: in equilibrium the block pushes back as strongly.
TEST(RigidBodiesTest, ABodyFindsItsPlaceInEquilibrium) {
  for (const char* const op : {"Assembled", "Matrix-Free"}) {
    RigidScene options;
    options.dimension = 3;
    options.scheme = "Static";
    options.step = 0.1;
    options.held = true;
    options.gap = 0.25;
    options.ball_rests = true;
    options.body =
        numbers("Force", {0, 0, -0.5}) + word("Force History", "Press") + texts("Held", "{x, y, rx, ry, rz}");
    const std::string solver =
        op == std::string("Assembled")
            ? ""
            : list("Linear Solver", word("Linear Solver Type", "Belos") + word("Operator", "Matrix-Free"));
    options.more = list("Histories", expression("Press", "t")) + solver;
    Simulation s(ball_on_block(options), world());
    go(s, 0.1, 10);
    EXPECT_NEAR(report_of(s).interaction_report().force[2], -0.5, 1e-7) << op;
    EXPECT_LT(body_u(s)[2], 0);
  }
}

/// A plate on top of a held block is pressed and turned: the block pushes and turns back.
TEST(RigidBodiesTest, APlateFindsItsPlaceInEquilibrium) {
  const std::string plate =
      list("Plate", numbers("Centre", {4, 4.5}) + numbers("Force", {0.2, -0.5}) + word("Force History", "Press") +
                        numbers("Moment", {0.3}) + word("Moment History", "Press"));
  const std::string text =
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {8, 4}) + counts("Divisions", {16, 8}))) +
      list("Materials", list("Block", "")) + list("Rigid Bodies", plate) +
      list("Grips", list("Glue", word("Node Set", "top") + word("Rigid Body", "Plate"))) +
      list("Boundary Conditions", list("Floor", word("Node Set", "bottom"))) +
      list("Histories", expression("Press", "t")) + list("Output", texts("Reactions", "{bottom}"));
  Simulation s(scene(text + time_integrator("Static", 0.1, 1)), world());
  go(s, 0.1, 10);
  EXPECT_LT(body_u(s)[1], 0);
  EXPECT_GT(body_u(s)[0], 0);
  const Grip& grip = s.model().grips()[0];
  const State& state = s.integrator().state();
  const GripReaction reaction = grip_reaction(s.model(), grip, s.integrator().time(), state.u, state.v, state.reaction);
  EXPECT_NEAR(reaction.force[0], 0.2, 1e-9);
  EXPECT_NEAR(reaction.force[1], -0.5, 1e-9);
  EXPECT_NEAR(reaction.moment[0], 0.3, 1e-9);
}

TEST(RigidBodiesTest, MatrixFreeIsAssembled) {
  std::vector<double> ends[2];
  for (const bool free : {false, true}) {
    RigidScene options;
    options.dimension = 3;
    options.scheme = "Average Vector Field";
    options.mass = 3;
    options.gap = 0.3;
    if (free)
      options.more = list("Linear Solver", word("Linear Solver Type", "Belos") + word("Operator", "Matrix-Free"));
    Simulation s(ball_on_block(options), world());
    go(s, 0.02, 30);
    ends[free ? 1 : 0] = s.integrator().state().u;
  }
  EXPECT_LT(distance(ends[0], ends[1]), 1e-8);
}

/// The impulse on the block along y up to each of 60 steps, about.
std::vector<double> impulses(Simulation& s) {
  std::vector<double> sums;
  double sum = 0;
  for (int step = 0; step < 60; ++step) {
    go(s, 0.02, 1);
    sums.push_back(sum += 0.02 * report_of(s).interaction_report().force[1]);
  }
  return sums;
}

/// The impulse on the block up to each step from an elastic disk of the rigid one's mass; its modulus in units of the
/// block's.
std::vector<double> impulses_of_elastic_disk(double modulus, double radius, double height, double density) {
  const auto material = [](const char* block, double stiffness, double rho) {
    return list(block, word("Block", block) + number("Young's Modulus", stiffness) + number("Density", rho));
  };
  const std::string disk =
      list("disk", word("Type", "Disk") + list("Disk", number("Diameter", 2 * radius) + numbers("Center", {4, height}) +
                                                           count("Core Divisions", 24)));
  const std::string block =
      list("block", word("Type", "Box") + list("Box", numbers("Lengths", {8, 4}) + counts("Divisions", {32, 12})));
  const std::string contact =
      list("Wall", word("Side Set", "block_top") + word("Primary Side Set", "disk_surface") +
                       word("Smoothing", "Spline") + number("Gamma W", 25) + number("Gamma L", 2.5));
  Simulation s(
      scene(list("Mesh", word("Type", "Parts") + list("Parts", disk + block)) +
            list("Materials", material("block_body", 1, 1) + material("disk_body", modulus, density)) +
            list("Interactions", contact) +
            list("Initial Conditions", list("Fall", texts("Blocks", "{disk_body}") + numbers("Velocity", {0, -0.5}))) +
            time_integrator("Average Vector Field", 0.02, 2)),
      world());
  return impulses(s);
}

/// The stiffer an elastic disk is, the nearer is the rigid one.
TEST(RigidBodiesTest, AStiffDiskTendsToTheRigidOne) {
  const double radius = 2, height = 6.5, density = 3;
  Teuchos::ParameterList rigid = ball_on_block({});
  Teuchos::ParameterList& box = rigid.sublist("Mesh").sublist("Box");
  box.set("Divisions", Teuchos::Array<int>(Teuchos::tuple(32, 12)));
  Teuchos::ParameterList& ball = rigid.sublist("Rigid Bodies").sublist("Ball");
  ball.set("Mass", density * M_PI * radius * radius).set("Inertia", Teuchos::Array<double>(Teuchos::tuple(20.0)));
  const Teuchos::Array<double> centre = Teuchos::tuple(4.0, height);
  ball.set("Centre", centre).set("Velocity", Teuchos::Array<double>(Teuchos::tuple(0.0, -0.5))).remove("Spin");
  rigid.sublist("Interactions").sublist("Wall").sublist("Sphere").set("Center", centre);
  rigid.sublist("Time Integrator").set("Type", "Average Vector Field");
  Simulation s(rigid, world());
  const std::vector<double> limit = impulses(s);
  const double largest = std::abs(*std::min_element(limit.begin(), limit.end()));
  double before = 1e9;
  for (const double modulus : {10.0, 100.0, 1000.0}) {
    const double error = distance(impulses_of_elastic_disk(modulus, radius, height, density), limit) / largest;
    RecordProperty("error at " + std::to_string(modulus), std::to_string(error));
    EXPECT_LT(error, before / 2) << modulus;
    before = error;
  }
  EXPECT_LT(before, 0.03) << "the rest is the mesh of the disk";
}

/// Three different moments of inertia; the block far away rests. Where a body flies off, the rounding of its place over
/// the step changes its velocity.
TEST(RigidBodiesLongTest, TumblingKeepsEnergyAndMomentaOver100000Steps) {
  RigidScene options;
  options.dimension = 3;
  options.gap = 1e3;
  options.step = 0.1;
  options.ball_rests = true;
  options.body = numbers("Spin", {0.3, -0.2, 0.4});
  Simulation s(ball_on_block(options), world());
  const double energy = report_of(s).momenta().kinetic_energy;
  const Momenta before = report_of(s).momenta();
  const double scale = std::hypot(before.angular[0], before.angular[1], before.angular[2]);
  double turned = 0;
  for (int step = 0; step < 100000; ++step) {
    ASSERT_TRUE(s.integrator().step(0.1).converged);
    turned = std::max(turned, std::abs(body_u(s)[RigidBody::attitude]));
  }
  EXPECT_GT(turned, 1) << "more than half a turn";
  const Momenta after = report_of(s).momenta();
  EXPECT_NEAR(after.kinetic_energy, energy, 1e-11 * energy);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.linear[i], before.linear[i], 1e-11 * scale);
    EXPECT_NEAR(after.angular[i], before.angular[i], 1e-11 * scale);
  }
}

}  // namespace
}  // namespace ixos::test

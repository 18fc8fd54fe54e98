#include "run/run_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "run/restart_fixture.hpp"
#include "study/common/history_table.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"

namespace ixos::test {
namespace {

/// A run in which nothing is wrong.
RunFacts sound() {
  RunFacts facts;
  facts.energy_error = 0.04;
  facts.largest_energy = 1;
  facts.strains = {0.6, 1.8, 1.5, 0.5, 3};
  facts.first_scaled_jacobian = 0.7;
  facts.scale = 0.25;
  facts.deepest = -0.2;
  facts.fall = {60, 20, 1, 2};
  facts.largest_measure = 100;
  facts.face_measure = 1;
  facts.ripple = {"reaction_right_y", 0.05, 100};
  return facts;
}

/// The only warning of a run that is sound but for `change`.
template <class Change>
void expect_only(const std::string& name, const std::string& words, const Change& change) {
  RunFacts facts = sound();
  change(facts);
  const std::vector<Warning> warnings = run_warnings(facts);
  ASSERT_EQ(warnings.size(), 1U) << name;
  EXPECT_EQ(warnings[0].name, name);
  expect_contains(warnings[0].message, words);
}

TEST(RunWarningsTest, ASoundRunHasNone) {
  EXPECT_TRUE(run_warnings(sound()).empty());
  EXPECT_TRUE(run_warnings(RunFacts()).empty());
  RunFacts facts = sound();
  facts.has_inertia = false;  // a static run conserves nothing
  facts.energy_error = 10;
  EXPECT_TRUE(run_warnings(facts).empty());
}

TEST(RunWarningsTest, EachHasItsNumberAndItsLimit) {
  expect_only("energy error", "the scheme's energy error reached 0.06, 6 % of the largest kinetic",
              [](RunFacts& f) { f.energy_error = 0.06; });
  expect_only("strains", "cells were compressed to 0.4 of their volume (limit 0.5): the mesh",
              [](RunFacts& f) { f.strains.least_jacobian = 0.4; });
  expect_only("strains", "cells were stretched to 2.5 times their volume (limit 2): the mesh",
              [](RunFacts& f) { f.strains.largest_jacobian = 2.5; });
  expect_only("strains", "|tr(sigma)|/E of cells reached 6 (limit 2)",
              [](RunFacts& f) { f.strains.largest_invariant = 6; });
  expect_only("distorted cells", "scaled Jacobian of -0.3 at t = 3 T0 (limit 0.15; 0.7 before the run)",
              [](RunFacts& f) { f.strains.least_scaled_jacobian = -0.3; });
  expect_only("crossed obstacle", "in 3 step(s) a surface crossed", [](RunFacts& f) { f.crossings = 3; });
  expect_only("crossed obstacle", "a surface went 0.3 L0 below its obstacle", [](RunFacts& f) { f.deepest = -0.3; });
  expect_only("oscillating force", "reaction_right_y oscillates by 0.17 of its size",
              [](RunFacts& f) { f.ripple.roughness = 0.17; });
  expect_only("detachment", "the contact fell from 80 to 10 between two rows, from t = 1 to 2 T0, 70 %",
              [](RunFacts& f) {
                f.fall = {80, 10, 1, 2};
              });
}

TEST(RunWarningsTest, ErrorsOfTheStepNameTheirSizeAndTheRemedy) {
  expect_only("lagged friction", "changed by 3.6 % in a step on average (limit 2 %)",
              [](RunFacts& f) { f.friction_lag = 0.036; });
  expect_only("lagged friction", "use steps 8 times shorter for 1 %", [](RunFacts& f) { f.friction_lag = 0.073; });
  expect_only("front and step",
              "moved 6 L0 together in a step on average, farther than the cohesive zone, 4 L0, in 9 of 10 rows",
              [](RunFacts& f) {
                f.front = {4, 6, 10, 9};
              });
  expect_only("relaxation error", "was 20 % of the stress while they acted (limit 10 %), an error of first order",
              [](RunFacts& f) { f.relaxation_error = 0.2; });
  expect_only("relaxation error", "use steps 20 times shorter for 1 %", [](RunFacts& f) { f.relaxation_error = 0.2; });
  expect_only("relaxation error", "use steps 5 times shorter for 1 %", [](RunFacts& f) {  // the root of 20 is 4.5
    f.relaxation_error = 0.2;
    f.relaxation_order = 2;
  });
  RunFacts facts = sound();
  facts.friction_lag = 0.019;
  facts.relaxation_error = 0.099;
  facts.front = {4, 6, 10, 5};  // jumps now and then
  EXPECT_TRUE(run_warnings(facts).empty());
}

// A number is not printed as its limit, and what is within its limit is not named.
TEST(RunWarningsTest, NumbersAreToldFromTheirLimits) {
  expect_only("strains", "cells were compressed to 0.4999 of their volume (limit 0.5)",
              [](RunFacts& f) { f.strains.least_jacobian = 0.4999; });
  expect_only("strains", "cells were stretched to 2.00001 times their volume (limit 2)",
              [](RunFacts& f) { f.strains.largest_jacobian = 2.00001; });
  expect_only("energy error", "5.001 % of the largest", [](RunFacts& f) { f.energy_error = 0.05001; });
  expect_only("oscillating force", "by 0.0601 of its size", [](RunFacts& f) { f.ripple.roughness = 0.0601; });
  RunFacts facts = sound();
  facts.strains.least_jacobian = facts.strains.largest_jacobian = 1;
  facts.strains.largest_invariant = 6;
  ASSERT_EQ(run_warnings(facts).size(), 1U);
  const std::string message = run_warnings(facts)[0].message;
  EXPECT_EQ(message.find("|tr(sigma)|/E of cells reached 6 (limit 2): the mesh"), 0U) << message;
  EXPECT_EQ(message.find("volume"), std::string::npos) << message;
  facts.strains.largest_jacobian = 3;
  expect_contains(
      run_warnings(facts)[0].message,
      "cells were stretched to 3 times their volume (limit 2), |tr(sigma)|/E of cells reached 6 (limit 2): ");
}

using RunMeasuresTest = RestartTest;

bool has(const RunResult& result, const std::string& name) {
  return std::any_of(result.findings.begin(), result.findings.end(),
                     [&](const Warning& warning) { return warning.name == name; });
}

/// A cube or square of one cell, sheared within a millionth of T0 and then held; the relaxation time of the first
/// branch is 1. All nodes are driven, so that Second Order, which Static does not fit, has no vibration.
std::string sheared(double step, const std::string& update, int dimension, const std::string& branches) {
  const bool plane = dimension == 2;
  const std::string shape =
      count("Dimension", dimension) + (plane ? numbers("Lengths", {1, 1}) + counts("Divisions", {1, 1})
                                             : numbers("Lengths", {1, 1, 1}) + counts("Divisions", {1, 1, 1}));
  const std::string across = plane ? "y" : "z";
  return list("Mesh", word("Type", "Box") + list("Box", shape)) +
         list("Materials", list("M", number("Young's Modulus", 0.001) + number("Poisson's Ratio", 0) +
                                         list("Maxwell Branches", branches + word("History Update", update)))) +
         list("Histories",
              list("Pull", word("Type", "Ramp") + list("Ramp", number("Value", 0.001) + number("Length", 1e-6)))) +
         list("Boundary Conditions",
              list("Pull", word("Node Set", "right") + word("Components", across) + word("History", "Pull")) +
                  list("Guide", word("Node Set", "right") + word("Components", plane ? "x" : "xy")) +
                  list("Hold", word("Node Set", "left"))) +
         list("Time Integrator",
              word("Type", update == "Second Order" ? "Average Vector Field" : "Static") + steps(step, 4));
}

TEST_F(RunMeasuresTest, StepsThatDoNotResolveRelaxationAreToldOf) {
  const std::string one = numbers("Relaxation Times", {1}) + numbers("Moduli", {0.5});
  const std::string quick = numbers("Relaxation Times", {1, 0.01}) + numbers("Moduli", {0.5, 1e-5});
  const auto warns = [&](double step, const std::string& update, int dimension, const std::string& branches) {
    return has(run_scene(sheared(step, update, dimension, branches), "sheared"), "relaxation error");
  };
  for (const double step : {1.0 / 3, 1.0, 4.0}) EXPECT_TRUE(warns(step, "Backward Euler", 2, one)) << step;
  for (const double step : {1.0, 4.0}) EXPECT_TRUE(warns(step, "Second Order", 2, one)) << step;
  EXPECT_TRUE(warns(1, "Backward Euler", 3, one));
  EXPECT_TRUE(warns(1, "Backward Euler", 2, quick));
  EXPECT_FALSE(warns(0.05, "Backward Euler", 2, one));
  EXPECT_FALSE(warns(0.1, "Second Order", 2, one));
  EXPECT_FALSE(warns(0.05, "Backward Euler", 2, quick)) << "the quick branch has no share of the stress";
}

/// A block of that height whose top is pulled off the wall, by 2 within the time 1.
std::string lifted_off(double height, const std::string& shape, double step, const std::string& material = "") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {4, height}) + counts("Divisions", {4, 8}) +
                                                            numbers("Lower", {0, 0.2547093}))) +
         list("Materials", list("Rubber", material)) + list("Interactions", list("Wall", word("Side Set", "bottom"))) +
         list("Histories", list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 2) + number("Length", 1) +
                                                                              word("Shape", shape)))) +
         list("Boundary Conditions",
              list("Lift", word("Node Set", "top") + word("Components", "y") + word("History", "Up")) +
                  list("Guide", word("Node Set", "left") + word("Components", "x"))) +
         list("Time Integrator", word("Type", "Static") + steps(step, 1));
}

// The law's attraction falls with the gap by at most 0.299 E0/L0. A block whose stiffness E/(1 - nu^2)/h an area is
// less snaps off; a stiffer one lets go steadily.
TEST_F(RunMeasuresTest, ASnapToAnotherEquilibriumIsToldOf) {
  const std::string jump = "jump to another equilibrium";
  for (const double step : {0.05, 0.01}) {
    const RunResult snaps = run_scene(lifted_off(12, "Linear", step), "lifted");
    EXPECT_EQ(snaps.status, RunStatus::Completed) << snaps.reason;
    EXPECT_TRUE(has(snaps, jump)) << step;
  }
  for (const double step : {0.02, 0.01}) {
    const RunResult stays = run_scene(lifted_off(1, "Linear", step), "lifted");
    EXPECT_EQ(stays.status, RunStatus::Completed) << stays.reason;
    EXPECT_FALSE(has(stays, jump)) << step;
  }
}

// A block of height h without lateral strain is a spring of stiffness E/h an area: in one dimension its equilibria at
// the gap g under the lift U are the roots of T(g) + E/h (U - g + g0), and its energy is psi(g) + E/2h (U - g + g0)^2.
TEST_F(RunMeasuresTest, ASnapReleasesTheDifferenceOfTheEnergies) {
  constexpr double height = 12, width = 4, start = 0.2547093, step = 0.01, lift = 2 * step;
  const auto law = make_gap_law("Van der Waals");
  const auto force = [&](double g, double up) { return law->traction(g)[0] + (up - g + start) / height; };
  const auto energy = [&](double g, double up) {
    return law->energy(g)[0] + (up - g + start) * (up - g + start) / (2 * height);
  };
  double g = law->equilibrium_gap(), released = 0, up = 0;
  while (released == 0) {
    const double before = g;
    up += lift;
    double below = before, above = before;
    while (force(above, up) > 0) below = std::exchange(above, above + 1e-4);
    while (above - below > 1e-14) (force((above + below) / 2, up) > 0 ? below : above) = (above + below) / 2;
    g = above;
    const double work = lift * ((up - lift - before + start) + (up - g + start)) / (2 * height);
    if (g - before > 0.1) released = width * (energy(before, up - lift) + work - energy(g, up));
  }
  told_.clear();
  const RunResult result = run_scene(
      lifted_off(height, "Linear", step, word("Model", "Linear Elastic") + number("Poisson's Ratio", 0)), "lifted");
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.jumps.count, 1);
  EXPECT_NEAR(result.jumps.released, released, 1e-6 * released);
  EXPECT_NEAR(result.jumps.largest.to, up / 2, 1e-12);
  if (world()->getRank() == 0) expect_contains(told_, fmt::format("T0, and released {:.3g} E0 L0^2.", released));
  on_first([&] {
    std::ifstream file(folder("lifted") + "/summary.json");
    EXPECT_EQ(nlohmann::json::parse(file).at("jumps").at("count"), 1);
  });
}

TEST_F(RunMeasuresTest, TheEnergyThatAJumpReleasedStaysAColumnInRestartsAndWithOtherSchemes) {
  const std::string written = list("Output", checkpoints(1, 100)), density = number("Density", 1);
  const std::string scene = lifted_off(12, "Quintic", 0.05, density) + written;
  const RunResult whole = expect_goes_on(scene, {2, 12, 19});
  ASSERT_EQ(whole.jumps.count, 1);
  const double released = whole.jumps.released;
  world()->barrier();
  const HistoryTable rows(folder("whole") + "/history.csv");
  const std::vector<double>& column = rows.column("released_energy");
  EXPECT_EQ(column.front(), 0);
  EXPECT_EQ(column.back(), released);
  const std::vector<double>&total = rows.column("total_energy"), &work = rows.column("external_work");
  for (std::size_t k = 0; k < rows.rows(); ++k)
    EXPECT_NEAR(total[k] - work[k] + column[k], total[0], 0.02 * released) << k;  // the work of a step by trapezoids
  run_scene(scene, "elsewhere", checkpoint("whole", 19));
  world()->barrier();
  EXPECT_EQ(HistoryTable(folder("elsewhere") + "/history.csv").column("released_energy").front(), released);
  std::string moving = scene;
  moving.replace(moving.find("Static"), 6, "Newmark");
  EXPECT_EQ(run_scene(moving, "whole", checkpoint("whole", 19)).status, RunStatus::Completed);
  world()->barrier();
  EXPECT_EQ(HistoryTable(folder("whole") + "/history.csv").column("released_energy").back(), released);
  EXPECT_EQ(run_scene(moving, "moving").status, RunStatus::Completed);
  world()->barrier();
  EXPECT_FALSE(HistoryTable(folder("moving") + "/history.csv").has("released_energy"));
  EXPECT_EQ(run_scene(scene, "moving", checkpoint("moving", 19)).status, RunStatus::Completed);
  world()->barrier();
  EXPECT_FALSE(HistoryTable(folder("moving") + "/history.csv").has("released_energy"));
}

TEST_F(RunMeasuresTest, ALoadThatActsAtOnceIsNoJump) {
  const std::string block =
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {4, 1}) + counts("Divisions", {4, 2}))) +
      list("Materials", list("Rubber", ""));
  const std::string floor = list("Floor", word("Node Set", "bottom"));
  for (const double traction : {-0.3, 0.01, 0.3}) {
    const RunResult loaded = run_scene(
        block +
            list("Boundary Conditions", floor + list("Load", word("Type", "Traction") + word("Side Set", "top") +
                                                                 numbers("Vector", {0, traction}))) +
            list("Time Integrator", word("Type", "Static") + steps(0.25, 1)),
        "loaded");
    EXPECT_EQ(loaded.status, RunStatus::Completed) << loaded.reason;
    EXPECT_FALSE(has(loaded, "jump to another equilibrium")) << traction;
  }
}

/// A pad that is dragged along a wall and rises from a gap of 0.15 to one of 0.35, where its friction fades.
std::string dragged(double step, const std::string& friction) {
  const auto driven = [](const std::string& set, const std::string& axis, const std::string& history) {
    return list(set + " " + axis, word("Node Set", set) + word("Components", axis) + word("History", history));
  };
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 0.25}) + counts("Divisions", {4, 1}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions",
              list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.15}) + list("Friction", friction))) +
         list("Histories", expression("Up", "0.2*t", "0.2", "0") + expression("Along", "t", "1", "0")) +
         list("Boundary Conditions", driven("bottom", "x", "Along") + driven("bottom", "y", "Up") +
                                         driven("top", "x", "Along") + driven("top", "y", "Up")) +
         list("Time Integrator", word("Type", "Static") + steps(step, 1));
}

// Over N steps the threshold of Constant Stress falls to half of it: by about 0.7/N of its mean in each.
TEST_F(RunMeasuresTest, AThresholdThatLagsIsToldOf) {
  const std::string constant = word("Type", "Constant Stress") + number("Stress", 0.01) + number("Sharpness", 10);
  const auto warns = [&](double step, const std::string& friction) {
    return has(run_scene(dragged(step, friction), "dragged"), "lagged friction");
  };
  EXPECT_TRUE(warns(0.1, constant));
  EXPECT_TRUE(warns(0.05, constant));
  EXPECT_TRUE(warns(0.1, word("Type", "Extended Amontons") + number("Coefficient", 0.01)));
  EXPECT_FALSE(warns(0.005, constant));
  EXPECT_FALSE(warns(0.1, constant + word("Threshold", "Current")));
}

/// A ball so soft that the wall crumples it: W/E is 15 L0.
TEST_F(RunMeasuresTest, ACrumpledBallIsToldOfInTheSummary) {
  Simulation simulation(scene_file("ball.xml", {"Materials/Ball/Young's Modulus=1e-3", "Output/Fields Interval=0",
                                                "Time Integrator/Type=Average Vector Field",
                                                "Time Integrator/Time Step Control/Final Time=0.3"}),
                        world());
  RunOptions options;
  options.folder = folder("soft");
  const RunResult result = run(simulation, options);
  std::vector<std::string> names;
  for (const Warning& warning : result.findings) names.push_back(warning.name);
  EXPECT_NE(std::find(names.begin(), names.end(), "strains"), names.end());
  if (world()->getRank() != 0) return;
  std::ifstream file(options.folder + "/summary.json");
  const auto summary = nlohmann::json::parse(file);
  std::vector<std::string> listed;
  for (const auto& warning : summary.at("warnings")) listed.push_back(warning.at("name").get<std::string>());
  for (const char* name : {"elastic length", "cohesive zone", "strains"})
    EXPECT_NE(std::find(listed.begin(), listed.end(), name), listed.end()) << name;
}

TEST_F(RunMeasuresTest, TheFirstAndTheLastRowCount) {
  // Static steps, of which no other row tells.
  Simulation simulation(scene(lifted(word("Type", "Static") + steps(0.1, 1), count("History Interval", 1000))),
                        world());
  RunOptions options;
  options.folder = folder("lifted");
  const RunResult result = run(simulation, options);
  ASSERT_EQ(result.status, RunStatus::Completed) << result.reason;
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings[0].name, "detachment");
  expect_contains(result.findings[0].message,
                  "the contact fell from 2 to 0 between two rows, from t = 0 to 1 T0, 100 % of its largest value");
}

// A plate on rollers that a traction drags along: nothing balances the traction.
TEST_F(RunMeasuresTest, AStaticStepThatFailsNamesTheMissingSupport) {
  const std::string rollers = list("Rollers", word("Node Set", "bottom") + word("Components", "y"));
  const std::string drag =
      list("Drag", word("Type", "Traction") + word("Side Set", "top") + numbers("Vector", {0.01, 0}));
  Simulation simulation(scene(list("Mesh", word("Type", "Box") + list("Box", counts("Divisions", {2, 2}))) +
                              list("Materials", list("Rubber", "")) + list("Boundary Conditions", rollers + drag) +
                              time_integrator("Static", 1, 1)),
                        world());
  RunOptions options;
  options.folder = folder("dragged");
  const RunResult result = run(simulation, options);
  EXPECT_EQ(result.status, RunStatus::Diverged);
  expect_contains(result.reason, "nothing holds the translation along (1, 0) of the body \"body\"");
}

using RunMeasuresSerialTest = RestartTest;

TEST_F(RunMeasuresSerialTest, SoundRunsHaveNoWarnings) {
  const std::string step = "Time Integrator/Time Step Control/";
  const std::vector<std::pair<std::string, std::vector<std::string>>> runs = {
      {"ball.xml", {"Output/Fields Interval=0", step + "Final Time=1"}},
      {"strip.xml", {"Output/Fields Time Interval=0", step + "Time Step=1", "Mesh/Box/Divisions={160, 8}"}},
      {"block-on-wall.xml", {"Mesh/Box/Divisions={16, 16, 16}"}}};
  for (const auto& [file, settings] : runs) {
    Simulation simulation(scene_file(file, settings), world());
    RunOptions options;
    options.folder = folder(file);
    const RunResult result = run(simulation, options);
    ASSERT_TRUE(result.status == RunStatus::Completed || result.status == RunStatus::Stopped) << result.reason;
    on_first([&] {
      std::ifstream summary(options.folder + "/summary.json");
      EXPECT_EQ(nlohmann::json::parse(summary).at("warnings").dump(), "[]") << file;
    });
  }
}

}  // namespace
}  // namespace ixos::test

#include "run/run_warnings.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run/restart_fixture.hpp"
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
  expect_only("strains", "cells were compressed to 0.4 of their volume",
              [](RunFacts& f) { f.strains.least_jacobian = 0.4; });
  expect_only("strains", "stretched to 2.5 (limits 0.5 and 2)", [](RunFacts& f) { f.strains.largest_jacobian = 2.5; });
  expect_only("strains", "|tr(sigma)|/E reached 6 (limit 2)", [](RunFacts& f) { f.strains.largest_invariant = 6; });
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

using RunMeasuresTest = RestartTest;

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

// Whole advices on scenes whose results are formulas of their settings, so that the exact values are known.
#include "study/advice/advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "study/advice/advice_report.hpp"
#include "study/advice/advice_runs.hpp"
#include "support/advice_case.hpp"
#include "support/files.hpp"
#include "support/plane_block.hpp"
#include "support/temporary_folder.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

const char* const scene = R"x(<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box"><Parameter name="Divisions" type="Array(int)" value="{8, 8}"/></ParameterList></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber"/></ParameterList>
  <ParameterList name="Interactions"><ParameterList name="Wall">
    <Parameter name="Side Set" type="string" value="bottom"/>
    <Parameter name="Gamma L" type="double" value="2.5"/>
    <Parameter name="Gamma W" type="double" value="25"/></ParameterList></ParameterList>
  <ParameterList name="Time Integrator"><Parameter name="Type" type="string" value="Newmark"/>
    <ParameterList name="Time Step Control">
      <Parameter name="Final Time" type="double" value="10"/>
      <Parameter name="Time Step" type="double" value="0.1"/></ParameterList></ParameterList>
</ParameterList>)x";

class AdviceTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() + "/block.xml") << scene;
    question_.scene = folder_.path() + "/block.xml";
    question_.budget = 1000;
    options_.folder = folder_.path() + "/out";
    options_.driver = IXOS_TEST_DIRECTORY "/study/formula_run.py";
    options_.version = "1";
    options_.log = [this](const std::string& line) { told_ += line + "\n"; };
    for (const char* variable : {"IXOS_STRAINS", "IXOS_FAILURE"}) unsetenv(variable);
  }
  Advice advice(const std::string& formula, double tolerance, const std::string& quantity = "final force") {
    setenv("IXOS_FORMULA", formula.c_str(), 1);
    question_.quantities = {AskedQuantity(quantity)};
    question_.tolerance = tolerance;
    Advice found = advise(question_, options_);
    write_advice(question_, found, options_.folder, "command", "1");
    return found;
  }
  /// Returns the number of a direction.
  static std::size_t place_of(const AdviceDirections& directions, const std::string& name) {
    std::size_t d = 0;
    while (directions.all.at(d).name != name) ++d;
    return d;
  }
  /// Runs the scene with its own law and as Linear Elastic, and returns the error of the latter.
  double error_of_linear_law(const std::string& formula, const std::string& strains, const std::string& quantity) {
    setenv("IXOS_FORMULA", formula.c_str(), 1);
    setenv("IXOS_STRAINS", strains.c_str(), 1);
    question_.quantities = {AskedQuantity(quantity)};
    const AdviceDirections directions = advice_directions(changed_scene(question_.scene, {}));
    const std::size_t d = place_of(directions, "material");
    AdviceRuns runs(question_, options_, directions);
    const AdvicePoint own = scene_point(directions);
    AdvicePoint linear = own;
    linear[d].branch = 1;
    runs.carry_out({linear, own});
    return AdviceErrors(directions, own, runs.samples(), {false}, {0.0}).model_error(d, linear[d], 0);
  }
  /// Returns a setting of the recommended scene, as a number.
  double size(const Advice& found, std::size_t d) const { return level_at(found.directions, found.best.point, d).size; }
  std::size_t runs() const {
    const std::string text = test::contents(folder_.path() + "/runs.txt");
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  test::TemporaryFolder folder_;
  AdviceQuestion question_;
  AdviceOptions options_;
  std::string told_;
};

/// The force of the whole depth, 3, is three times that of a unit.
TEST_F(AdviceTest, APlaneSceneIsAnsweredInTwoDimensionsIfBothAgree) {
  std::ofstream(question_.scene) << test::plane_block;
  const std::string shape = " * (1 + 1e4 * dt**2 / 0.0005**2 * 1e-6 + 1e-3 * h**2)";
  const Advice flat = advice("(3 if dimension == 3 else 1)" + shape, 0.02);
  ASSERT_EQ(flat.status, AdviceStatus::Advised) << flat.problem << told_;
  ASSERT_TRUE(flat.plane);
  EXPECT_LT(flat.plane->difference, 1e-14);
  EXPECT_NEAR(flat.exact[0], 1, 0.02);
  EXPECT_NE(advice_text(question_, flat).find("Two dimensions will do"), std::string::npos);

  options_.folder = folder_.path() + "/other";
  const Advice spatial = advice("(4 if dimension == 3 else 1)" + shape, 0.02);
  ASSERT_EQ(spatial.status, AdviceStatus::Advised) << spatial.problem << told_;
  EXPECT_FALSE(spatial.plane);
  EXPECT_EQ(spatial.directions.dimension, 3);
  EXPECT_NEAR(spatial.exact[0], 4, 0.08);
  EXPECT_NE(told_.find("Two dimensions will not do: the quantities or their columns differ by 25 %."),
            std::string::npos)
      << told_;
  EXPECT_FALSE(std::filesystem::exists(options_.folder + "/plane.xml"));
}

TEST_F(AdviceTest, KeepsTheToleranceOfASmoothScene) {
  const Advice found = advice("3 * (1 + 4 * dt**2 + 0.08 * h**2)", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  const double error = 4 * dt * dt + 0.08 * h * h;
  EXPECT_LE(error, 0.05);
  EXPECT_LE(error, found.best.error);
  EXPECT_NEAR(found.exact[0], 3, 0.03);
  EXPECT_TRUE(found.confirmed);
  // Neither four times coarser nor much finer than needed.
  EXPECT_GT(error, 0.05 / 40);
  EXPECT_EQ(told_.find("Budget: 1e+03 s of processor time"), told_.find("Budget"));
  EXPECT_LT(told_.find("Budget"), told_.find("completed", told_.find("completed") + 1))
      << "stated before all but the coarsest run";
  const std::string text = advice_text(question_, found);
  EXPECT_NE(text.find("Recommended within the tolerance 5 %"), std::string::npos) << text;
  EXPECT_NE(text.find("Costs of other tolerances"), std::string::npos) << text;
  // The scene is ready to run, with the recommended settings and no others.
  const Teuchos::ParameterList advised = changed_scene(options_.folder + "/advised.xml", {});
  EXPECT_EQ(advised.sublist("Time Integrator").sublist("Time Step Control").get<double>("Time Step"), dt);
  EXPECT_EQ(advised.sublist("Time Integrator").sublist("Time Step Control").get<double>("Final Time"), 10);
}

TEST_F(AdviceTest, OnlyTheRecommendedRunIsFineInBothDirections) {
  const Advice found = advice("3 * (1 + 4 * dt**2 + 0.08 * h**2)", 0.01);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  double work = 0;
  for (const AdviceSample& sample : found.samples) {
    work += sample.steps * sample.dofs;
    if (sample.point == found.best.point) continue;
    EXPECT_FALSE(level_at(found.directions, sample.point, time_direction).size <= dt &&
                 level_at(found.directions, sample.point, mesh_direction).size <= h)
        << description_of(found.directions, sample.point);
  }
  const auto best = std::find_if(found.samples.begin(), found.samples.end(),
                                 [&](const AdviceSample& sample) { return sample.point == found.best.point; });
  ASSERT_NE(best, found.samples.end());
  EXPECT_LE(work, 8 * best->steps * best->dofs) << told_;
}

// Linear elasticity is a fifth off in the middle of the run, and right at its end.
TEST_F(AdviceTest, AModelThatAgreesAtOneTimeIsComparedOverTime) {
  const std::string bent = "3 * t + (0.24 * t * (10 - t) if material == 'Linear Elastic' else 0)";
  EXPECT_NEAR(error_of_linear_law(bent, "0,0,0", "final force"), 0.2, 1e-12);
  options_.folder += "-peak";
  EXPECT_NEAR(error_of_linear_law("3 * t", "0,0,0", "final force"), 0, 1e-12);
}

TEST_F(AdviceTest, AModelThatAgreesAtOneTimeIsNotRecommended) {
  const Advice found =
      advice("3 * (1 + 4 * dt**2 + 0.08 * h**2) + (0.06 * t * (10 - t) if material == 'Linear Elastic' else 0)", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  EXPECT_EQ(found.best.point[place_of(found.directions, "material")].branch, 0U);
  for (const AdviceChoice& choice : found.choices)
    if (choice.direction == "material") {
      EXPECT_GT(choice.errors[0], 0.05) << "1.5 of 3 in the middle of the run, less beside a coarse base";
    }
}

// The arm of a film turns by 45 degrees, and its force agrees with that of linear elasticity.
TEST_F(AdviceTest, AFilmThatTurnsIsNotLinear) {
  EXPECT_NEAR(error_of_linear_law("3", "0.7853981633974483,-0.001,0.002", "final force"), 1 - std::sqrt(0.5) + 0.002,
              1e-12);
  options_.folder += "-advice";
  const Advice found = advice("3 * (1 + 4 * dt**2 + 0.08 * h**2)", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const std::size_t d = place_of(found.directions, "material");
  for (const AdviceSample& sample : found.samples) EXPECT_EQ(sample.point[d].branch, 0U) << "no run is spent on it";
  for (const AdviceCandidate& each : found.trades) EXPECT_EQ(each.point[d].branch, 0U);
  EXPECT_EQ(advice_text(question_, found).find("Linear Elastic"), std::string::npos);
}

TEST_F(AdviceTest, SmallRotationsAndStrainsAllowTheLinearLaw) {
  EXPECT_NEAR(error_of_linear_law("3", "0.02,-0.0005,0.0004", "final force"), 0.02 * 0.02 / 2 + 0.0005, 1e-7);
}

// The turn comes after the time that decides.
TEST_F(AdviceTest, StrainsCountUpToTheTimeThatDecides) {
  EXPECT_NEAR(error_of_linear_law("3", "0.2,0,0", "value force at 5"), 1 - std::cos(0.1), 1e-12);
}

TEST_F(AdviceTest, ARunThatFailsLaterHasTheQuantity) {
  setenv("IXOS_FAILURE", "7", 1);
  const Advice found = advice("t * (1 + 4 * dt**2 + 0.08 * h**2)", 0.05, "value force at 5");
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  EXPECT_NEAR(found.exact[0], 5, 0.05);
  EXPECT_TRUE(found.confirmed);
  EXPECT_EQ(found.fails_later, "failed at 7");
  EXPECT_NE(advice_text(question_, found).find("fails after the times that decide the quantities: failed at 7."),
            std::string::npos);
  options_.folder += "-window";
  EXPECT_EQ(advice("1", 0.05, "mean force [1, 8]").status, AdviceStatus::NoRun);
}

TEST_F(AdviceTest, AMeshFromAFileIsInNoBound) {
  std::ofstream(folder_.path() + "/x.e") << "mesh";
  question_.common = {"Mesh/Type=Exodus", "Mesh/Exodus/File=x.e"};
  question_.verify = true;
  const Advice found = advice("1 + 4 * dt**2", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  EXPECT_TRUE(found.examined[time_direction][0]);
  EXPECT_FALSE(found.examined[mesh_direction][0]);
  EXPECT_TRUE(found.verification.step);
  EXPECT_FALSE(found.verification.mesh);
  const std::string text = advice_text(question_, found);
  for (const char* part : {"but for the mesh, which the runs did not examine: ", " % of time step",
                           "; not examined: mesh", "    mesh: not examined\n", "Verified for the step alone: "})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("mesh: 0 %"), std::string::npos) << text;
}

TEST_F(AdviceTest, ALooseToleranceOfNewtonsMethodIsMeasured) {
  question_.common = {"Nonlinear Solver/Tolerance=1e-3"};
  const Advice found = advice("1 + 10 * tolerance + 0.1 * dt**2 + 0.0001 * h**2", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  ASSERT_EQ(found.directions.all[2].name, "Newton tolerance");
  EXPECT_NEAR(found.exact[0], 1, 1e-3);
  EXPECT_GE(found.best.estimate.parts[0][2], found.best.point[2].level == 0 ? 0.0099 : 0.000099);
}

TEST_F(AdviceTest, ChoicesAreToldWithTheirErrors) {
  const Advice found = advice("1 + 4 * dt**2 + 0.08 * h**2 + (0.03 if tolerance == 1e-6 else 0)", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  for (const AdviceChoice& choice : found.choices) {
    EXPECT_FALSE(choice.label.empty());
    if (choice.label == "Newton tolerance 1e-06") {
      EXPECT_NEAR(choice.errors[0], 0.03, 0.001);
    }
  }
  EXPECT_EQ(found.sample_errors.size(), found.samples.size());
}

TEST_F(AdviceTest, FinishedRunsAreReused) {
  const std::string formula = "3 * (1 + 4 * dt**2 + 0.08 * h**2)";
  const Advice first = advice(formula, 0.05);
  const std::size_t count = runs();
  const Advice second = advice(formula, 0.05);
  EXPECT_EQ(runs(), count);
  EXPECT_EQ(second.best.point, first.best.point);
  EXPECT_EQ(second.spent, first.spent);
}

TEST_F(AdviceTest, ALuckyCrossingIsNotRecommended) {
  // The error is 0 at a step of 0.1 T0 and 1.3 % at 0.05: the finer steps tell.
  const Advice found = advice("1 + 0.8 * dt * (0.1 - dt) * 6.5 + 0.0001 * h**2", 0.01);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem;
  const double dt = size(found, time_direction);
  EXPECT_LE(std::abs(0.8 * dt * (0.1 - dt) * 6.5), 0.01);
  EXPECT_LT(dt, 0.05);
}

TEST_F(AdviceTest, ChaosIsCalledChaos) {
  const Advice found = advice("1 + 0.1 * sin(1e12 * change + 1e3 * dt)", 0.01);
  EXPECT_EQ(found.status, AdviceStatus::Chaotic);
  EXPECT_NE(found.problem.find("The scene is chaotic for final force"), std::string::npos) << found.problem;
  EXPECT_FALSE(std::ifstream(options_.folder + "/advised.xml").good());
}

TEST_F(AdviceTest, ChaosIsFoundAtALaterBase) {
  // The finest of the first three steps amplifies the perturbation a thousand times, the base's own without limit.
  const Advice found =
      advice("1 + dt**2 + 0.001 * h**2 + (1e3 * change if dt < 0.03 else 0.1 * sin(1e12 * change))", 0.01);
  EXPECT_EQ(found.status, AdviceStatus::Chaotic) << told_;
}

TEST_F(AdviceTest, AToleranceThatNothingReaches) {
  // The mesh converges slowly.
  const Advice found = advice("1 + 0.5 * h**0.5 + dt**2", 0.001);
  EXPECT_EQ(found.status, AdviceStatus::Unreachable);
  const std::string text = advice_text(question_, found);
  EXPECT_NE(text.find("The smallest error seen is "), std::string::npos) << text;
  EXPECT_NE(text.find("limited by the mesh"), std::string::npos) << text;
}

TEST_F(AdviceTest, CellsOfAHigherOrderLeadWhereOthersConvergeSlowly) {
  // 0.005 of the tolerance needs h = 0.01 with linear cells, which no mesh has, and h = 0.5 with quadratic ones.
  const Advice found = advice("1 + dt**2 + (0.02 * h**2 if element == 'Q2C2' else 0.5 * h)", 0.01);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  EXPECT_LE(dt * dt + 0.02 * h * h, 0.01);
  for (const AdviceSample& sample : found.samples)
    if (sample.point[mesh_direction].branch == 0) {
      EXPECT_LE(sample.point[mesh_direction].level, 2U) << "three coarse meshes tell how slow linear cells are";
    }
}

TEST_F(AdviceTest, TwoMeshesThatAgreeByCoincidenceAreDoubted) {
  // With quadratic cells, the two coarsest meshes have the same error of 8 %, the others less.
  const Advice found = advice("1 + dt**2 + (min(0.08, 0.02 * h**2) if element == 'Q2C2' else 0.04 * h)", 0.02);
  if (found.status == AdviceStatus::Advised) {
    const double dt = size(found, time_direction), h = size(found, mesh_direction);
    const bool quadratic = branch_at(found.directions, found.best.point, mesh_direction).higher_order;
    EXPECT_LE(dt * dt + (quadratic ? std::min(0.08, 0.02 * h * h) : 0.04 * h), 0.02) << told_;
  }
}

TEST_F(AdviceTest, AStepIsMeasuredAnewOnAFineMesh) {
  // On coarse meshes the step has hardly any effect.
  const Advice found = advice("1 + 0.08 * h**2 + (9 if h < 0.9 else 0.2) * dt**2", 0.02);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  EXPECT_LE(0.08 * h * h + (h < 0.9 ? 9 : 0.2) * dt * dt, 0.02) << told_;
}

TEST_F(AdviceTest, ChoicesThatCostNothingAreTaken) {
  // Another scheme is nine times as accurate as Newmark.
  const Advice found = advice("1 + (0.5 if scheme == 'Bathe Composite' else 4.5) * dt**2 + 0.001 * h**2", 0.01);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem;
  const double dt = size(found, time_direction);
  const std::string scheme = branch_at(found.directions, found.best.point, time_direction).label;
  EXPECT_LE((scheme == "Bathe Composite" ? 0.5 : 4.5) * dt * dt, 0.01) << scheme;
}

TEST_F(AdviceTest, ABudgetThatIsTooSmall) {
  question_.budget = 0.01;
  const Advice found = advice("1 + dt**2 + h**2", 0.01);
  EXPECT_NE(found.status, AdviceStatus::Advised);
  EXPECT_FALSE(advice_text(question_, found).empty());
}

TEST_F(AdviceTest, RunsThatFailAreAvoided) {
  // Coarse steps diverge.
  const Advice found = advice("-1 if dt > 0.06 else 1 + 4 * dt**2 + 0.001 * h**2", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem;
  EXPECT_LE(size(found, time_direction), 0.06);
  options_.folder += "-none";
  const Advice none = advice("-1", 0.05);
  EXPECT_EQ(none.status, AdviceStatus::NoRun);
  EXPECT_NE(none.problem.find("negative"), std::string::npos) << none.problem;
}

TEST_F(AdviceTest, AFineMeshThatFailsWithALongStepIsRunWithAShorterOne) {
  const Advice found = advice("-1 if h < 1.5 and dt > 0.04 else 1 + 4 * dt**2 + 0.08 * h**2", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  EXPECT_LE(4 * dt * dt + 0.08 * h * h, 0.05) << dt << ' ' << h;
  EXPECT_LE(dt, 0.04);
}

TEST_F(AdviceTest, AnErrorNeedsNoFinerMesh) {
  // The stand-in's energy error is the value of its formula.
  const Advice found = advice("4 * dt**2", 0.02, "energy error");
  ASSERT_EQ(found.status, AdviceStatus::Advised) << found.problem << told_;
  const double dt = size(found, time_direction);
  EXPECT_LE(4 * dt * dt, 0.02);
  for (const AdviceSample& sample : found.samples)
    EXPECT_EQ(sample.point[mesh_direction].level, found.samples.front().point[mesh_direction].level);
}

TEST_F(AdviceTest, TellsWhyItStops) {
  const Advice fails = advice("-1 if h < 1.5 else 1 + dt**2 + h**2", 0.01);
  EXPECT_EQ(fails.status, AdviceStatus::Unreachable);
  EXPECT_NE(fails.problem.find("failed: negative"), std::string::npos) << fails.problem;
  options_.folder += "-budget";
  question_.budget = 0.3;  // enough for some runs, or for the first alone on a machine that has much else to do
  const Advice poor = advice("1 + dt**2 + 0.5 * h**0.5", 0.001);
  EXPECT_TRUE(poor.status == AdviceStatus::Unreachable || poor.status == AdviceStatus::NoRun);
  const bool says_so = poor.problem.find("the budget has") != std::string::npos ||
                       poor.problem.find("processor time") != std::string::npos;  // of the first run, ended
  EXPECT_TRUE(says_so) << poor.problem;
}

TEST_F(AdviceTest, WhatIsExtrapolatedMayCostThreeTimesTheRest) {
  const AdviceDirections directions = test::directions_of_formula();
  AdviceRuns runs(question_, options_, directions);
  runs.set_budget(10);
  EXPECT_TRUE(runs.affords(10));
  EXPECT_FALSE(runs.affords(11));
  EXPECT_TRUE(runs.may_afford(30));
  EXPECT_FALSE(runs.may_afford(31));
}

TEST_F(AdviceTest, BadQuestionsAreRefused) {
  EXPECT_THROW(advice("1", 0.01, "final forse"), InputError);
  EXPECT_THROW(advice("1", 0.01, "mean force [20, 30]"), InputError);
  question_.common = {"Mesh/Bax=1"};
  EXPECT_THROW(advice("1", 0.01), InputError);
}

TEST_F(AdviceTest, AVerificationIsRun) {
  question_.verify = true;
  const Advice found = advice("1 + 4 * dt**2 + 0.08 * h**2", 0.05);
  ASSERT_EQ(found.status, AdviceStatus::Advised);
  const double dt = size(found, time_direction), h = size(found, mesh_direction);
  const double fine = dt * dt + 0.02 * h * h;
  EXPECT_NEAR(found.verification.change, 3 * fine / (1 + fine), 1e-9);
}

/// Returns a number of the environment, for a measurement with more scenes than a test has time for.
unsigned from_environment(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

TEST_F(AdviceTest, RandomScenesKeepTheirTolerances) {
  const unsigned scenes = from_environment("IXOS_ADVICE_SCENES", 12);
  std::mt19937 random(from_environment("IXOS_ADVICE_SEED", 2));
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t kept = 0;
  std::vector<double> ratios;  // steps times unknowns of all runs over those of the recommended run
  for (unsigned i = 0; i < scenes; ++i) {
    const double a = 4 * any(random), b = 0.1 * any(random), c = 0.5 * any(random), d = 0.3 * any(random);
    options_.folder = folder_.path() + "/out" + std::to_string(i);
    const std::string formula = "1 + " + std::to_string(a) + " * dt**2 + " + std::to_string(b) + " * h**2 + " +
                                std::to_string(c) + " * dt * h + " + std::to_string(d) + " * dt * sin(40 * dt)";
    const Advice found = advice(formula, 0.02);
    if (found.status != AdviceStatus::Advised) continue;
    const double dt = size(found, time_direction), h = size(found, mesh_direction);
    kept += std::abs(a * dt * dt + b * h * h + c * dt * h + d * dt * std::sin(40 * dt)) <= 0.02 ? 1 : 0;
    double work = 0, best = std::numeric_limits<double>::infinity();
    for (const AdviceSample& sample : found.samples) {
      work += sample.steps * sample.dofs;
      if (sample.point == found.best.point) best = sample.steps * sample.dofs;
    }
    ratios.push_back(work / best);
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GE(ratios.size(), scenes * 3 / 4);
  EXPECT_GE(kept, ratios.size() * 95 / 100);
  ASSERT_FALSE(ratios.empty());
  EXPECT_LE(ratios[ratios.size() / 2], 8);
  std::printf("%u scenes, %zu advised, %zu within the tolerance; work over that of the recommended run: median %.1f, ",
              scenes, ratios.size(), kept, ratios[ratios.size() / 2]);
  std::printf("nine of ten at most %.1f, largest %.1f\n", ratios[ratios.size() * 9 / 10], ratios.back());
}

}  // namespace
}  // namespace ixos

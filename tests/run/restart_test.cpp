// Runs that go on from a checkpoint: as if nothing had happened, or with other settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/hdf5_file.hpp"
#include "run/restart_fixture.hpp"
#include "support/bodies.hpp"

namespace ixos::test {
namespace {

TEST_F(RestartTest, EverySchemeGoesOnToTheLastBit) {
  for (const std::string& scheme : test::moving_schemes()) {
    SCOPED_TRACE(scheme);
    // Sums since the row before, and steps without a row or frame, are carried over too.
    std::string scene = drawn(word("Type", scheme) + steps(0.02, 1),
                              count("History Interval", 3) + count("Fields Interval", 4) + checkpoints(35, 100));
    scene.insert(scene.find(number("Mass Damping", 0.1)), number("Viscosity", 0.02));
    expect_goes_on(scene, {35});
  }
}

TEST_F(RestartTest, EveryLawObstacleAndMaterialGoesOnToTheLastBit) {
  // The exact mean before a sphere has an unsymmetric tangent.
  const std::string exact = list("Average Vector Field", count("Interaction Points", 0));
  for (const Adhesion& adhesion : adhesions()) {
    SCOPED_TRACE(adhesion.law + ", " + adhesion.obstacle + ", " + adhesion.model);
    expect_goes_on(adhesive_block(2, adhesion) + list("Output", count("Fields Interval", 10) + checkpoints(35, 100)) +
                       list("Time Integrator", word("Type", "Average Vector Field") + exact + steps(0.02, 1)),
                   {35});
  }
}

TEST_F(RestartTest, EveryElasticLawGoesOnToTheLastBit) {
  // These schemes weigh both ends of a step alike, and take over forces of the step before.
  for (const std::string& scheme :
       {word("Type", "Gautam-Sauer Composite"),
        word("Type", "Generalized-Alpha") + list("Generalized-Alpha", number("Spectral Radius", 1))})
    for (const char* law : {"Neo-Hooke", "Linear Elastic", "Saint Venant-Kirchhoff", "Mooney-Rivlin", "Yeoh", "Gent"}) {
      SCOPED_TRACE(law + (", " + scheme));
      std::string scene = drawn(scheme + steps(0.02, 0.6), checkpoints(15, 100));
      scene.insert(scene.find(number("Density", 1)), word("Model", law));
      expect_goes_on(scene, {15});
    }
}

/// The names and messages of a run's warnings.
std::vector<std::string> warnings_of(const RunResult& result) {
  std::vector<std::string> all;
  for (const auto* warnings : {&result.warnings, &result.findings})
    for (const Warning& warning : *warnings) all.push_back(warning.name + ": " + warning.message);
  return all;
}

TEST_F(RestartTest, WarningsAreThoseOfARunWithoutARestart) {
  const std::string scene = lifted(word("Type", "Newmark") + steps(0.02, 1),
                                   count("History Interval", 7) + list("Watch", number("Tolerance", 1e-12)));
  const std::vector<std::string> whole = warnings_of(run_scene(scene, "whole"));
  const auto has = [&whole](const std::string& name) {
    return std::any_of(whole.begin(), whole.end(), [&](const auto& own) { return own.rfind(name, 0) == 0; });
  };
  EXPECT_TRUE(has("energy watch: ")) << testing::PrintToString(whole);
  EXPECT_TRUE(has("detachment: ")) << testing::PrintToString(whole);
  for (const int at : {4, 30}) {  // before the first warning, and after all that lead to one
    SCOPED_TRACE(at);
    int asked = 0;
    const RunResult part = run_scene(scene, "parts", "", [&] { return ++asked == at; });
    ASSERT_EQ(part.status, RunStatus::Interrupted);
    warned_.clear();
    const RunResult rest = run_scene(scene, "parts", folder("parts"));
    EXPECT_EQ(rest.status, RunStatus::Completed) << rest.reason;
    EXPECT_EQ(warnings_of(rest), whole);
    if (world()->getRank() == 0) {
      EXPECT_EQ(warned_.empty(), at == 30) << warned_;
    }
    on_first([&] {
      const auto listed = [&](const std::string& name) {
        std::ifstream file(folder(name) + "/summary.json");
        return nlohmann::json::parse(file).at("warnings");
      };
      EXPECT_EQ(listed("parts"), listed("whole"));
    });
  }
}

TEST_F(RestartTest, FieldsInOneHdf5FileGoOn) {
  expect_goes_on(drawn(word("Type", "Newmark") + steps(0.02, 1),
                       word("Fields Format", "HDF5") + count("Fields Interval", 3) + checkpoints(10, 100)),
                 {10, 40, 50});
}

TEST_F(RestartTest, AdaptiveStepsAndChosenTimePointsGoOn) {
  const std::string adaptive =
      list("Adaptive", number("Tolerance", 1e-4) + number("Maximum Gap Ratio", 1.3) +
                           "<Parameter name=\"Choose Time Points\" type=\"bool\" value=\"true\"/>");
  expect_goes_on(
      drawn(word("Type", "Average Vector Field") + word("Predictor", "Extrapolation") +
                steps(0.001, 1.5, word("Type", "Adaptive") + adaptive),
            number("History Time Interval", 0.1) + number("Fields Time Interval", 0.3) + checkpoints(5, 1000)),
      {5, 20, 35});
}

/// Returns the scene with one more history, which scales the load.
std::string scaled(std::string scene, const std::string& value) {
  const std::string vector = numbers("Vector", {0.02, 0}), histories = "<ParameterList name=\"Histories\">";
  scene.insert(scene.find(vector), word("History", "Scale"));
  return scene.insert(scene.find(histories) + histories.size(), expression("Scale", value));
}

TEST_F(RestartTest, CutStepsGoOn) {
  // The load is undefined in two short spans. The step from 0.35 to 0.4 has a stage at 0.3805, its first half one at
  // 0.36525; its first quarter and the steps after that avoid both. The checkpoint after step 8 has half a step ahead.
  const std::string undefined = "sqrt((t-0.3651)*(t-0.3654)*(t-0.3803)*(t-0.3807))";
  const RunResult whole =
      expect_goes_on(scaled(drawn(word("Type", "Bathe Composite") + list("Bathe Composite", number("Split", 0.61)) +
                                      steps(0.05, 1, count("Maximum Cuts", 10)),
                                  checkpoints(1, 1000)),
                            undefined),
                     {7, 8, 15});
  EXPECT_EQ(whole.rejected_steps, 2);
  EXPECT_EQ(whole.steps, 22);  // 7, a quarter, a half, a quarter, 12
}

TEST_F(RestartTest, HermiteFacesGoOn) {
  expect_goes_on(list("Mesh", word("Type", "Box") +
                                  list("Box", count("Dimension", 3) + numbers("Lengths", {3, 2, 1}) +
                                                  counts("Divisions", {3, 2, 1})) +
                                  list("Sets", list("patch", word("From", "bottom") + numbers("Upper", {2, 2, 1})))) +
                     list("Materials", list("Rubber", number("Density", 1))) +
                     list("Interactions", list("Wall", word("Side Set", "patch") + word("Contact Element", "Q1CH") +
                                                           numbers("Point", {0, 0, -0.5}))) +
                     list("Boundary Conditions", list("Grip", word("Node Set", "left"))) +
                     list("Initial Conditions", numbers("Velocity Gradient", {0, 0, 0, 0, 0, 0, -0.1, 0, 0})) +
                     list("Output", count("Fields Interval", 3) + checkpoints(4, 100)) +
                     list("Time Integrator", word("Type", "Average Vector Field") + steps(0.05, 0.6)),
                 {4, 8});
}

TEST_F(RestartTest, QuadraticCellsGoOn) {
  const std::string cubes =
      list("Box", count("Dimension", 3) + numbers("Lengths", {3, 2, 1}) + counts("Divisions", {2, 1, 1}));
  for (const std::string& body : {cubes, std::string()}) {
    const bool solid = !body.empty();
    const std::string disk = list("Disk", number("Diameter", 3) + numbers("Center", {0, 2}) + count("Rings", 1));
    for (const char* scheme : {"Average Vector Field", "Central Difference"})
      expect_goes_on(
          list("Mesh", word("Type", solid ? "Box" : "Disk") + count("Cell Order", 2) + (solid ? body : disk)) +
              list("Materials", list("Rubber", number("Density", 1) + number("Viscosity", 0.02))) +
              list("Interactions",
                   list("Wall", word("Side Set", solid ? "bottom" : "surface") +
                                    word("Contact Element", solid ? "Q2C4" : "Q2C2") +
                                    (solid ? numbers("Point", {0, 0, -0.5}) : numbers("Point", {0, 0})))) +
              list("Initial Conditions",
                   numbers("Velocity", solid ? std::vector<double>{0.1, 0, -0.3} : std::vector<double>{0.1, -0.3})) +
              list("Output", count("Fields Interval", 3) + checkpoints(4, 100)) +
              list("Time Integrator", word("Type", scheme) + steps(0.05, 0.6)),
          {4, 8});
  }
}

TEST_F(RestartTest, GripsGoOn) {
  const std::string grips = list(
      "Grips", list("Jaw", word("Node Set", "top") + word("Rotation", "Down") + numbers("Point", {1, 1})) +
                   list("Machine", word("Type", "Springs") + word("Node Set", "right") +
                                       "<Parameter name=\"Translation\" type=\"Array(string)\" value=\"{-, Down}\"/>" +
                                       numbers("Stiffness", {1, 2}) + numbers("Damping", {0.1, 0.2})));
  for (const char* scheme : {"Bathe Composite", "Average Vector Field", "Central Difference"}) {
    std::string scene = drawn(word("Type", scheme) + steps(0.05, 1), checkpoints(4, 100), grips);
    const std::string held = word("Node Set", "left") + word("Components", "y");
    scene.replace(scene.find(held), held.size(), word("Node Set", "bottom") + word("Components", "x"));
    const std::string recorded = "{left}";
    scene.replace(scene.find(recorded), recorded.size(), "{bottom}");
    expect_goes_on(scene, {4, 16});
  }
}

TEST_F(RestartTest, MovedObstaclesGoOn) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Average Vector Field", "Energy-Momentum"})
    expect_goes_on(
        list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {3, 1}) + counts("Divisions", {4, 2}))) +
            list("Materials", list("Rubber", number("Density", 1))) +
            list("Histories", test::expression("Press", "0.01*sin(2*t)", "0.02*cos(2*t)", "-0.04*sin(2*t)") +
                                  test::expression("Turn", "0.02*t", "0.02", "0")) +
            list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.3}) +
                                                  list("Motion",
                                                       "<Parameter name=\"Translation\" type=\"Array(string)\" "
                                                       "value=\"{-, Press}\"/>" +
                                                           word("Rotation", "Turn")))) +
            list("Output", checkpoints(4, 100)) + list("Time Integrator", word("Type", scheme) + steps(0.05, 1)),
        {4, 16});
}

TEST_F(RestartTest, StaticsGoOn) {
  std::string scene = drawn(word("Type", "Static") + steps(0.05, 1), checkpoints(4, 100));
  // Nothing else would hold the block sideways.
  const std::string loose = word("Components", "y");
  scene.replace(scene.find(loose), loose.size(), word("Components", "xy"));
  expect_goes_on(scene, {4, 16});
}

/// What the first lagged solver has in a checkpoint.
double matrices(const std::string& path) {
  Hdf5Input file(path);
  for (const char* group : {"run", "integrator", "solver 1"}) file.enter(group);
  return file.number("matrices");
}

TEST_F(RestartTest, ACheckpointOfARestartThatTookNoStepIsWhole) {
  // What the first checkpoint said of preconditioners still waits for the first matrix.
  for (const char* preconditioner : {"Chebyshev", "Direct", "MueLu"}) {
    SCOPED_TRACE(preconditioner);
    on_first([&] { fs::remove_all(folder_); });
    const std::string scene =
        drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(5, 100),
              list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", preconditioner) +
                                        list("Reuse", number("Setup Cost", 1e6))));
    run_scene(scene, "whole");
    EXPECT_EQ(run_scene(scene, "between", checkpoint("whole", 25), [] { return true; }).status, RunStatus::Interrupted);
    EXPECT_EQ(run_scene(scene, "rest", checkpoint("between", 25)).status, RunStatus::Completed);
    EXPECT_EQ(history_rows(folder("whole")).back(), history_rows(folder("rest")).back());
    // And a run that writes one before its first step goes on itself.
    int calls = 0;
    const RunResult went_on = run_scene(scene, "beside", checkpoint("whole", 25), [&calls] { return ++calls > 100; });
    EXPECT_EQ(went_on.status, RunStatus::Completed);
    EXPECT_TRUE(fs::exists(checkpoint("beside", 25)));
    EXPECT_EQ(history_rows(folder("whole")).back(), history_rows(folder("beside")).back());
  }
}

TEST_F(RestartTest, LaggedPreconditionersGoOn) {
  const auto scene = [](const std::string& preconditioner, const std::string& scheme, double setup_cost,
                        const std::string& op = "Assembled") {
    return drawn(
        word("Type", scheme) + steps(0.02, 1), checkpoints(5, 100),
        list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", preconditioner) +
                                  word("Operator", op) + list("Reuse", number("Setup Cost", setup_cost)) +
                                  list("Preconditioner Types",
                                       list("MueLu", count("coarse: max size", 10) + word("verbosity", "none")))));
  };
  {
    SCOPED_TRACE("MueLu");
    expect_goes_on(scene("MueLu", "Bathe Composite", 3), {5, 25, 45});
    EXPECT_GE(matrices(checkpoint("whole", 25)), 1);
  }
  for (const char* preconditioner : {"Ifpack2", "Direct"}) {
    SCOPED_TRACE(preconditioner);
    expect_goes_on(scene(preconditioner, "Newmark", 3), {5, 25});
  }
  for (const char* op : {"Assembled", "Matrix-Free"}) {
    SCOPED_TRACE(std::string("Chebyshev, ") + op);
    expect_goes_on(scene("Chebyshev", "Bathe Composite", 3, op), {5, 25});
  }
  for (const char* coarse : {"MueLu", "Direct"}) {
    SCOPED_TRACE(std::string("Two-Level, ") + coarse);
    std::string linear = scene("Two-Level", "Bathe Composite", 3, "Matrix-Free");
    const std::string mesh = word("Type", "Box"), types = "<ParameterList name=\"Preconditioner Types\">";
    linear.insert(
        linear.find(types) + types.size(),
        list("Two-Level", list("Coarse", word("Type", coarse) + list("MueLu", count("coarse: max size", 10)))));
    std::string quadratic = linear;
    const std::string odd = counts("Divisions", {6, 3});
    expect_goes_on(linear.replace(linear.find(odd), odd.size(), counts("Divisions", {6, 4})), {5, 25});
    expect_goes_on(quadratic.insert(quadratic.find(mesh), count("Cell Order", 2)), {5, 25});
  }
  // A multigrid's finest level is the operator's own matrix, which only a new preconditioner changes.
  for (const char* preconditioner : {"MueLu", "Ifpack2", "Direct"}) {
    SCOPED_TRACE(std::string("matrix-free, ") + preconditioner);
    expect_goes_on(scene(preconditioner, "Newmark", 3, "Matrix-Free"), {5, 25});
  }
  std::string unsymmetric = scene("Direct", "Energy-Momentum", 3);
  {
    SCOPED_TRACE("Band LU");
    expect_goes_on(unsymmetric, {5, 25});
  }
  // KLU as a preconditioner: the order of its pivots is older than its matrix.
  SCOPED_TRACE("KLU");
  const std::string types = "<ParameterList name=\"Preconditioner Types\">";
  expect_goes_on(unsymmetric.insert(unsymmetric.find(types) + types.size(), list("Direct", word("Solver Type", "KLU"))),
                 {5, 25});
}

TEST_F(RestartTest, AnInterruptedRunGoesOnAsIfNothingHadHappened) {
  const std::string scene =
      drawn(word("Type", "Newmark") + steps(0.02, 1), count("History Interval", 10) + count("Fields Interval", 10));
  run_scene(scene, "whole");
  int calls = 0;
  const RunResult first = run_scene(scene, "parts", "", [&calls] { return ++calls > 23; });
  EXPECT_EQ(first.status, RunStatus::Interrupted);
  EXPECT_EQ(first.steps, 23);
  EXPECT_EQ(first.checkpoint, checkpoint("parts", 23));
  // The last state has a row, which the run as a whole has not.
  EXPECT_EQ(history_rows(folder("parts")).back().substr(0, 3), "23,");
  const RunResult rest = run_scene(scene, "parts", folder("parts") + "/checkpoint.h5");
  EXPECT_EQ(rest.status, RunStatus::Completed);
  expect_same("whole", "parts", true);
}

TEST_F(RestartTest, ARunGoesOnBeyondItsEnd) {
  const auto scene = [](double end) { return drawn(word("Type", "Bathe Composite") + steps(0.02, end)); };
  run_scene(scene(1), "whole");
  run_scene(scene(0.5), "parts");
  run_scene(scene(1), "parts", folder("parts") + "/checkpoint.h5");
  expect_same("whole", "parts");
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("Final Time: 0.5, now 1"), std::string::npos) << told_;
  }
  // Of a run that is over there is nothing to go on with.
  EXPECT_EQ(run_scene(scene(1), "parts", folder("parts") + "/checkpoint.h5").steps, 50);
  expect_same("whole", "parts");
}

TEST_F(RestartTest, AFailedRunGoesOnWithOtherSettings) {
  // Steps of 0.02469 lead to the load's pole at 0.12345; steps that end at multiples of 0.05 avoid it.
  const auto scene = [](double step) {
    return scaled(drawn(word("Type", "Newmark") + steps(step, 1), checkpoints(0, 2)), "1e-9/(t-0.12345)^2");
  };
  const RunResult failed = run_scene(scene(0.02469), "parts");
  ASSERT_EQ(failed.status, RunStatus::Diverged);
  EXPECT_EQ(failed.steps, 4);
  EXPECT_NE(failed.reason.find("not a finite number between t = 0.09876 and 0.12345"), std::string::npos)
      << failed.reason;
  EXPECT_EQ(failed.checkpoint, checkpoint("parts", 4));
  const RunResult rest = run_scene(scene(0.05), "parts", failed.checkpoint);
  EXPECT_EQ(rest.status, RunStatus::Completed);
  EXPECT_EQ(rest.steps, 4 + 1 + 18);  // to 0.1, and 18 whole steps
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("Time Step: 0.02469, now 0.05."), std::string::npos) << told_;
  }
}

/// Returns the column of history.csv whose name ends so.
std::vector<double> column(const std::string& folder, const std::string& name) {
  const std::vector<std::string> rows = history_rows(folder);
  const std::string& names = rows.front();
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(names.find(name));
  const std::ptrdiff_t place = std::count(names.begin(), end, ',');
  std::vector<double> values;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    std::istringstream row(rows[k]);
    std::string cell;
    for (std::ptrdiff_t i = 0; i <= place; ++i) std::getline(row, cell, ',');
    values.push_back(std::stod(cell));
  }
  return values;
}

double largest(const std::string& folder, const std::string& name) {
  const std::vector<double> values = column(folder, name);
  return *std::max_element(values.begin(), values.end());
}

TEST_F(RestartTest, AnotherSchemeTakesOver) {
  const auto scene = [](const std::string& scheme, double step) {
    return drawn(word("Type", scheme) + steps(step, 1), checkpoints(25, 9));
  };
  const RunResult fine = run_scene(scene("Newmark", 0.004), "fine");
  run_scene(scene("Newmark", 0.02), "parts");
  const RunResult other = run_scene(scene("Average Vector Field", 0.004), "parts", checkpoint("parts", 25));
  EXPECT_EQ(other.status, RunStatus::Completed);
  EXPECT_EQ(other.steps, 25 + 125);
  // It is the same motion: the two schemes differ by their errors.
  const auto place = [&](const std::string& name) { return column(folder(name), "_ux").back(); };
  EXPECT_NEAR(place("parts"), place("fine"), 2e-3 * std::abs(place("fine")));
  EXPECT_EQ(fine.restarts, 0);
}

/// A cantilever that bends under its weight, which a history puts on it by the time 1.
std::string bent(const std::string& scheme, double step, double final_time, const std::string& more = "") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {8, 1}) + counts("Divisions", {16, 2}))) +
         list("Materials", list("Rubber", "")) +
         list("Histories",
              list("Load", word("Type", "Ramp") +
                               list("Ramp", number("Value", 1) + number("Length", 1) + word("Shape", "Linear"))) +
                  list("Lift", word("Type", "Ramp") + list("Ramp", number("Value", 0.5) + number("Length", 1)))) +
         list("Boundary Conditions",
              list("Clamp", word("Node Set", "left") + word("Components", "xy")) +
                  list("Lift", word("Node Set", "right") + word("Components", "x") + word("History", "Lift")) +
                  list("Weight", word("Type", "Gravity") + numbers("Vector", {0, -400}) + word("History", "Load"))) +
         list("Output", checkpoints(0, 2)) +
         list("Time Integrator", word("Type", scheme) + more + steps(step, final_time));
}

TEST_F(RestartTest, AnEquilibriumStaysAtRestInEveryScheme) {
  ASSERT_EQ(run_scene(bent("Static", 0.1, 1), "equilibrium").status, RunStatus::Completed);
  for (const std::string scheme : {"Newmark", "Bathe Composite", "Average Vector Field", "Energy-Momentum"}) {
    SCOPED_TRACE(scheme);
    const std::string scene = bent(scheme, 0.001, 1.02);
    EXPECT_EQ(run_scene(scene, "rest", checkpoint("equilibrium", 10)).status, RunStatus::Completed);
    EXPECT_LT(largest(folder("rest"), "kinetic_energy"), 1e-14 * largest(folder("rest"), "elastic_energy"));
    // The rate of the last load step is 1/0.1 of its change of displacement: energy that no load has given.
    run_scene(bent(scheme, 0.001, 1.02, word("Velocity After Static", "Rate")), "moves", checkpoint("equilibrium", 10));
    EXPECT_GT(largest(folder("moves"), "kinetic_energy"), 1e-8 * largest(folder("moves"), "elastic_energy"));
  }
}

/// Two blocks, one above the other, whose surfaces are one surface that interacts with itself. The upper one is pushed
/// into the lower one by 0.2 within the time 1, and is then held.
std::string pushed_in(const std::string& scheme, double step, double final_time) {
  const std::string block = word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {4, 2}));
  const std::string all = list("all", numbers("Lower", {-100, -100}));
  return list("Mesh",
              word("Type", "Parts") +
                  list("Parts", list("lower", block) + list("upper", block + numbers("Translation", {0, 1.05}))) +
                  list("Sets", all)) +
         list("Materials", list("Lower", word("Block", "lower_body")) + list("Upper", word("Block", "upper_body"))) +
         list("Interactions",
              list("Self", word("Side Set", "all") + word("Primary Side Set", "all") + word("Smoothing", "None") +
                               number("Exclusion", 10) + word("Law", "Penalty") +
                               list("Penalty", number("Stiffness", 1) + number("Gap", 0.1)))) +
         list("Histories",
              list("Down", word("Type", "Ramp") + list("Ramp", number("Value", -0.25) + number("Length", 1)))) +
         list("Boundary Conditions",
              list("Floor", word("Node Set", "lower_bottom")) +
                  list("Push", word("Node Set", "upper_top") + word("Components", "y") + word("History", "Down")) +
                  list("Guide", word("Node Set", "upper_top") + word("Components", "x"))) +
         list("Output", checkpoints(0, 2)) + list("Time Integrator", word("Type", scheme) + steps(step, final_time));
}

TEST_F(RestartTest, PartsOfOneSurfaceThatOverlapPushEachOtherAfterARestart) {
  ASSERT_EQ(run_scene(pushed_in("Static", 0.05, 1), "overlap").status, RunStatus::Completed);
  const double energy = column(folder("overlap"), "contact_energy").back();
  ASSERT_GT(energy, 1e-3);
  ASSERT_LT(column(folder("overlap"), "min_gap").back(), 0);
  for (const std::string scheme : {"Newmark", "Average Vector Field"}) {
    ASSERT_EQ(run_scene(pushed_in(scheme, 0.001, 1.02), "dynamic", checkpoint("overlap", 20)).status,
              RunStatus::Completed);
    const std::vector<double> energies = column(folder("dynamic"), "contact_energy");
    EXPECT_NEAR(energies.front(), energy, 1e-12) << scheme;
    EXPECT_NEAR(energies.back(), energy, 1e-9) << scheme << ": it stays at rest";
  }
}

TEST_F(RestartTest, AHeldMotionIsNoJumpForARunThatResumes) {
  run_scene(bent("Static", 0.1, 1), "equilibrium");
  std::string scene = bent("Newmark", 0.001, 1.01);
  // A user resumes from the equilibrium with a motion that is held where the static one ended.
  const std::string ramp =
      list("Lift", word("Type", "Ramp") + list("Ramp", number("Value", 0.5) + number("Length", 1)));
  scene.replace(scene.find(ramp), ramp.size(),
                list("Lift", word("Type", "Constant") + list("Constant", number("Value", 0.5))));
  Simulation simulation(test::scene(scene), world());
  const auto jumps = [&] {
    return std::any_of(simulation.warnings().begin(), simulation.warnings().end(),
                       [](const Warning& warning) { return warning.name.find("jump") != std::string::npos; });
  };
  EXPECT_TRUE(jumps()) << "a run from the beginning would";
  RunOptions options;
  options.folder = folder("held");
  options.restart = checkpoint("equilibrium", 10);
  EXPECT_EQ(run(simulation, options).status, RunStatus::Completed);
  EXPECT_FALSE(jumps());
}

TEST_F(RestartTest, AnotherFolderBeginsWithTheStateOfTheCheckpoint) {
  const std::string scene =
      drawn(word("Type", "Newmark") + steps(0.02, 1), count("Fields Interval", 10) + checkpoints(20, 9));
  run_scene(scene, "whole");
  run_scene(scene, "elsewhere", checkpoint("whole", 20));
  const auto all = history_rows(folder("whole")), later = history_rows(folder("elsewhere"));
  ASSERT_EQ(later.size(), 32U);
  for (std::size_t row = 2; row < later.size(); ++row) EXPECT_EQ(later[row], all[row + 20]);
  EXPECT_EQ(later[1].substr(0, 3), "20,");
  EXPECT_EQ(run_scene(scene, "elsewhere", checkpoint("elsewhere", 40)).steps, 50);
  EXPECT_EQ(history_rows(folder("elsewhere")), later);
}

TEST_F(RestartTest, OtherSolversGoOnToTolerance) {
  const auto scene = [](const std::string& solver) {
    return drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(20, 9), list("Linear Solver", solver));
  };
  run_scene(scene(word("Linear Solver Type", "Direct")), "whole");
  copy("whole", "parts");
  run_scene(scene(word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Ifpack2")), "parts",
            checkpoint("parts", 20));
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("to solver tolerance, not bit for bit"), std::string::npos) << told_;
  }
  const auto one = history_rows(folder("whole")), other = history_rows(folder("parts"));
  ASSERT_EQ(one.size(), other.size());
  const auto energy = [](const std::string& row) {
    std::string cell;
    std::istringstream text(row);
    for (int column = 0; column < 5; ++column) std::getline(text, cell, ',');
    return std::stod(cell);
  };
  EXPECT_NEAR(energy(other.back()), energy(one.back()), 1e-7 * energy(one.back()));
}

}  // namespace
}  // namespace ixos::test

// Runs of scenes with stages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run/restart_fixture.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "study/common/history_table.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos::test {
namespace {

std::string integrator(const std::string& scheme, double step, double end, const std::string& more = "") {
  return list("Time Integrator", word("Type", scheme) + steps(step, end) + more);
}

std::string ramp(const std::string& name, double value, double length) {
  return list(name, word("Type", "Ramp") + list("Ramp", number("Value", value) + number("Length", length)));
}

/// A block whose top goes down towards a sticky wall, in these stages.
std::string block(const std::string& stages, const std::string& output = "", const std::string& more = "") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 3}))) +
         list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", 0.1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.4}))) +
         list("Histories", ramp("Lift", -0.15, 1)) +
         list("Boundary Conditions",
              list("Head", word("Node Set", "top") + word("Components", "y") + word("History", "Lift")) +
                  list("Guide", word("Node Set", "left") + word("Components", "x"))) +
         list("Output", output + texts("Reactions", "{top}")) + integrator("Static", 0.1, 1) + list("Stages", stages) +
         more;
}

std::string press_wait_pull(const std::string& scheme) {
  return list("Press", "") + list("Wait", integrator(scheme, 0.05, 0.5)) +
         list("Pull", list("Histories", ramp("Lift", 0.4, 1)) + integrator(scheme, 0.05, 1));
}

class StagesTest : public RestartTest {
 protected:
  HistoryTable table(const std::string& name) const { return HistoryTable(folder(name) + "/history.csv"); }
  nlohmann::json summary(const std::string& name) const {
    std::ifstream file(folder(name) + "/summary.json");
    return nlohmann::json::parse(file);
  }
};

TEST_F(StagesTest, EachGoesOnFromTheOneBeforeInOneHistory) {
  const RunResult result = run_scene(block(press_wait_pull("Average Vector Field")), "all");
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.steps, 10 + 10 + 20);
  EXPECT_NEAR(result.end_time, 2.5, 1e-12);
  ASSERT_EQ(result.stages.size(), 2U);
  EXPECT_EQ(result.stages[1].name, "Wait");
  EXPECT_EQ(result.stages[1].steps, 20);
  world()->barrier();
  const HistoryTable rows = table("all");
  ASSERT_EQ(rows.rows(), 41U);
  EXPECT_EQ(rows.column("step").back(), 40);
  const std::vector<double>&work = rows.column("external_work"), &total = rows.column("total_energy"),
        &lost = rows.column("dissipated_energy");
  // From the first stage's end on the balance is that of the dynamic schemes: damping takes what the work gives.
  for (std::size_t k = 11; k < rows.rows(); ++k)
    EXPECT_NEAR(total[k] - work[k] + lost[k], total[10] - work[10] + lost[10], 1e-7 * std::abs(total[0])) << k;
  EXPECT_GT(lost.back(), 0);
  // A source of the second stage has no numbers in the first one.
  EXPECT_TRUE(std::isnan(rows.column("dissipated_damping")[5]));
  EXPECT_DOUBLE_EQ(rows.column("dissipated_damping").back(), lost.back());
  EXPECT_EQ(summary("all")["stages"].size(), 3U);
}

TEST_F(StagesTest, AStageIsARestartInItsScene) {
  const std::string stages = press_wait_pull("Average Vector Field");
  run_scene(block(stages), "stages");
  // By hand: the first stage alone, then from its checkpoint the scene of the second, and so on.
  const Stages all(scene(block(stages)));
  std::vector<double> begins;
  for (std::size_t k = 0; k < 3; ++k) {
    Teuchos::ParameterList own = complete_scene(all.scene(begins));
    own.remove("Stages");
    own.sublist("Time Integrator").sublist("Time Step Control").set("Initial Time", 0.0);  // a restart cannot change it
    own.sublist("Output").sublist("Checkpoint").set("Keep", 1);
    Simulation simulation(own, world());
    RunOptions options;
    options.folder = folder("hand " + std::to_string(k));
    if (k > 0) options.restart = folder("hand " + std::to_string(k - 1));
    run(simulation, options);
    begins.push_back(k == 0 ? 1 : 1.5);
  }
  world()->barrier();
  const HistoryTable whole = table("stages");
  std::size_t row = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const HistoryTable hand = table("hand " + std::to_string(k));
    for (std::size_t own = k == 0 ? 0 : 1; own < hand.rows(); ++own, ++row)
      for (const std::string& name : hand.names())
        if (name != "wall_seconds" && name.rfind("dissipated_d", 0) != 0) {
          EXPECT_EQ(hand.column(name)[own], whole.column(name)[row]) << name << ", row " << row;
        }
  }
  EXPECT_EQ(row, whole.rows());
}

TEST_F(StagesTest, EverySchemeGoesOnToTheLastBit) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    expect_goes_on(block(press_wait_pull(scheme),
                         count("History Interval", 3) + count("Fields Interval", 4) + checkpoints(5, 100)),
                   {5, 10, 20, 30});
  }
}

TEST_F(StagesTest, ARunInTwoPartsIsTheSameRun) {
  // A block that slides on its wall, with branches: memories of points and sides go from stage to stage.
  const std::string branches =
      list("Maxwell Branches", numbers("Relaxation Times", {0.05, 2}) + numbers("Moduli", {0.4, 0.2}));
  const std::string friction = list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.5));
  const auto sliding = [&](double end, const std::string& stages) {
    return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 2}))) +
           list("Materials", list("Rubber", number("Density", 1) + number("Viscosity", 0.02) + branches)) +
           list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.26}) + friction)) +
           list("Initial Conditions", numbers("Velocity", {0.15, 0})) + integrator("Average Vector Field", 0.05, end) +
           list("Stages", stages);
  };
  run_scene(sliding(1, ""), "one");
  run_scene(sliding(0.5, list("First", "") + list("Second", "")), "two");
  world()->barrier();
  const HistoryTable one = table("one"), two = table("two");
  ASSERT_EQ(one.rows(), two.rows());
  for (const char* name :
       {"time", "total_energy", "dissipated_friction_of_Wall", "friction_force_Wall_x", "mean_slip_Wall",
        "dissipated_viscoelasticity_of_body", "dissipated_energy", "linear_momentum_x"}) {
    ASSERT_TRUE(one.has(name)) << testing::PrintToString(one.names());
    EXPECT_NE(one.column(name).back(), 0) << name;
    for (std::size_t row = 0; row < one.rows(); ++row)
      EXPECT_NEAR(two.column(name)[row], one.column(name)[row], 1e-8 * std::max(1e-2, std::abs(one.column(name)[row])))
          << name << ", row " << row;
  }
}

TEST_F(StagesTest, MatrixFreeAndOtherFoldersGoOn) {
  const std::string free =
      list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev") +
                                word("Operator", "Matrix-Free"));
  const std::string scene = block(press_wait_pull("Newmark"), checkpoints(6, 100), free);
  expect_goes_on(scene, {12, 30});
  const RunResult elsewhere = run_scene(scene, "elsewhere", checkpoint("whole", 30));
  EXPECT_EQ(elsewhere.steps, 40);
  world()->barrier();
  EXPECT_EQ(table("elsewhere").column("total_energy").back(), table("whole").column("total_energy").back());
  EXPECT_EQ(read_scene_file(folder("elsewhere") + "/effective.xml").sublist("Stages").numParams(), 3);
}

TEST_F(StagesTest, ACriterionEndsAStageAndTheNextBeginsThere) {
  const std::string stop = list(
      "Stop",
      list("Preload", word("Type", "Reaction") + list("Reaction", word("Node Set", "top") + number("Limit", 0.05))));
  const std::string stages = list("Press", list("Time Integrator", stop)) +
                             list("Pull", list("Histories", ramp("Lift", 0.3, 1)) + integrator("Static", 0.1, 1));
  const RunResult result = run_scene(block(stages), "all");
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  ASSERT_EQ(result.stages.size(), 1U);
  const StageEnd& press = result.stages[0];
  expect_contains(press.reason, "Preload: the reaction y of top is ");
  EXPECT_LT(press.time, 1 - 1e-9);
  EXPECT_NEAR(result.end_time, press.time + 1, 1e-12);
  world()->barrier();
  const HistoryTable rows = table("all");
  const std::vector<double>& reaction = rows.column("reaction_top_y");
  const auto last = static_cast<std::size_t>(press.steps);
  EXPECT_GE(reaction[last], 0.05);
  for (std::size_t k = 0; k < last; ++k) EXPECT_LT(reaction[k], 0.05);
}

TEST_F(StagesTest, TheGuidesScenePressesWaitsAndPulls) {
  Simulation simulation(read_scene_file(std::string(IXOS_XML_DIRECTORY) + "/press-wait-pull.xml"), world());
  std::shared_ptr<Simulation> last;
  RunOptions options;
  options.folder = folder("guide");
  options.stage = [&](const std::shared_ptr<Simulation>& stage) { last = stage; };
  const RunResult result = run(simulation, options);
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  ASSERT_EQ(result.stages.size(), 2U);
  const double pressed = result.stages[0].time;
  EXPECT_NEAR(result.stages[1].time, pressed + 2, 1e-9);
  EXPECT_NEAR(result.end_time, pressed + 22, 1e-9);
  // The head went down by 3 L0 in 10 T0, stayed, and went up by 6 L0.
  const Model& model = last->model();
  std::vector<double> head(static_cast<std::size_t>(model.space().local()), -1e9);
  model.constraints().set(result.end_time, head.data(), nullptr, nullptr);
  EXPECT_NEAR(model.space().maximum(*std::max_element(head.begin(), head.end())), 6 - 0.3 * pressed, 1e-9);
  world()->barrier();
  const std::vector<double> force = table("guide").column("reaction_top_y");
  EXPECT_LT(force[static_cast<std::size_t>(result.stages[0].steps)], -0.5);
  EXPECT_GT(*std::max_element(force.begin(), force.end()), 0.5);
}

TEST_F(StagesTest, VelocitiesAreAddedAndTheirEnergyIsWork) {
  const std::string free = texts("Without", "{Boundary Conditions/Head, Boundary Conditions/Guide}");
  const std::string stages =
      list("Hold", "") + list("Fly", free + list("Initial Conditions", numbers("Velocity", {0.5, 2})) +
                                         integrator("Average Vector Field", 0.01, 0.2));
  const RunResult result = run_scene(block(stages, list("Probes", list("Tip", numbers("Point", {1, 1})))), "all");
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  world()->barrier();
  const HistoryTable rows = table("all");
  const std::size_t hold = 10;
  // The mass is 2, at rest before.
  EXPECT_NEAR(rows.column("external_work")[hold + 1] - rows.column("external_work")[hold], 0.5 * 2 * 4.25, 0.02);
  EXPECT_NEAR(rows.column("linear_momentum_x")[hold + 1], 2 * 0.5, 0.01);
  EXPECT_EQ(rows.column("reaction_top_y").back(), 0);
  EXPECT_LT(result.max_energy_error, 2e-3 * result.largest_energy);
}

TEST_F(StagesTest, AStageThatCannotBeginEndsTheRunWithWhatIsThere) {
  // Let go, the head springs back; to hold it again where it was is a jump.
  const std::string head = list("Head", word("Node Set", "top") + word("Components", "y") + word("History", "Lift"));
  const std::string stages =
      list("Press", "") +
      list("Let Go", texts("Without", "{Boundary Conditions/Head}") + integrator("Newmark", 0.05, 0.5)) +
      list("Catch", list("Boundary Conditions", head) + integrator("Newmark", 0.05, 0.5));
  const RunResult result = run_scene(block(stages, checkpoints(100, 1)), "all");
  EXPECT_EQ(result.status, RunStatus::Diverged);
  expect_contains(result.reason, "the stage Catch cannot begin: a prescribed displacement would jump by ");
  EXPECT_EQ(result.steps, 20);
  world()->barrier();
  EXPECT_EQ(table("all").rows(), 21U);
  // Nothing is lost: once the scene is mended, the run goes on.
  std::string mended = block(stages, checkpoints(100, 1));
  mended.replace(mended.find(head, mended.find("Catch")), head.size(), "");
  const RunResult rest = run_scene(mended, "all", folder("all"));
  EXPECT_EQ(rest.status, RunStatus::Completed) << rest.reason;
  EXPECT_EQ(rest.steps, 30);
}

TEST_F(StagesTest, LaterStagesAreRefusedBeforeTheFirst) {
  const auto refused = [](const std::string& stages) {
    return test::refusal([&] { Simulation(scene(block(stages)), world()); });
  };
  const std::string no_set = list("Boundary Conditions", list("Head", word("Node Set", "topp")));
  expect_contains(refused(list("Press", "") + list("Pull", integrator("Newmark", 0.1, 1) + no_set)),
                  "Stages/Pull: Boundary Conditions/Head");
  const std::string jump = word("Clock", "Run") + list("Histories", ramp("Lift", 1, 0.5));
  expect_contains(refused(list("Press", "") + list("Pull", jump + integrator("Static", 0.1, 2))),
                  "Stages/Pull: Boundary Conditions: a prescribed displacement would jump by 1.15 L0 at t = 1 T0");
  expect_contains(refused(list("Press", "") + list("Pull", word("Clock", "Run") + integrator("Newmark", 0.1, 0.5))),
                  "Stages/Pull: Time Integrator/Time Step Control/Final Time: 0.5 must be later than Initial Time, 1");
}

TEST_F(StagesTest, EnrichedSurfacesAreThoseOfAllStages) {
  const std::string other = list("Interactions", list("Wall", word("Contact Element", "Q1C2")));
  expect_contains(test::refusal([&] {
                    Simulation(scene(block(list("Press", "") + list("Pull", other + integrator("Static", 0.1, 1)))),
                               world());
                  }),
                  "Stages/Pull: the mesh is another one than that of the stage before");
  // Criteria, too, are looked at before the first stage.
  const std::string stop =
      list("Stop", list("Out", word("Type", "Probe") + list("Probe", word("Name", "none") + number("Limit", 1))));
  expect_contains(test::refusal([&] {
                    Simulation(scene(block(list("Press", "") + list("Pull", integrator("Static", 0.1, 1, stop)))),
                               world());
                  }),
                  "Stages/Pull: Time Integrator/Stop/Out");
}

TEST_F(StagesTest, AWallThatHasPassedTheBodyAtRestGoesOn) {
  const std::string wall = list("Wall", list("Motion", texts("Translation", "{-, Rise}")));
  const std::string rise = list("Histories", ramp("Rise", 0.5, 1)),
                    still = list("Rise", word("Type", "Constant") + list("Constant", number("Value", 0)));
  std::string whole = block(list("Press", list("Interactions", wall) + rise) +
                            list("Wait", list("Histories", still) + integrator("Static", 0.1, 1)));
  // The head goes up with the wall.
  whole.replace(whole.find(ramp("Lift", -0.15, 1)), ramp("Lift", -0.15, 1).size(), ramp("Lift", 0.3, 1));
  const RunResult result = run_scene(whole, "all");
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.steps, 20);
}

TEST_F(StagesTest, AnotherRunInTheFolderLeavesNoCheckpointOfTheOneBefore) {
  const std::string first = block(press_wait_pull("Newmark"), checkpoints(10, 100));
  run_scene(first, "all");
  const std::string before = contents(checkpoint("all", 10));
  run_scene(first, "all", "", [asked = 0]() mutable { return ++asked == 14; });
  world()->barrier();
  EXPECT_NE(contents(checkpoint("all", 10)), before);  // it has its own clock
  const RunResult rest = run_scene(first, "all", folder("all"));
  EXPECT_EQ(rest.status, RunStatus::Completed) << rest.reason;
}

TEST_F(StagesTest, ACheckpointOfAStageThatIsGoneIsRefused) {
  run_scene(block(press_wait_pull("Newmark"), checkpoints(6, 100)), "all");
  expect_contains(test::refusal([&] { run_scene(block(list("Press", "")), "other", checkpoint("all", 30)); }),
                  "was written in stage 3, but the scene has 1");
}

TEST_F(StagesTest, AnObserverSeesTheSimulationOfEachStage) {
  Simulation simulation(scene(block(press_wait_pull("Newmark"))), world());
  std::vector<std::size_t> stages;
  std::shared_ptr<Simulation> present;
  RunOptions options;
  options.folder = folder("all");
  options.stage = [&](const std::shared_ptr<Simulation>& stage) {
    stages.push_back(stage->stage());
    present = stage;
  };
  options.observe = [&](const Progress& progress) {
    EXPECT_EQ((present ? *present : simulation).integrator().time(), progress.time);
    EXPECT_NEAR(progress.final_time, 2.5, 1e-12);
    return progress.step == 35 ? "enough" : "";
  };
  const RunResult result = run(simulation, options);
  EXPECT_EQ(stages, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(result.status, RunStatus::Stopped);
  EXPECT_EQ(result.reason, "enough");
  EXPECT_EQ(result.steps, 35);
}

}  // namespace
}  // namespace ixos::test

// Runs that go on from a checkpoint: as if nothing had happened, or with a clear word.
#include "scene/restart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "checkpoint/hdf5_file.hpp"
#include "scene/checkpoints.hpp"
#include "scene/run.hpp"
#include "scene/scene_changes.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

namespace fs = std::filesystem;
using test::count;
using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

/// A block that is drawn down to a sticky wall by one side, under a load and damped: every kind of force and sum.
std::string drawn(const std::string& integrator, const std::string& output = "", const std::string& more = "") {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {6, 3}))) +
         list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", 0.1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.9}))) +
         list("Histories",
              list("Down", word("Type", "Sine") + list("Sine", number("Offset", 0) + number("Amplitude", -0.5) +
                                                                   number("Frequency", 0.25)))) +
         list("Boundary Conditions",
              list("Grip", word("Node Set", "left") + word("Components", "y") + word("History", "Down")) +
                  list("Pull", word("Type", "Traction") + word("Side Set", "right") + numbers("Vector", {0.02, 0}))) +
         list("Initial Conditions", numbers("Velocity", {0.1, 0})) +
         list("Output", output + list("Probes", list("Edge", numbers("Point", {2, 0}))) +
                            "<Parameter name=\"Reactions\" type=\"Array(string)\" value=\"{left}\"/>") +
         list("Time Integrator", integrator) + more;
}

std::string steps(double step, double final_time, const std::string& more = "") {
  return list("Time Step Control", number("Time Step", step) + number("Final Time", final_time) + more);
}

std::string checkpoints(int interval, int keep) {
  return list("Checkpoint", count("Interval", interval) + count("Keep", keep));
}

/// The rows of history.csv without their wall-clock seconds.
std::vector<std::string> rows(const std::string& folder) {
  std::ifstream file(folder + "/history.csv");
  std::string line, cell;
  std::size_t clock = 0;
  std::vector<std::string> result;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    for (std::istringstream row(line); std::getline(row, cell, ',');) cells.push_back(cell);
    if (result.empty())
      clock = static_cast<std::size_t>(std::find(cells.begin(), cells.end(), "wall_seconds") - cells.begin());
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(clock));
    result.push_back(fmt::format("{}", fmt::join(cells, ",")));
  }
  return result;
}

std::string bytes(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class RestartTest : public testing::Test {
 protected:
  void SetUp() override {
    on_first([&] { fs::remove_all(folder_); });
  }
  void TearDown() override {
    on_first([&] { fs::remove_all(folder_); });
  }

  template <class Function>
  static void on_first(const Function& function) {
    world()->barrier();
    if (world()->getRank() == 0) function();
    world()->barrier();
  }
  std::string folder(const std::string& name) const { return folder_ + "/" + name; }
  std::string checkpoint(const std::string& name, long step) const { return checkpoint_path(folder(name), step); }

  RunResult run_scene(const std::string& scene, const std::string& name, const std::string& restart = "",
                      const std::function<bool()>& interrupted = {}) {
    Simulation simulation(test::scene(scene), world());
    RunOptions options;
    options.folder = folder(name);
    options.restart = restart;
    options.interrupted = interrupted;
    options.tell = [this](const std::string& line) { told_ += line + "\n"; };
    return run(simulation, options);
  }
  /// A copy of a run's folder, with its checkpoints.
  void copy(const std::string& from, const std::string& to) {
    on_first([&] {
      fs::remove_all(folder(to));
      fs::copy(folder(from), folder(to), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    });
  }
  void expect_same(const std::string& one, const std::string& other) {
    world()->barrier();
    EXPECT_EQ(rows(folder(one)), rows(folder(other)));
    for (const auto& entry : fs::directory_iterator(folder(one))) {
      const std::string name = entry.path().filename();
      if (name.rfind("fields.e", 0) != 0) continue;
      EXPECT_TRUE(bytes(entry.path()) == bytes(folder(other) + "/" + name)) << name;
    }
    world()->barrier();
  }
  /// Runs to the end; then from some of the checkpoints again: the same files must come out.
  void expect_goes_on(const std::string& scene, const std::vector<long>& from) {
    const RunResult whole = run_scene(scene, "whole");
    ASSERT_EQ(whole.status, RunStatus::Completed) << whole.reason;
    for (const long step : from) {
      copy("whole", "again");
      const RunResult again = run_scene(scene, "again", checkpoint("again", step));
      expect_same("whole", "again");
      EXPECT_EQ(again.steps, whole.steps);
      EXPECT_EQ(again.rejected_steps, whole.rejected_steps);
      EXPECT_EQ(again.newton_iterations, whole.newton_iterations);
      EXPECT_EQ(again.max_energy_error, whole.max_energy_error);
      EXPECT_EQ(again.max_forces, whole.max_forces);
      EXPECT_EQ(again.restarts, 1);
    }
  }
  /// All files of a folder.
  std::map<std::string, std::string> contents(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder(name))) files[entry.path().filename()] = bytes(entry.path());
    return files;
  }
  /// The message of the InputError that going on throws, without the rest having changed.
  std::string refusal(const std::string& scene, const std::string& name, const std::string& restart) {
    world()->barrier();
    const auto before = contents(name);
    world()->barrier();
    std::string message;
    try {
      run_scene(scene, name, restart);
      ADD_FAILURE() << "it was not refused";
    } catch (const InputError& error) {
      message = error.what();
    }
    world()->barrier();
    EXPECT_TRUE(contents(name) == before) << "something was changed";
    return message;
  }

  std::string folder_ = testing::TempDir() + "ixos_restart_" + std::to_string(world()->getSize());
  std::string told_;
};

TEST_F(RestartTest, EverySchemeGoesOnToTheLastBit) {
  for (const std::string& scheme : test::moving_schemes()) {
    SCOPED_TRACE(scheme);
    // Sums since the row before, and steps without a row or frame, are carried over too.
    expect_goes_on(drawn(word("Type", scheme) + steps(0.02, 1),
                         count("History Interval", 3) + count("Fields Interval", 4) + checkpoints(10, 100)),
                   {10, 40});
  }
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

TEST_F(RestartTest, CutStepsGoOn) {
  // Too few iterations where the surface jumps to the wall.
  expect_goes_on(drawn(word("Type", "Newmark") + steps(0.2, 4, count("Maximum Cuts", 10)), checkpoints(1, 1000),
                       list("Nonlinear Solver", count("Maximum Iterations", 4))),
                 {3, 9, 15});
}

TEST_F(RestartTest, StaticsGoOn) {
  std::string scene = drawn(word("Type", "Static") + steps(0.05, 1), checkpoints(4, 100));
  // Nothing else would hold the block sideways.
  const std::string loose = word("Components", "y");
  scene.replace(scene.find(loose), loose.size(), word("Components", "xy"));
  expect_goes_on(scene, {4, 16});
}

/// What the lagged solver of the first stage has in a checkpoint.
double matrices(const std::string& path) {
  Hdf5Input file(path);
  for (const char* group : {"run", "integrator", "stage 1"}) file.enter(group);
  return file.number("matrices");
}

TEST_F(RestartTest, LaggedPreconditionersGoOn) {
  const auto scene = [](const std::string& preconditioner, const std::string& scheme, double setup_cost) {
    return drawn(
        word("Type", scheme) + steps(0.02, 1), checkpoints(5, 100),
        list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", preconditioner) +
                                  list("Reuse", number("Setup Cost", setup_cost)) +
                                  list("Preconditioner Types",
                                       list("MueLu", count("coarse: max size", 10) + word("verbosity", "none")))));
  };
  {
    SCOPED_TRACE("MueLu");
    expect_goes_on(scene("MueLu", "Bathe Composite", 3), {5, 25, 45});
    EXPECT_EQ(matrices(checkpoint("whole", 25)), 2) << "it was renewed, and has the prolongators of its first matrix";
  }
  for (const char* preconditioner : {"Ifpack2", "Direct"}) {
    SCOPED_TRACE(preconditioner);
    expect_goes_on(scene(preconditioner, "Newmark", 3), {5, 25});
  }
  // KLU as a preconditioner: the order of its pivots is older than its matrix.
  SCOPED_TRACE("KLU");
  expect_goes_on(scene("Direct", "Energy-Momentum", 3), {5, 25});
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
  EXPECT_EQ(rows(folder("parts")).back().substr(0, 3), "23,");
  const RunResult rest = run_scene(scene, "parts", folder("parts") + "/checkpoint.h5");
  EXPECT_EQ(rest.status, RunStatus::Completed);
  expect_same("whole", "parts");
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
  const auto scene = [](int iterations) {
    return drawn(word("Type", "Newmark") + steps(0.05, 1), checkpoints(0, 2),
                 list("Nonlinear Solver", count("Maximum Iterations", iterations)));
  };
  const RunResult failed = run_scene(scene(3), "parts");
  ASSERT_EQ(failed.status, RunStatus::Diverged);
  EXPECT_NE(failed.reason.find("did not converge in 3 iterations"), std::string::npos) << failed.reason;
  EXPECT_EQ(failed.checkpoint, checkpoint("parts", failed.steps));
  const RunResult rest = run_scene(scene(100), "parts", failed.checkpoint);
  EXPECT_EQ(rest.status, RunStatus::Completed);
  EXPECT_EQ(rest.steps, 20);
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("Changed: Nonlinear Solver/Maximum Iterations: 3, now 100."), std::string::npos) << told_;
  }
}

TEST_F(RestartTest, AnotherSchemeTakesOver) {
  const auto scene = [](const std::string& scheme, double step) {
    return drawn(word("Type", scheme) + steps(step, 1), checkpoints(25, 9));
  };
  const RunResult fine = run_scene(scene("Newmark", 0.001), "fine");
  run_scene(scene("Newmark", 0.02), "parts");
  const RunResult other = run_scene(scene("Average Vector Field", 0.001), "parts", checkpoint("parts", 25));
  EXPECT_EQ(other.status, RunStatus::Completed);
  EXPECT_EQ(other.steps, 525);
  // It is the same motion: the two schemes differ by their errors.
  const auto place = [&](const std::string& name) {
    const std::string row = rows(folder(name)).back();
    std::vector<double> cells;
    std::string cell;
    for (std::istringstream text(row); std::getline(text, cell, ',');)
      cells.push_back(cell.empty() ? 0 : std::stod(cell));
    return cells[cells.size() - 4];
  };
  EXPECT_NEAR(place("parts"), place("fine"), 2e-3 * std::abs(place("fine")));
  EXPECT_EQ(fine.restarts, 0);
}

TEST_F(RestartTest, AnotherFolderBeginsWithTheStateOfTheCheckpoint) {
  const std::string scene =
      drawn(word("Type", "Newmark") + steps(0.02, 1), count("Fields Interval", 10) + checkpoints(20, 9));
  run_scene(scene, "whole");
  run_scene(scene, "elsewhere", checkpoint("whole", 20));
  const auto all = rows(folder("whole")), later = rows(folder("elsewhere"));
  ASSERT_EQ(later.size(), 32U);
  for (std::size_t row = 2; row < later.size(); ++row) EXPECT_EQ(later[row], all[row + 20]);
  EXPECT_EQ(later[1].substr(0, 3), "20,");
  EXPECT_EQ(run_scene(scene, "elsewhere", checkpoint("elsewhere", 40)).steps, 50);
  EXPECT_EQ(rows(folder("elsewhere")), later);
}

TEST_F(RestartTest, TheLastOnesAreKeptAndOtherRunsAreTidiedAway) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(10, 3));
  run_scene(scene, "whole");
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{30, 40, 50}));
  EXPECT_EQ(fs::read_symlink(folder("whole") + "/checkpoint.h5"), "checkpoint-50.h5");
  // Back to an earlier one: those after it are of a history that is no more.
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 0.7), checkpoints(5, 3)), "whole", checkpoint("whole", 30));
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{30, 35}));
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(10, 0)), "none");
  EXPECT_TRUE(checkpoint_steps(folder("none")).empty());
}

TEST_F(RestartTest, TheClockAsksForCheckpointsToo) {
  // Every step is longer than that.
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 0.2),
                  list("Checkpoint", number("Wall-Clock Interval", 1e-9) + count("Keep", 99))),
            "whole");
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_F(RestartTest, ChangesThatARestartCannotMakeAreRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.2));
  run_scene(scene, "whole");
  const std::string file = checkpoint("whole", 10);
  std::string other = scene;
  other.replace(other.find("{6, 3}"), 6, "{6, 4}");
  EXPECT_NE(refusal(other, "whole", file).find("Mesh/Box/Divisions: {6, 3}, now {6, 4}"), std::string::npos)
      << refusal(other, "whole", file);
  other = scene;
  other.replace(other.find("{2, 1}"), 6, "{2, 1.5}");
  EXPECT_NE(refusal(other, "whole", file).find("of another mesh"), std::string::npos);
  other = scene;
  other.replace(other.find("{0.1, 0}"), 8, "{0.3, 0}");
  EXPECT_NE(refusal(other, "whole", file).find("Initial Conditions/Velocity: {0.1, 0}, now {0.3, 0}"),
            std::string::npos)
      << refusal(other, "whole", file);
  other = scene;
  other.replace(other.find("{left}"), 6, "{}");
  EXPECT_NE(refusal(other, "whole", file).find("other columns"), std::string::npos);
}

TEST_F(RestartTest, AHistoryOfAnotherRunIsNotGoneOnWith) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  run_scene(scene, "whole");
  on_first([&] { std::ofstream(folder("whole") + "/history.csv", std::ios::app) << "21,"; });
  run_scene(scene, "whole", checkpoint("whole", 10));  // what is beyond the checkpoint does not matter
  copy("whole", "short");
  on_first([&] { fs::resize_file(folder("short") + "/history.csv", 1000); });
  EXPECT_NE(refusal(scene, "short", checkpoint("short", 10)).find("is not the table to go on with"), std::string::npos);
  on_first([&] { fs::remove(folder("short") + "/history.csv"); });
  EXPECT_NE(refusal(scene, "short", checkpoint("short", 10)).find("is not there"), std::string::npos);
}

TEST_F(RestartTest, DamagedCheckpointsAreRefusedAndTheOneBeforeIsOffered) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.6), checkpoints(10, 9));
  run_scene(scene, "whole");
  const std::string last = checkpoint("whole", 30), before = checkpoint("whole", 20), first = checkpoint("whole", 10);
  on_first([&] {
    std::fstream file(last, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(3000);
    file.put('!');
  });
  EXPECT_NE(refusal(scene, "whole", last)
                .find("checkpoint-30.h5: is damaged: its checksum does not fit its contents; the "
                      "one before it is sound: "),
            std::string::npos);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/checkpoint.h5").find(before), std::string::npos);
  on_first([&] { fs::resize_file(before, 100); });
  EXPECT_NE(refusal(scene, "whole", last).find(first), std::string::npos);
  on_first([&] {
    fs::remove(first);
    fs::remove(last);
  });
  EXPECT_NE(refusal(scene, "whole", last).find("there is no sound one before it"), std::string::npos)
      << refusal(scene, "whole", last);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/checkpoint.h5").find("checkpoint-30.h5: cannot be read"),
            std::string::npos);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/history.csv").find("is not a checkpoint of Ixos"),
            std::string::npos);
}

TEST_F(RestartTest, ARefusalByOneFileLeavesAllAsTheyWere) {
  const std::string scene =
      drawn(word("Type", "Newmark") + steps(0.02, 0.6), count("Fields Interval", 5) + checkpoints(10, 9));
  run_scene(scene, "whole");
  copy("whole", "parts");
  // The last rank's frames are gone.
  const std::string last = world()->getSize() == 1
                               ? "fields.e"
                               : fmt::format("fields.e.{0}.{1}", world()->getSize(), world()->getSize() - 1);
  on_first([&] { fs::resize_file(folder("parts") + "/" + last, 2000); });
  EXPECT_NE(refusal(scene, "parts", checkpoint("parts", 10)).find(last), std::string::npos);
  on_first([&] {
    fs::copy_file(folder("whole") + "/" + last, folder("parts") + "/" + last, fs::copy_options::overwrite_existing);
  });
  expect_same("whole", "parts");
  // A later checkpoint still finds its rows and frames.
  run_scene(scene, "parts", checkpoint("parts", 20));
  expect_same("whole", "parts");
}

TEST_F(RestartTest, TheLinkFollowsWhereARunGoesBack) {
  const auto scene = [](double end) { return drawn(word("Type", "Newmark") + steps(0.02, end), checkpoints(10, 9)); };
  run_scene(scene(0.6), "whole");
  // Killed as soon as it has begun: nothing is written after the files were cut back.
  run_scene(scene(0.6), "whole", checkpoint("whole", 10), [] { return true; });
  world()->barrier();
  EXPECT_EQ(fs::read_symlink(folder("whole") + "/checkpoint.h5"), "checkpoint-10.h5");
  EXPECT_EQ(run_scene(scene(0.6), "whole", folder("whole") + "/checkpoint.h5").steps, 30);
  EXPECT_EQ(run_scene(scene(0.6), "whole", folder("whole")).steps, 30) << "a folder stands for its newest";
}

TEST_F(RestartTest, AFreshRunDoesNotPassForTheEarlierOne) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 2));
  run_scene(scene, "whole");
  int calls = 0;
  const auto kill = [&calls]() -> bool {
    if (++calls > 5) throw std::runtime_error("killed");
    return false;
  };
  EXPECT_THROW(run_scene(scene, "whole", "", kill), std::runtime_error);
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("has checkpoints of an earlier run, up to step 20"), std::string::npos) << told_;
  }
  world()->barrier();
  EXPECT_FALSE(fs::exists(folder("whole") + "/checkpoint.h5"));
  EXPECT_NE(refusal(scene, "whole", checkpoint("whole", 20)).find("is not the table to go on with"), std::string::npos);
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
  const auto one = rows(folder("whole")), other = rows(folder("parts"));
  ASSERT_EQ(one.size(), other.size());
  const auto energy = [](const std::string& row) {
    std::string cell;
    std::istringstream text(row);
    for (int column = 0; column < 5; ++column) std::getline(text, cell, ',');
    return std::stod(cell);
  };
  EXPECT_NEAR(energy(other.back()), energy(one.back()), 1e-7 * energy(one.back()));
}

TEST_F(RestartTest, AMotionThatWouldJumpIsRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  run_scene(scene, "whole");
  std::string other = scene;
  other.replace(other.find("value=\"-0.5\""), 12, "value=\"-0.6\"");
  const std::string message = refusal(other, "whole", checkpoint("whole", 10));
  EXPECT_NE(message.find("a prescribed displacement would jump by 0.03"), std::string::npos) << message;
  EXPECT_NE(message.find("checkpoint-10.h5: "), std::string::npos) << message;
}

TEST_F(RestartTest, LeftoversOfAKilledWriteAreTidiedAway) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  on_first([&] {
    fs::create_directories(folder("whole"));
    std::ofstream(folder("whole") + "/checkpoint-7.h5.tmp") << "half";
  });
  run_scene(scene, "whole");
  world()->barrier();
  EXPECT_FALSE(fs::exists(folder("whole") + "/checkpoint-7.h5.tmp"));
}

TEST(SceneChangesTest, ChangesAreNamedAndJudged) {
  const auto scene = [](const std::string& text) { return test::scene(text); };
  const auto before = scene(list("A", number("x", 1) + word("w", "one")) + list("Output", count("Fields Interval", 3)) +
                            list("Interactions", list("Wall", word("Side Set", "s"))) +
                            list("Initial Conditions", numbers("Velocity", {1})));
  const auto now = scene(list("A", number("x", 1.5) + number("y", 2)) + list("Output", count("Fields Interval", 4)) +
                         list("Interactions", list("Wall", word("Side Set", "t"))) +
                         list("Initial Conditions", numbers("Velocity", {2})));
  const auto changes = scene_changes(before, now);
  ASSERT_EQ(changes.size(), 6U);
  EXPECT_EQ(changes[0].text(), "A/x: 1, now 1.5");
  EXPECT_EQ(changes[1].text(), "A/y: absent, now 2");
  EXPECT_EQ(changes[2].text(), "A/w: \"one\", now absent");
  EXPECT_EQ(changes[2].bearing, Bearing::Motion);
  EXPECT_EQ(changes[3].bearing, Bearing::None);
  EXPECT_EQ(changes[4].bearing, Bearing::Motion);
  EXPECT_EQ(changes[5].text(), "Initial Conditions/Velocity: {1}, now {2}");
  EXPECT_EQ(changes[5].bearing, Bearing::State);
  EXPECT_TRUE(scene_changes(before, before).empty());
}

}  // namespace
}  // namespace ixos

// The state of a program beside that of Ixos, in checkpoints that run() writes and in those that the program writes.
#include "run/loop_checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "histories/waveform.hpp"
#include "run/restart_fixture.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"

namespace ixos::test {
namespace {

/// The scene of drawn(), whose left side a stage of the program moves.
std::string staged() {
  std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(7, 100));
  const std::string history = word("History", "Down");
  scene.replace(scene.find(history), history.size(), word("History", "Stage"));
  scene.insert(scene.find(number("Mass Damping", 0.1)), number("Viscosity", 0.02));
  return scene;
}

/// A block of that length.
std::string block_of(double length, const std::string& scheme) {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {length, 1}) + counts("Divisions", {6, 3}))) +
         list("Materials", list("Rubber", number("Density", 1))) + time_integrator(scheme, 0.02, 1);
}

/// A stage that the body's reaction slows down. It falls with a constant acceleration in each step.
class Stage {
 public:
  const std::shared_ptr<Waveform> motion = std::make_shared<Waveform>();

  GivenHistories histories() const { return {{"Stage", motion}}; }
  void prepare(double time, double dt) {
    const TimeValue start = here_;
    here_ = {start.value + dt * (start.rate + dt / 2 * start.acceleration), start.rate + dt * start.acceleration,
             -0.5 - 3 * force_};
    motion->set(time, start, time + dt, here_);
  }
  void feel(double force) { force_ = force; }
  double place() const { return here_.value; }
  void transfer(Record& record) {
    record.number("value", here_.value);
    record.number("rate", here_.rate);
    record.number("acceleration", here_.acceleration);
    record.number("force", force_);
    const Record::Section section(record, "motion");
    motion->transfer(record);
  }
  std::vector<ProgramState> states() {
    return {{"stage", [this](Record& record) { transfer(record); }}};
  }

 private:
  TimeValue here_;
  double force_ = 0;
};

/// A program that calls Integrator::step() itself.
class Program {
 public:
  Program() : simulation_(test::scene(staged()), world(), ".", stage_.histories()) {}

  bool advance(int count) {
    for (int step = 0; step < count; ++step) {
      stage_.prepare(integrator().time(), 0.02);
      if (!integrator().step(0.02).converged) return false;
      double force = 0;
      for (const double value : integrator().state().reaction) force += value;
      simulation_.model().space().sum(&force, 1);
      stage_.feel(force);
    }
    return true;
  }
  Simulation& simulation() { return simulation_; }
  Integrator& integrator() { return simulation_.integrator(); }
  Stage& stage() { return stage_; }
  bool operator==(const Program& other) const {
    const State &one = simulation_.integrator().state(), &two = other.simulation_.integrator().state();
    return one.u == two.u && one.v == two.v && one.a == two.a && stage_.place() == other.stage_.place();
  }

 private:
  Stage stage_;
  Simulation simulation_;
};

class LoopCheckpointTest : public RestartTest {
 protected:
  void SetUp() override {
    RestartTest::SetUp();
    on_first([&] { fs::create_directories(folder_); });
  }
  std::string path_ = folder("state.h5");
};

TEST_F(LoopCheckpointTest, ALoopGoesOnToTheLastBit) {
  Program whole, first, second, third;
  ASSERT_TRUE(whole.advance(20));
  ASSERT_TRUE(first.advance(8));
  write_checkpoint(path_, first.simulation(), first.stage().states());
  EXPECT_TRUE(read_checkpoint(path_, second.simulation(), second.stage().states()).empty());
  ASSERT_TRUE(second.advance(12));
  EXPECT_TRUE(second == whole);
  EXPECT_FALSE(second == first);
  // And without the scene.
  write_checkpoint(path_, first.integrator(), first.stage().states());
  EXPECT_TRUE(read_checkpoint(path_, third.integrator(), third.stage().states()).empty());
  ASSERT_TRUE(third.advance(12));
  EXPECT_TRUE(third == whole);
}

TEST_F(LoopCheckpointTest, WhatDoesNotFitIsRefusedWithTheFilesName) {
  Program program;
  write_checkpoint(path_, program.simulation(), program.stage().states());
  const auto refused = [&](const auto& read, const std::string& text) {
    const std::string message = test::refusal(read);
    expect_contains(message, path_);
    expect_contains(message, text);
  };
  refused([&] { read_checkpoint(path_, program.simulation()); }, "holds \"stage\"");
  refused([&] { read_checkpoint(path_, program.integrator(), program.stage().states()); },
          "was written for a scene: read it with its Simulation");
  refused([&] { run_scene(drawn(word("Type", "Newmark") + steps(0.02, 1)), "run", path_); },
          "a program wrote this file with write_checkpoint()");
  write_checkpoint(path_, program.integrator());
  refused([&] { read_checkpoint(path_, program.integrator(), program.stage().states()); }, "lacks \"stage\"");
  Simulation longer(test::scene(block_of(3, "Newmark")), world()), other(test::scene(block_of(2, "Midpoint")), world()),
      newmark(test::scene(block_of(2, "Newmark")), world());
  write_checkpoint(path_, newmark.integrator());
  refused([&] { read_checkpoint(path_, longer.integrator()); }, "another mesh");
  refused([&] { read_checkpoint(path_, other.integrator()); }, "\"Newmark\", not to \"Midpoint\"");
  refused([&] { read_checkpoint(path_ + "x", other.integrator()); }, "");
}

TEST_F(LoopCheckpointTest, AnotherNumberOfRanksGoesOn) {
  const Teuchos::ParameterList scene = test::scene(
      block_of(2, "Newmark") +
      list("Initial Conditions", numbers("Velocity", {0.1, 0}) + numbers("Velocity Gradient", {0, -0.5, 0.5, 0})));
  Simulation one(scene, self()), all(scene, world());  // each rank has the whole body, and its share of it
  const auto advance = [](Simulation& simulation) {
    bool converged = true;
    for (int step = 0; step < 5 && converged; ++step) converged = simulation.integrator().step(0.02).converged;
    return converged;
  };
  const auto displacement = [](const Simulation& simulation) {
    return gathered(simulation.model(), simulation.integrator().state().u);
  };
  ASSERT_TRUE(advance(one));
  on_first([&] { write_checkpoint(path_, one.integrator()); });
  const std::vector<std::string> notes = read_checkpoint(path_, all.integrator());
  EXPECT_EQ(notes.empty(), world()->getSize() == 1);
  if (!notes.empty()) expect_contains(notes.front(), "It was written on 1 rank(s)");
  EXPECT_EQ(displacement(all), displacement(one));
  EXPECT_EQ(all.integrator().time(), one.integrator().time());
  ASSERT_TRUE(advance(one));
  ASSERT_TRUE(advance(all));
  EXPECT_LT(distance(displacement(all), displacement(one)), 1e-9);
}

TEST_F(LoopCheckpointTest, RunsKeepTheProgramsStateToo) {
  const auto run_program = [&](const std::string& name, const std::string& restart, long end, double& place) {
    Stage stage;
    Simulation simulation(test::scene(staged()), world(), ".", stage.histories());
    stage.prepare(0, 0.02);
    RunOptions options;
    options.folder = folder(name);
    options.restart = restart;
    options.states = stage.states();
    options.observe = [&](const Progress& progress) {
      double force = 0;
      for (const double value : simulation.integrator().state().reaction) force += value;
      simulation.model().space().sum(&force, 1);
      stage.feel(force);
      if (progress.time < 0.99) stage.prepare(progress.time, 0.02);
      return std::string(progress.step == end ? "enough" : "");
    };
    const RunResult result = run(simulation, options);
    place = stage.place();
    return result;
  };
  double whole = 0, part = 0;
  EXPECT_EQ(run_program("whole", "", 0, whole).status, RunStatus::Completed);
  EXPECT_EQ(run_program("parts", "", 17, part).reason, "enough");
  EXPECT_NE(part, whole);
  EXPECT_EQ(run_program("parts", folder("parts"), 0, part).status, RunStatus::Completed);
  EXPECT_EQ(part, whole);
  expect_same("whole", "parts");
  EXPECT_EQ(run_program("parts", checkpoint("parts", 14), 0, part).status, RunStatus::Completed);
  EXPECT_EQ(part, whole);
  const std::string message = test::refusal([&] {
    Stage stage;
    Simulation simulation(test::scene(staged()), world(), ".", stage.histories());
    RunOptions options;
    options.folder = folder("parts");
    options.restart = checkpoint("parts", 14);
    run(simulation, options);
  });
  expect_contains(message, checkpoint("parts", 14) + ": holds \"stage\"");
}

}  // namespace
}  // namespace ixos::test

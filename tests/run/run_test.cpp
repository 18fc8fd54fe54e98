// What a run records, and when it ends.
#include "run/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "interaction/van_der_waals.hpp"
#include "model/set_reactions.hpp"
#include "study/common/history_table.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

class RunTest : public testing::Test {
 protected:
  /// Runs the scene; results in folder_.
  RunResult run_scene(const std::string& scene) {
    Simulation simulation(test::scene(scene), world());
    RunOptions options;
    options.folder = folder_;
    options.overwrite = true;  // one test runs several scenes into a folder
    return run(simulation, options);
  }
  HistoryTable table() const { return HistoryTable(folder_ + "/history.csv"); }
  std::string folder_ = testing::TempDir() + "run";
};

/// A block whose left side follows a table of places, its right side pulled by a known force.
std::string pulled(const std::string& output, const std::string& control) {
  return test::block_2d(0) +
         list("Histories",
              list("Path", word("Type", "Table") +
                               list("Table", numbers("Times", {1, 2, 3, 4}) + numbers("Values", {0, 0.1, 0.4, 0.9})))) +
         list("Boundary Conditions",
              list("Guide", word("Node Set", "left") + word("Components", "y")) +
                  list("Path", word("Node Set", "left") + word("Components", "x") + word("History", "Path")) +
                  list("Pull", word("Type", "Traction") + word("Side Set", "right") + numbers("Vector", {0.01, 0}))) +
         list("Output", output + "<Parameter name=\"Reactions\" type=\"Array(string)\" value=\"{left}\"/>" +
                            list("Probes", list("Edge", numbers("Point", {0, 1})))) +
         list("Time Integrator",
              word("Type", "Static") + list("Time Step Control", number("Initial Time", 1) + number("Final Time", 4) +
                                                                     number("Time Step", 0.1) + control));
}

TEST_F(RunTest, ColumnsHoldReactionsAndProbes) {
  const RunResult result = run_scene(pulled("", ""));
  EXPECT_EQ(result.status, RunStatus::Completed);
  const HistoryTable history = table();
  ASSERT_EQ(history.column("time").size(), 31U);
  for (std::size_t k = 0; k < 31; ++k) {
    // The table's values lie on a parabola, 0.1 (t - 1)^2, which quintic interpolation reproduces.
    const double t = history.column("time")[k];
    EXPECT_NEAR(history.column("Edge_ux")[k], 0.1 * (t - 1) * (t - 1), 1e-13);
    EXPECT_NEAR(history.column("Edge_vx")[k], 0.2 * (t - 1), 1e-12);
    EXPECT_NEAR(history.column("Edge_uy")[k], 0, 1e-15);
    if (k == 0) continue;  // not yet in equilibrium
    EXPECT_NEAR(history.column("reaction_left_x")[k], -0.02, 1e-11);
    EXPECT_NEAR(history.column("reaction_left_y")[k], 0, 1e-11);
  }
  ASSERT_EQ(result.max_forces.size(), 2U);
  EXPECT_EQ(result.max_forces[0].first, "reaction_left_x");
  EXPECT_NEAR(result.max_forces[0].second, -0.02, 1e-11);
}

TEST_F(RunTest, StaticMotionsFollowLinesAndSteps) {
  const std::vector<double> values{0, 0.1, 0.4, 0.9};
  for (const std::string interpolation : {"Linear", "Step"}) {
    std::string scene = pulled("", "");
    const std::string entry = numbers("Values", values);
    scene.insert(scene.find(entry), word("Interpolation", interpolation));
    ASSERT_EQ(run_scene(scene).status, RunStatus::Completed) << interpolation;
    const HistoryTable history = table();
    ASSERT_EQ(history.column("time").size(), 31U);
    for (std::size_t k = 0; k < 31; ++k) {
      const std::size_t i = std::min<std::size_t>(k / 10, 2);
      const double share = static_cast<double>(k - 10 * i) / 10;
      const double line = values[i] + share * (values[i + 1] - values[i]);
      EXPECT_NEAR(history.column("Edge_ux")[k], interpolation == "Step" ? values[k / 10] : line, 1e-13);
      if (k == 0) continue;  // not yet in equilibrium
      EXPECT_NEAR(history.column("reaction_left_x")[k], -0.02, 1e-11);
    }
  }
}

TEST_F(RunTest, IteratesOfEachStepAreTold) {
  Simulation simulation(test::scene(pulled("", "")), world());
  RunOptions options;
  options.folder = folder_;
  options.overwrite = true;
  long iterations = 0, steps = 0;
  Progress last;
  options.iterate = [&](const Progress& progress) {
    EXPECT_EQ(progress.step, steps);
    EXPECT_TRUE(progress.within_step);
    EXPECT_NEAR(progress.time_step, 0.1, 1e-9);
    if (progress.newton.iteration > 0) {
      EXPECT_EQ(progress.newton.iteration, last.newton.iteration + 1);
      ++iterations;
    }
    last = progress;
  };
  options.watch = [&](const Progress& progress) {
    EXPECT_LE(last.newton.residual, last.newton.bound);  // the step has converged
    EXPECT_FALSE(progress.within_step);
    EXPECT_EQ(progress.newton_iterations, iterations);
    if (progress.step < 30) {
      EXPECT_GT(progress.seconds_left, 0);
    } else {
      EXPECT_NEAR(progress.seconds_left, 0, 1e-9);
    }
    ++steps;
  };
  EXPECT_EQ(run(simulation, options).steps, 30);
  if (world()->getRank() == 0) {
    EXPECT_EQ(steps, 30);
    EXPECT_GT(iterations, 0);
  } else {
    EXPECT_EQ(steps, 0);
  }
}

TEST_F(RunTest, ObserversAreCalledOnEveryRankAfterEachAcceptedStep) {
  Simulation simulation(test::scene(pulled("", "")), world());
  RunOptions options;
  options.folder = folder_;
  options.overwrite = true;
  std::vector<double> times, forces;
  options.observe = [&](const Progress& progress) {
    times.push_back(progress.time);
    EXPECT_EQ(progress.step, static_cast<long>(times.size()));
    forces.push_back(
        set_reaction(simulation.model(), simulation.integrator().state().reaction, "left")[0]);  // collective
    return std::string();
  };
  run(simulation, options);
  ASSERT_EQ(times.size(), 30U);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(times[k], 1 + 0.1 * static_cast<double>(k + 1), 1e-12);
    EXPECT_NEAR(forces[k], -0.02, 1e-11);
  }
}

TEST_F(RunTest, AnObserverEndsTheRun) {
  Simulation simulation(test::scene(pulled("", "")), world());
  RunOptions options;
  options.folder = folder_;
  options.overwrite = true;
  const int last = world()->getSize() - 1;
  options.observe = [&](const Progress& progress) {  // one rank is enough
    return std::string(progress.step == 7 && world()->getRank() == last ? "the stage stands" : "");
  };
  const RunResult result = run(simulation, options);
  EXPECT_EQ(result.status, RunStatus::Stopped);
  EXPECT_EQ(result.reason, "the stage stands");
  EXPECT_EQ(result.steps, 7);
  EXPECT_EQ(table().column("step").back(), 7);
}

TEST_F(RunTest, AnObserverThatThrowsOnOneRankEndsTheRunOnAll) {
  const int last = world()->getSize() - 1;
  const auto message = [&](const auto& error) {
    Simulation simulation(test::scene(pulled("", "")), world());
    RunOptions options;
    options.folder = folder_;
    options.overwrite = true;
    options.observe = [&](const Progress& progress) {
      if (progress.step == 3 && world()->getRank() == last) throw error;
      return std::string();
    };
    try {
      run(simulation, options);
    } catch (const std::remove_reference_t<decltype(error)>& caught) {
      return std::string(caught.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_EQ(message(std::runtime_error("the stage is lost")), "the stage is lost");
  EXPECT_EQ(message(InputError("the stage has no place")), "the stage has no place");
}

TEST_F(RunTest, StepsEndAtTheTimesOfOutput) {
  run_scene(pulled(number("History Time Interval", 0.25), ""));
  const auto times = table().column("time");
  // Steps of 0.1 that are shortened to end at 1.25, 1.5, 1.75, ...
  ASSERT_EQ(times.size(), 13U);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], 1 + 0.25 * static_cast<double>(k), 1e-12);
}

TEST_F(RunTest, AStepLongerThanTheRunTakesOneStep) {
  const std::string scene = test::block_2d(0.1) + test::time_integrator("Midpoint", 1e7, 0.1);
  const RunResult result = run_scene(scene);
  EXPECT_EQ(result.steps, 1);
  EXPECT_EQ(result.end_time, 0.1);
}

TEST_F(RunTest, TimesThatCannotBeToldApartAreRefused) {
  const auto refusal = [&](const std::string& control, const std::string& output) {
    return test::refusal([&] {
      run_scene(test::block_2d(0.1) + list("Output", output) +
                list("Time Integrator", word("Type", "Midpoint") + list("Time Step Control", control)));
    });
  };
  const std::string late = number("Initial Time", 1e12) + number("Final Time", 1e12 + 0.003);
  test::expect_contains(refusal(late + number("Time Step", 0.001), ""),
                        "Time Integrator/Time Step Control/Time Step: 0.001 is lost in rounding");
  const std::string ordinary = number("Final Time", 0.1) + number("Time Step", 0.01);
  test::expect_contains(refusal(ordinary, number("History Time Interval", 1e-300)),
                        "Output/History Time Interval: 1e-300 is lost in rounding");
  test::expect_contains(refusal(ordinary, number("Fields Time Interval", 1e-18)),
                        "Output/Fields Time Interval: 1e-18 is lost in rounding");
}

/// A free, smooth motion, judged.
std::string judged(const std::string& scheme, double tolerance, const std::string& more = "") {
  return test::block_2d(1.0) + list("Output", number("History Time Interval", 0.7)) +
         list("Time Integrator",
              word("Type", scheme) +
                  list("Time Step Control", word("Type", "Adaptive") + number("Time Step", 0.001) +
                                                number("Final Time", 3) +
                                                list("Adaptive", number("Tolerance", tolerance) + more)));
}

TEST_F(RunTest, AdaptiveStepsFollowTheTolerance) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Average Vector Field"}) {
    const RunResult coarse = run_scene(judged(scheme, 1e-4));
    EXPECT_EQ(coarse.status, RunStatus::Completed) << coarse.reason;
    const auto times = table().column("time");
    const std::vector<double> expected{0, 0.7, 1.4, 2.1, 2.8, 3};
    ASSERT_EQ(times.size(), expected.size());
    for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], expected[k], 1e-12);
    // The local error is of third order: a thousandth of the tolerance needs ten times as many steps.
    const RunResult fine = run_scene(judged(scheme, 1e-7));
    EXPECT_NEAR(static_cast<double>(fine.steps) / static_cast<double>(coarse.steps), 10, 3.5) << scheme;
    EXPECT_LT(fine.rejected_steps, fine.steps / 5);
  }
}

TEST_F(RunTest, AnAdaptiveRunThatNeedsTooShortAStepEnds) {
  std::string scene = judged("Newmark", 1e-12);
  scene.replace(scene.find("\"Time Step\""), 0,
                "\"Minimum Time Step\" type=\"double\" value=\"0.0009\"/><Parameter name=");
  const RunResult result = run_scene(scene);
  EXPECT_EQ(result.status, RunStatus::Diverged);
  EXPECT_NE(result.reason.find("the shortest one allowed is 0.0009 T0"), std::string::npos) << result.reason;
}

/// A block that falls onto a sticky wall.
std::string falling(const std::string& scheme, const std::string& control, const std::string& wall = "",
                    const std::string& scheme_parameters = "") {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -1.2}) + wall)) +
         list("Initial Conditions", numbers("Velocity", {0, -1})) +
         list("Output", list("Probes", list("Top", numbers("Point", {1, 1})))) +
         list("Time Integrator", word("Type", scheme) +
                                     (scheme_parameters.empty() ? "" : list(scheme, scheme_parameters)) +
                                     list("Time Step Control", number("Final Time", 1.5) + control));
}

TEST_F(RunTest, TheGapRatioIsHeldAndSavesSteps) {
  const std::string fixed = number("Time Step", 0.002);
  const auto adaptive = [](double ratio, const std::string& more) {
    return word("Type", "Adaptive") + number("Time Step", 0.02) +
           list("Adaptive", number("Maximum Gap Ratio", ratio) + number("Maximum Time Step", 0.1) + more);
  };
  const RunResult coarse = run_scene(falling("Newmark", fixed));
  const RunResult judged = run_scene(falling("Newmark", adaptive(1.05, "")));
  ASSERT_EQ(judged.status, RunStatus::Completed) << judged.reason;
  // Row by row the least gap changes by no more than the ratio: it is that of one of the points, and they move alike.
  const auto gaps = table().column("min_gap");
  for (std::size_t k = 1; k < gaps.size(); ++k) {
    const double ratio = std::max(gaps[k] / gaps[k - 1], gaps[k - 1] / gaps[k]);
    EXPECT_TRUE(ratio < 1.06 || std::min(gaps[k], gaps[k - 1]) > 2.5) << k << ": " << ratio;
  }
  EXPECT_LT(judged.steps, coarse.steps);
  EXPECT_LT(judged.max_energy_error, run_scene(falling("Newmark", adaptive(1.2, ""))).max_energy_error);
}

TEST_F(RunTest, PointsInTimeFollowTheGapRatio) {
  const auto error = [&](int points, bool choose) {
    const RunResult result = run_scene(falling(
        "Average Vector Field",
        word("Type", "Adaptive") + number("Time Step", 0.02) +
            list("Adaptive", number("Maximum Gap Ratio", 4) + number("Maximum Time Step", 0.1) +
                                 (choose ? R"(<Parameter name="Choose Time Points" type="bool" value="true"/>)" : "")),
        "", test::count("Interaction Points", points)));
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    return result.max_energy_error;
  };
  const double few = error(2, false), chosen = error(2, true), many = error(16, false);
  EXPECT_LT(chosen, 1e-2 * few);
  EXPECT_LT(chosen, 1e-5 * 0.0155 * 2 + 10 * many) << "1e-5 of the work of adhesion";
}

TEST_F(RunTest, ACutoffKeepsTheEnergyAndStaysWithinItsBound) {
  const std::string control = number("Time Step", 0.01);
  const auto top = [&](const std::string& wall) {
    const RunResult result =
        run_scene(falling("Average Vector Field", control, wall, test::count("Interaction Points", 32)));
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    EXPECT_LT(result.max_energy_error, 1e-8);
    return table().column("Top_uy");
  };
  const auto whole = top(""), cut = top(number("Cutoff", 1.0)), beyond = top(number("Cutoff", 1e6));
  // Half a T0 before the wall is reached, traction is the only difference: at most T(rc) on an area of 2, mass 2.
  const VanDerWaals law(2.5, 25);
  const std::size_t k = 50;
  EXPECT_NE(cut[k], whole[k]);
  EXPECT_LE(std::abs(cut[k] - whole[k]), std::abs(law.traction(1.0)) * 0.5 * 0.5 / 2 * 1.1);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(beyond[i], whole[i], 1e-9);
}

TEST_F(RunTest, ExplicitStepsAreStableOnes) {
  const RunResult result =
      run_scene(test::block_2d(1.0) + test::time_integrator("Central Difference", 2.0, 20, number("Safety", 0.5)));
  EXPECT_EQ(result.status, RunStatus::Completed);
  EXPECT_GT(result.steps, 20);
  const HistoryTable history = table();
  for (double energy : history.column("total_energy"))
    EXPECT_NEAR(energy, history.column("total_energy")[0], 0.1 * history.column("total_energy")[0]);
}

/// A block that a wall has caught at its equilibrium gap, or one far from it, thrown upwards.
std::string thrown(double gap, const std::string& type) {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {2, 1}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -gap}))) +
         list("Initial Conditions", numbers("Velocity", {0, 0.5})) +
         list("Output", list("Probes", list("Top", numbers("Point", {1, 1})))) +
         list("Time Integrator",
              list("Time Step Control", number("Time Step", 0.02) + number("Final Time", 2)) +
                  list("Stop",
                       list("End",
                            word("Type", type) +
                                (type == "Probe" ? list("Probe", word("Name", "Top") + number("Limit", 1.3)) : ""))));
}

TEST_F(RunTest, DetachedEndsARunThatWasAttached) {
  const RunResult caught = run_scene(thrown(0.2547, "Detached"));
  EXPECT_EQ(caught.status, RunStatus::Stopped);
  EXPECT_EQ(caught.reason, "End: the surface is detached");
  const HistoryTable history = table();
  EXPECT_EQ(history.column("contact_measure").back(), 0);
  EXPECT_GT(history.column("contact_measure")[history.column("contact_measure").size() - 2], 0);
  const RunResult free = run_scene(thrown(1.0, "Detached"));
  EXPECT_EQ(free.status, RunStatus::Completed);
}

TEST_F(RunTest, AProbeEndsARun) {
  const RunResult result = run_scene(thrown(1.0, "Probe"));
  EXPECT_EQ(result.status, RunStatus::Stopped);
  // The top starts at 1 and rises at 0.5, the wall pulls a little.
  EXPECT_NEAR(result.end_time, 0.62, 0.03);
  EXPECT_EQ(result.reason.rfind("End: y of probe Top is 1.3", 0), 0U) << result.reason;
}

}  // namespace
}  // namespace ixos

// The watch on the energy balance: quiet while a scheme keeps its promise, and awake when memory is damaged.
#include <cmath>
#include <functional>
#include <vector>

#include "run/energy_watch.hpp"
#include "run/restart_fixture.hpp"
#include "support/bodies.hpp"
#include "time/table.hpp"

namespace ixos::test {
namespace {

/// A block that flies into a sticky wall without any dissipation.
std::string flying(const std::string& scheme, const std::string& watch, double damping = 0) {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 3}))) +
         list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", damping))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.9}))) +
         list("Initial Conditions", numbers("Velocity", {0.1, -0.05})) +
         list("Output", checkpoints(4, 3) + list("Watch", watch)) +
         list("Time Integrator", word("Type", scheme) + steps(0.05, 1));
}

class EnergyWatchTest : public RestartTest {
 protected:
  /// Runs to the end, observed. Before step `at` the velocities are damaged, once: by default an exponent loses a bit.
  RunResult disturbed(const std::string& scene, const std::string& name, int at) {
    Simulation simulation(test::scene(scene), world());
    RunOptions options;
    options.folder = folder(name);
    options.overwrite = true;  // one test runs several scenes into a folder
    options.log = [this](const std::string& line) { told_ += line + "\n"; };
    options.warn = [this](const std::string& line) { ++warnings_, told_ += line + "\n"; };
    observed_.clear();
    calls_ = 0;
    options.observe = [&](const Progress& progress) {
      ++calls_;
      observed_.push_back(progress.time);
      return std::string();
    };
    options.states = {{"observer", [this](Record& record) { record.share("times", observed_); }}};
    int steps = 0;
    options.interrupted = [&] {
      auto& v = const_cast<std::vector<double>&>(simulation.integrator().state().v);
      if (++steps == at) damage_(v);
      return false;
    };
    return run(simulation, options);
  }

  int warnings_ = 0;              ///< on the first rank
  int calls_ = 0;                 ///< of the observer
  std::vector<double> observed_;  ///< the times that it saw, a state of the program
  std::function<void(std::vector<double>&)> damage_ = [](std::vector<double>& v) {
    if (world()->getRank() == 0) v.at(1) /= 2;
  };
};

TEST_F(EnergyWatchTest, AnUndamagedRunIsQuiet) {
  for (const char* scheme : {"Energy-Momentum", "Average Vector Field"}) {
    const RunResult result = disturbed(flying(scheme, ""), "whole", -1);
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    EXPECT_EQ(warnings_, 0) << told_;
  }
}

// Where steps are long against the period of a cell, or displacements large against their change, the residual does
// more work than the energies suggest.
TEST_F(EnergyWatchTest, StiffBodiesAndLongWaysAreQuiet) {
  const auto stiff = [](std::string scene, double modulus, double speed) {
    const std::string density = number("Density", 1), velocity = numbers("Velocity", {0.1, -0.05});
    scene.insert(scene.find(density), number("Young's Modulus", modulus));
    return scene.replace(scene.find(velocity), velocity.size(), numbers("Velocity", {speed, -0.05}));
  };
  for (const char* scheme : {"Energy-Momentum", "Average Vector Field"})
    for (const double modulus : {1.0, 1e3, 1e6})
      for (const double speed : {0.1, 1e3}) {
        disturbed(stiff(flying(scheme, ""), modulus, speed), "whole", -1);
        EXPECT_EQ(warnings_, 0) << scheme << ", " << modulus << ", " << speed << ": " << told_;
      }
}

// -ln l of an edge whose length l changes from 1 - s/2 to 1 + s/2: its gain is known, its mean force has a pole.
TEST(ElasticQuadratureTest, TheBoundHoldsForALogarithm) {
  for (const int n : {1, 2, 3, 4, 5, 8})
    for (const double s : {0.01, 0.1, 0.3, 1.0, 1.5}) {
      double gain = std::log((1 + s / 2) / (1 - s / 2));
      for (const TimePoint& point : gauss_times(n)) gain -= point.weight * s / (1 + s * (point.time - 0.5));
      EXPECT_LE(std::abs(gain), elastic_quadrature_error(n, s) + 1e-15) << n << ", " << s;
      EXPECT_LE(elastic_quadrature_error(n, s / 2), elastic_quadrature_error(n, s) / 2);
    }
  EXPECT_EQ(elastic_quadrature_error(0, 1), 0);
  EXPECT_EQ(elastic_quadrature_error(4, 0), 0);
}

// Points in time bound neither the work of a moved wall nor the kinks of a law that allows overlaps; the exact mean and
// a given tolerance do.
TEST_F(EnergyWatchTest, MovedWallsAndLawsOfEveryGapAreWatchedWithTheExactMeanOnly) {
  const auto is_on = [](const std::string& more, int points, const std::string& watch = "") {
    std::string scene = flying("Average Vector Field", watch);
    const std::string place = numbers("Point", {0, -0.9});
    scene.insert(scene.find(place), more);
    const std::string type = word("Type", "Average Vector Field");
    scene.insert(scene.find(type), list("Average Vector Field", count("Interaction Points", points)));
    scene += list("Histories", expression("Shake", "0.01*sin(t)", "0.01*cos(t)", "-0.01*sin(t)"));
    return EnergyWatch(Simulation(test::scene(scene), world())).on();
  };
  const std::string moved = list("Motion", "<Parameter name='Translation' type='Array(string)' value='{-, Shake}'/>");
  EXPECT_TRUE(is_on("", 8));
  EXPECT_FALSE(is_on(moved, 8));
  EXPECT_TRUE(is_on(moved, 0));
  EXPECT_TRUE(is_on(moved, 8, number("Tolerance", 1e-3)));
  EXPECT_FALSE(is_on(word("Law", "Penalty"), 8));
  EXPECT_FALSE(is_on(word("Law", "Log Barrier"), 8)) << "its traction ends";
  EXPECT_FALSE(is_on(number("Cutoff", 2), 8));
  EXPECT_TRUE(is_on(word("Law", "Penalty"), 0));
}

TEST_F(EnergyWatchTest, DamageIsWarnedOfOnceByDefault) {
  for (const char* scheme : {"Energy-Momentum", "Average Vector Field"}) {
    warnings_ = 0;
    told_.clear();
    const RunResult result = disturbed(flying(scheme, ""), "whole", 11);
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    if (world()->getRank() != 0) continue;
    EXPECT_EQ(warnings_, 1);
    EXPECT_NE(told_.find("step 11: the energy balance moved by "), std::string::npos) << told_;
    EXPECT_NE(told_.find(std::string(scheme) + " as it is set"), std::string::npos) << told_;
  }
}

TEST_F(EnergyWatchTest, DamageEndsTheRunWhereThatIsAskedFor) {
  const RunResult result = disturbed(flying("Energy-Momentum", word("Action", "Stop")), "whole", 11);
  EXPECT_EQ(result.status, RunStatus::Diverged);
  EXPECT_EQ(result.steps, 11);
  EXPECT_NE(result.reason.find("memory was damaged"), std::string::npos) << result.reason;
}

TEST_F(EnergyWatchTest, TheRunGoesBackToItsCheckpointAndForgetsTheDamage) {
  const std::string scene = flying("Energy-Momentum", word("Action", "Resume"));
  const RunResult whole = disturbed(scene, "whole", -1);
  const RunResult result = disturbed(scene, "parts", 11);
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.restarts, 1);
  EXPECT_EQ(result.steps, whole.steps);
  EXPECT_EQ(result.max_energy_error, whole.max_energy_error);
  expect_same("whole", "parts");
}

TEST_F(EnergyWatchTest, StepsAfterTheCheckpointAreObservedAgain) {
  const std::string scene = flying("Energy-Momentum", word("Action", "Resume"));
  disturbed(scene, "whole", -1);
  const std::vector<double> whole = observed_;
  ASSERT_EQ(whole.size(), 20U);
  EXPECT_EQ(calls_, 20);
  disturbed(scene, "parts", 11);
  EXPECT_EQ(observed_, whole);
  EXPECT_EQ(calls_, 22);  // not the damaged step 11, but the steps 9 and 10 twice
}

TEST_F(EnergyWatchTest, AStopCriterionThatHeldInTheDamagedStateIsForgotten) {
  std::string scene = flying("Energy-Momentum", word("Action", "Resume"));
  const auto into = [&](const std::string& name, const std::string& entries) {
    const std::string start = "<ParameterList name=\"" + name + "\">";
    scene.insert(scene.find(start) + start.size(), entries);
  };
  into("Output", list("Probes", list("Edge", numbers("Point", {0, 0}))));
  into("Time Integrator",
       list("Stop", list("Fast", word("Type", "Probe") + list("Probe", word("Name", "Edge") + word("Quantity", "vx") +
                                                                           number("Limit", 0.2)))));
  damage_ = [](std::vector<double>& v) {
    for (double& value : v) value *= 4;  // the block flies at 0.1 L0/T0 to the right
  };
  const RunResult result = disturbed(scene, "whole", 11);
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.reason, "");
  EXPECT_EQ(result.restarts, 1);
  EXPECT_EQ(result.steps, 20);
}

TEST_F(EnergyWatchTest, OtherSchemesAndDampedBodiesAreWatchedOnlyWithATolerance) {
  for (const std::string& scene : {flying("Newmark", ""), flying("Energy-Momentum", "", 0.1),
                                   flying("Energy-Momentum", word("Action", "Off") + number("Tolerance", 1e-6))}) {
    disturbed(scene, "whole", 11);
    EXPECT_EQ(warnings_, 0) << told_;
  }
  disturbed(flying("Newmark", number("Tolerance", 1e-3)), "whole", 11);
  EXPECT_EQ(warnings_, world()->getRank() == 0 ? 1 : 0) << told_;
}

}  // namespace
}  // namespace ixos::test

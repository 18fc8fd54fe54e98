// Steps that are taken back and repeated, as a program that iterates with Ixos does: to the last bit.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "run/restart_fixture.hpp"
#include "support/bodies.hpp"
#include "time/step_judge.hpp"

namespace ixos::test {
namespace {

/// Everything that a caller sees of a step.
struct Seen {
  double time, dissipated, work;
  std::vector<double> u, v, a, load, reaction, dissipations;

  explicit Seen(Integrator& integrator)
      : time(integrator.time()),
        dissipated(integrator.dissipated_energy()),
        work(integrator.external_work()),
        u(integrator.state().u),
        v(integrator.state().v),
        a(integrator.model().mass() == nullptr ? std::vector<double>() : integrator.acceleration()),
        load(integrator.state().load),
        reaction(integrator.state().reaction),
        dissipations(integrator.dissipations()) {}
  bool operator==(const Seen& other) const {
    return time == other.time && dissipated == other.dissipated && work == other.work && u == other.u && v == other.v &&
           a == other.a && load == other.load && reaction == other.reaction && dissipations == other.dissipations;
  }
};

/// Takes steps until one fails.
bool advance(Integrator& integrator, int steps, double dt) {
  bool converged = true;
  for (int step = 0; step < steps && converged; ++step) converged = integrator.step(dt).converged;
  return converged;
}

/// Compares a body whose steps are repeated with one whose steps are not. Four times, at other steps: it takes a step,
/// goes back, takes others, goes back, and repeats the first.
void expect_repeatable(const std::string& scene) {
  Simulation calm(test::scene(scene), world()), driven(test::scene(scene), world());
  Integrator& integrator = driven.integrator();
  Snapshot snapshot([&](Record& record) { integrator.transfer(record); });
  for (int turn = 0; turn < 4; ++turn) {
    snapshot.save();
    ASSERT_TRUE(advance(integrator, 1, 0.02));
    const Seen first(integrator);
    ASSERT_TRUE(advance(integrator, 5, 0.02));
    snapshot.restore();
    ASSERT_TRUE(advance(integrator, 3, 0.007));
    EXPECT_FALSE(Seen(integrator) == first);
    snapshot.restore();
    integrator.attempt(0.01);  // which nobody accepts
    snapshot.restore();
    ASSERT_TRUE(advance(integrator, 1, 0.02));
    EXPECT_TRUE(Seen(integrator) == first) << "turn " << turn;
    ASSERT_TRUE(advance(integrator, 3, 0.02));
    ASSERT_TRUE(advance(calm.integrator(), 4, 0.02));
    EXPECT_TRUE(Seen(integrator) == Seen(calm.integrator())) << "turn " << turn;
  }
}

std::string viscous(std::string scene) {
  scene.insert(scene.find(number("Mass Damping", 0.1)), number("Viscosity", 0.02));
  return scene;
}

TEST(RepeatedStepsTest, EverySchemeRepeatsAStepToTheLastBit) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    expect_repeatable(viscous(drawn(word("Type", scheme) + steps(0.02, 1))));
  }
}

TEST(RepeatedStepsTest, StaticsRepeat) {
  std::string scene = drawn(word("Type", "Static") + steps(0.02, 1));
  const std::string loose = word("Components", "y");
  scene.replace(scene.find(loose), loose.size(), word("Components", "xy"));
  expect_repeatable(scene);
}

TEST(RepeatedStepsTest, ThePredictorsPastComesBack) {
  for (const char* predictor : {"Extrapolation", "Quadratic", "Nearest"}) {
    SCOPED_TRACE(predictor);
    expect_repeatable(drawn(word("Type", "Newmark") + word("Predictor", predictor) + steps(0.02, 1)));
  }
}

/// A scene whose preconditioner outlives matrices.
std::string lagged(const std::string& preconditioner, const std::string& scheme, double setup_cost,
                   const std::string& op = "Assembled", int keep = 2) {
  return drawn(word("Type", scheme) + steps(0.02, 1), list("Checkpoint", count("Keep", keep)),
               list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", preconditioner) +
                                         word("Operator", op) + list("Reuse", number("Setup Cost", setup_cost)) +
                                         list("Preconditioner Types", list("MueLu", count("coarse: max size", 10) +
                                                                                        word("verbosity", "none")))));
}

TEST(RepeatedStepsTest, LaggedPreconditionersComeBack) {
  for (const char* op : {"Assembled", "Matrix-Free"})
    for (const char* preconditioner : {"MueLu", "Ifpack2", "Direct", "Chebyshev"}) {
      SCOPED_TRACE(std::string(op) + ", " + preconditioner);
      expect_repeatable(lagged(preconditioner, "Newmark", 3, op));
    }
  SCOPED_TRACE("Two-Level");
  std::string quadratic = lagged("Two-Level", "Newmark", 3, "Matrix-Free");
  const std::string odd = counts("Divisions", {6, 3});
  std::string linear = quadratic;
  expect_repeatable(linear.replace(linear.find(odd), odd.size(), counts("Divisions", {6, 4})));
  expect_repeatable(quadratic.insert(quadratic.find(word("Type", "Box")), count("Cell Order", 2)));
  SCOPED_TRACE("never renewed");
  expect_repeatable(lagged("MueLu", "Newmark", 1e6));
  SCOPED_TRACE("two stages");
  expect_repeatable(lagged("MueLu", "Bathe Composite", 3));
  SCOPED_TRACE("Band LU");
  std::string unsymmetric = lagged("Direct", "Energy-Momentum", 3);
  expect_repeatable(unsymmetric);
  SCOPED_TRACE("KLU, whose order of pivots is older than its matrix");
  const std::string types = "<ParameterList name=\"Preconditioner Types\">";
  expect_repeatable(
      unsymmetric.insert(unsymmetric.find(types) + types.size(), list("Direct", word("Solver Type", "KLU"))));
}

TEST(RepeatedStepsTest, APreconditionerThatForgetsItsMatricesIsRefused) {
  Simulation s(test::scene(lagged("Ifpack2", "Newmark", 3, "Assembled", 0)), world());
  Snapshot snapshot([&](Record& record) { s.integrator().transfer(record); });
  try {
    snapshot.save();
    ADD_FAILURE() << "it was not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Output/Checkpoint/Keep is 0"), std::string::npos) << error.what();
  }
}

TEST(RepeatedStepsTest, AnOlderSnapshotOutlivesALaterOne) {
  const std::string scene = lagged("MueLu", "Newmark", 3);
  Simulation calm(test::scene(scene), world()), driven(test::scene(scene), world());
  Integrator& integrator = driven.integrator();
  const auto state = [&](Record& record) { integrator.transfer(record); };
  Snapshot old(state), later(state);
  old.save();
  ASSERT_TRUE(advance(integrator, 10, 0.02));
  later.save();
  old.restore();
  later.restore();  // before anything was rebuilt
  ASSERT_TRUE(advance(integrator, 2, 0.02));
  ASSERT_TRUE(advance(calm.integrator(), 12, 0.02));
  EXPECT_TRUE(Seen(integrator) == Seen(calm.integrator()));
  old.restore();
  ASSERT_TRUE(advance(integrator, 12, 0.02));
  EXPECT_TRUE(Seen(integrator) == Seen(calm.integrator()));
}

TEST(RepeatedStepsTest, AdaptiveStepsComeBackWithTheirControl) {
  const std::string adaptive =
      list("Adaptive", number("Tolerance", 1e-4) + number("Maximum Gap Ratio", 1.3) +
                           "<Parameter name=\"Choose Time Points\" type=\"bool\" value=\"true\"/>");
  Simulation s(test::scene(drawn(word("Type", "Average Vector Field") + word("Predictor", "Extrapolation") +
                                 steps(0.001, 3, word("Type", "Adaptive") + adaptive))),
               world());
  Integrator& integrator = s.integrator();
  StepControl control(s.step_control());
  Snapshot snapshot([&](Record& record) {
    integrator.transfer(record);
    control.transfer(record);
  });
  const auto advance_by = [&](int attempts) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const double dt = control.next(integrator.time());
      const bool good = integrator.attempt(dt).converged;
      if (!good && !control.cut(dt)) return false;
      if (good && judge_step(integrator, s.step_control().adaptive, dt, control)) integrator.accept();
    }
    return true;
  };
  ASSERT_TRUE(advance_by(12));
  snapshot.save();
  ASSERT_TRUE(advance_by(12));
  const Seen first(integrator);
  const double next = control.next(integrator.time());
  const int points = integrator.table().interaction_points;
  ASSERT_TRUE(advance_by(5));
  snapshot.restore();
  ASSERT_TRUE(advance_by(12));
  EXPECT_TRUE(Seen(integrator) == first);
  EXPECT_EQ(control.next(integrator.time()), next);
  EXPECT_EQ(integrator.table().interaction_points, points);
}

TEST(RepeatedStepsTest, AnotherDiscretizationIsRefused) {
  Simulation s(test::scene(drawn(word("Type", "Newmark") + steps(0.02, 1))), world());
  Snapshot snapshot([&](Record& record) { s.integrator().transfer(record); });
  snapshot.save();
  s.model().couple({});
  EXPECT_THROW(snapshot.restore(), std::logic_error);
}

}  // namespace
}  // namespace ixos::test

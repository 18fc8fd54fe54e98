// Histories of Maxwell branches that go on from a checkpoint.
#include <gtest/gtest.h>

#include "run/restart_fixture.hpp"
#include "study/common/history_table.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"

namespace ixos::test {
namespace {

const std::string two_branches =
    list("Maxwell Branches", numbers("Relaxation Times", {0.05, 2}) + numbers("Moduli", {0.4, 0.2}));
const std::string viscoelasticity = "dissipated_viscoelasticity_of_body";

/// The drawn block with two branches.
std::string relaxing(const std::string& integrator, const std::string& output, const std::string& more = "") {
  std::string scene = drawn(integrator, output, more);
  return scene.insert(scene.find(number("Mass Damping", 0.1)), two_branches);
}

TEST_F(RestartTest, RelaxationGoesOn) {
  for (const std::string& scheme :
       {word("Type", "Newmark"), word("Type", "Bathe Composite"), word("Type", "Midpoint"),
        word("Type", "Generalized-Alpha") + list("Generalized-Alpha", number("Spectral Radius", 1)),
        word("Type", "Average Vector Field")}) {
    SCOPED_TRACE(scheme);
    const RunResult whole = expect_goes_on(relaxing(scheme + steps(0.05, 2), checkpoints(15, 100)), {15, 30});
    EXPECT_EQ(whole.status, RunStatus::Completed);
    const std::string history = contents(fs::path(folder("whole")) / "history.csv");
    expect_contains(history.substr(0, history.find('\n')), ",dissipated_damping,dissipated_viscoelasticity_of_body");
  }
}

/// Checks that the columns of the sources sum to "dissipated_energy" in each row.
void expect_all_sources(const std::string& folder) {
  const HistoryTable history(folder + "/history.csv");
  const auto damping = history.column("dissipated_damping"), branches = history.column(viscoelasticity),
             whole = history.column("dissipated_energy");
  for (std::size_t k = 0; k < whole.size(); ++k) EXPECT_NEAR(damping[k] + branches[k], whole[k], 1e-15) << k;
  EXPECT_GT(branches.back(), 1e-5);
}

std::string changed(std::string scene, const std::string& from, const std::string& to) {
  EXPECT_NE(scene.find(from), std::string::npos) << from;
  return scene.replace(scene.find(from), from.size(), to);
}

const std::string average = word("Type", "Average Vector Field");

/// A solid whose base is held and whose top is drawn to and fro.
std::string solid(const std::string& output) {
  return list("Mesh", word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lengths", {2, 1, 1}) +
                                                            counts("Divisions", {3, 2, 2}))) +
         list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", 0.1) + two_branches)) +
         list("Histories",
              list("Draw", word("Type", "Sine") + list("Sine", number("Offset", 0) + number("Amplitude", 0.3) +
                                                                   number("Frequency", 0.5)))) +
         list("Boundary Conditions",
              list("Base", word("Node Set", "bottom")) +
                  list("Draw", word("Node Set", "top") + word("Components", "x") + word("History", "Draw"))) +
         list("Output", output) + list("Time Integrator", average + steps(0.05, 1));
}

TEST_F(RestartTest, RelaxationGoesOnInEveryElement) {
  const std::string output =
      checkpoints(8, 100) + count("Fields Interval", 4) +
      "<Parameter name=\"Fields\" type=\"Array(string)\" value=\"{default, stress, dissipated_energy_density}\"/>";
  const std::string plane = relaxing(average + steps(0.05, 1), output), density = number("Density", 1);
  // A ring around the wall's normal.
  std::string ring = changed(plane, word("Type", "Box"), word("Type", "Box") + word("Geometry", "Axisymmetric"));
  ring = changed(ring, numbers("Lengths", {2, 1}), numbers("Lower", {1, 0}) + numbers("Lengths", {2, 1}));
  ring = changed(ring, numbers("Velocity", {0.1, 0}), numbers("Velocity", {0, -0.1}));
  for (const std::string& scene :
       {solid(output), changed(plane, density, density + word("Element Formulation", "Mean Dilatation")),
        changed(plane, "Maxwell Branches\">", "Maxwell Branches\">" + word("History Update", "Second Order")), ring}) {
    SCOPED_TRACE(scene);
    EXPECT_EQ(expect_goes_on(scene, {8, 16}).status, RunStatus::Completed);
    expect_all_sources(folder("whole"));
  }
}

// The first rank resumes alone. Forces differ by rounding.
TEST_F(RestartTest, RelaxationGoesOnOnAnotherNumberOfRanks) {
  const std::string scene = solid(checkpoints(10, 100));
  ASSERT_EQ(run_scene(scene, "whole").status, RunStatus::Completed);
  on_first([&] {
    Simulation simulation(test::scene(scene), self());
    RunOptions options;
    options.folder = folder("alone");
    options.restart = checkpoint("whole", 10);
    ASSERT_EQ(run(simulation, options).status, RunStatus::Completed);
    expect_all_sources(folder("alone"));
    const HistoryTable whole(folder("whole") + "/history.csv"), alone(folder("alone") + "/history.csv");
    for (const std::string& name : {std::string("elastic_energy"), viscoelasticity})
      EXPECT_NEAR(alone.column(name).back(), whole.column(name).back(), 1e-9) << name;
  });
}

TEST_F(RestartTest, RelaxationGoesOnWithoutAMatrix) {
  const std::string matrix_free =
      list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev") +
                                word("Operator", "Matrix-Free"));
  const RunResult whole = expect_goes_on(
      relaxing(word("Type", "Average Vector Field") + steps(0.05, 1), checkpoints(8, 100), matrix_free), {8, 16});
  EXPECT_EQ(whole.status, RunStatus::Completed);
}

}  // namespace
}  // namespace ixos::test

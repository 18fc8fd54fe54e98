// Bodies with hanging nodes, tied surfaces, periodic sides and planes of symmetry move alike with every linear solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

/// A choice of the list "Linear Solver".
struct Choice {
  std::string solver, type, preconditioner, op = "Assembled";
};

/// Returns this rank's displacements after five steps of a scene of the user guide.
std::vector<double> moved(const std::string& scene, const Choice& choice) {
  Teuchos::ParameterList list = read_scene_file(std::string(IXOS_TEST_DIRECTORY) + "/guide/" + scene + ".xml");
  Teuchos::ParameterList& linear = list.sublist("Linear Solver");
  linear.set("Linear Solver Type", choice.solver).set("Preconditioner Type", choice.preconditioner);
  linear.set("Operator", choice.op);
  if (choice.solver == "Direct")
    linear.sublist("Linear Solver Types").sublist("Direct").set("Solver Type", choice.type);
  list.sublist("Nonlinear Solver").set("Tolerance", 1e-10);
  Simulation simulation(list, test::world());
  Integrator& integrator = simulation.integrator();
  for (int step = 0; step < 5; ++step) {
    const StepResult result = integrator.attempt(simulation.step_control().time_step);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) return {};
    integrator.accept();
  }
  return integrator.state().u;
}

TEST(TiedSolversTest, EveryLinearSolverMovesTheBodyAlike) {
  if (test::world()->getSize() > 2) GTEST_SKIP() << "slow where ranks share processors; two ranks have a border";
  const std::vector<Choice> choices = {{"Direct", "Band LU", "None"},
                                       {"Direct", "CHOLMOD", "None"},
                                       {"Direct", "KLU", "None"},
                                       {"Direct", "MUMPS", "None"},
                                       {"Belos", "", "MueLu"},
                                       {"Belos", "", "Ifpack2"},
                                       {"Belos", "", "Direct"},
                                       {"Belos", "", "MueLu", "Matrix-Free"},
                                       {"Belos", "", "Chebyshev", "Matrix-Free"}};
  for (const std::string scene : {"refined-foot", "tied-pillar", "periodic-strip", "turned-half"}) {
    const std::vector<double> expected = moved(scene, {"Direct", "Band", "None"});
    double largest = 0;
    for (const double u : expected) largest = std::max(largest, std::abs(u));
    ASSERT_GT(largest, 1e-6) << scene;
    for (const Choice& choice : choices) {
      SCOPED_TRACE(scene + ": " + choice.solver + " " + choice.type + " " + choice.preconditioner + " " + choice.op);
      const std::vector<double> found = moved(scene, choice);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-7 * largest) << i;
    }
  }
}

}  // namespace
}  // namespace ixos

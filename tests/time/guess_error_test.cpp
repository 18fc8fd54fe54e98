// The distance of a guess from the solution.
#include "time/guess_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// Returns the error, over all ranks, of a guess that is off by c + A x; A row by row.
double error(const Simulation& s, const std::array<double, 2>& c, const std::array<double, 4>& a) {
  const LocalMesh& mesh = s.model().mesh();
  std::vector<double> u(static_cast<std::size_t>(s.model().space().local())), guess(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = std::sin(static_cast<double>(i));
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double x = mesh.coordinates[i / 2 * 2], y = mesh.coordinates[i / 2 * 2 + 1];
    guess[i] = u[i] + c[i % 2] + a[i % 2 * 2] * x + a[i % 2 * 2 + 1] * y;
  }
  return s.model().space().maximum(guess_error(s.model(), guess, u));
}

TEST(GuessErrorTest, IsTheStrainOrTheRotationOfTheError) {
  const Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  EXPECT_EQ(error(s, {0, 0}, {0, 0, 0, 0}), 0);
  EXPECT_NEAR(error(s, {3, -2}, {0, 0, 0, 0}), 0, 1e-12);            // a translation
  EXPECT_NEAR(error(s, {1, 1}, {0, -0.01, 0.01, 0}), 0.01, 1e-12);   // a small rotation
  EXPECT_NEAR(error(s, {0, 1}, {0.02, 0, 0, 0.02}), 0.02, 1e-12);    // a dilatation
  EXPECT_NEAR(error(s, {0, 0}, {0.005, 0, 0, -0.03}), 0.03, 1e-12);  // along the edges
  const double once = error(s, {0, 0}, {0.01, 0.02, -0.03, 0.04});
  EXPECT_NEAR(error(s, {0, 0}, {0.03, 0.06, -0.09, 0.12}), 3 * once, 1e-12);
}

/// Newton iterations of a shaken block, dt from step to step as given.
int iterations(const std::string& predictor, const std::vector<double>& steps) {
  const std::string integrator = test::time_integrator("Newmark", 0.01, 10);
  const std::string name = "<ParameterList name=\"Time Integrator\">";
  Simulation s(
      test::scene(test::block_2d(1.0) + name + test::word("Predictor", predictor) + integrator.substr(name.size())),
      world());
  int sum = 0;
  for (double dt : steps) {
    const StepResult result = s.integrator().step(dt);
    EXPECT_TRUE(result.converged) << predictor;
    sum += result.newton_iterations;
  }
  return sum;
}

TEST(NearestPredictorTest, TakesFewerIterationsThanTheLastDisplacementInASmoothMotion) {
  std::vector<double> even(30, 0.03), uneven;
  for (int n = 0; n < 30; ++n) uneven.push_back(n % 5 == 0 ? 0.02 : 0.03);
  for (const auto& steps : {even, uneven}) {
    const int last = iterations("Last Displacement", steps);
    EXPECT_LT(iterations("Nearest", steps), last);
    EXPECT_LT(iterations("Quadratic", steps), last);
  }
}

}  // namespace
}  // namespace ixos

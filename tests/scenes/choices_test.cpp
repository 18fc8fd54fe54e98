// Scenes with each interaction law, obstacle and elastic law: they conserve energy, on any number of ranks and with any
// tangent.
#include <gtest/gtest.h>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::Adhesion;
using test::world;

constexpr double dt = 0.02;
constexpr int steps = 50;  ///< the block meets the obstacle

/// Average Vector Field with the exact mean of the interaction.
std::string exact_mean() {
  return test::time_integrator("Average Vector Field", dt, 1, test::count("Interaction Points", 0));
}

std::string named(const Adhesion& adhesion, int dimension) {
  return adhesion.law + ", " + adhesion.obstacle + ", " + adhesion.model + ", dimension " + std::to_string(dimension);
}

void run(Simulation& s) {
  for (int step = 0; step < steps; ++step) ASSERT_TRUE(s.integrator().step(dt).converged) << "step " << step;
}

std::vector<double> moved(const std::string& scene, const Comm& comm) {
  Simulation s(test::scene(scene), comm);
  run(s);
  return test::gathered(s.model(), s.integrator().state().u);
}

TEST(ChoicesTest, ConservingSchemesHoldTheEnergyAtTheObstacle) {
  for (int dimension : {2, 3})
    for (const Adhesion& adhesion : test::adhesions())
      for (const std::string& scheme : {exact_mean(), test::time_integrator("Energy-Momentum", dt, 1)}) {
        SCOPED_TRACE(named(adhesion, dimension));
        Simulation s(test::scene(test::adhesive_block(dimension, adhesion) + scheme), world());
        const double before = test::total_energy(s);
        run(s);
        EXPECT_NEAR(test::total_energy(s), before, 1e-11);
        const double gap = test::report_of(s).interaction_report().least_gap;
        EXPECT_LT(gap, 0.3) << "it has not met the obstacle";
      }
}

TEST(ChoicesTest, RanksMoveAsOne) {
  for (int dimension : {2, 3})
    for (const Adhesion& adhesion : test::adhesions())
      for (const std::string& scheme : {exact_mean(), test::time_integrator("Newmark", dt, 1)}) {
        SCOPED_TRACE(named(adhesion, dimension));
        const std::string scene = test::adhesive_block(dimension, adhesion) + scheme;
        EXPECT_LT(test::distance(moved(scene, test::self()), moved(scene, world())), 1e-11);
      }
}

TEST(ChoicesTest, MatrixFreeTangentsMoveTheBlockAsAssembledOnes) {
  const auto solver = [](const char* op) {
    return test::list("Linear Solver", test::word("Linear Solver Type", "Belos") + test::word("Operator", op));
  };
  for (const Adhesion& adhesion : test::adhesions()) {
    if (adhesion.model != "Neo-Hooke") continue;
    // Before the sphere the exact mean has no symmetric tangent.
    const std::string scheme =
        adhesion.obstacle == "Sphere" ? test::time_integrator("Average Vector Field", dt, 1) : exact_mean();
    SCOPED_TRACE(named(adhesion, 3));
    const std::string scene = test::adhesive_block(3, adhesion) + scheme;
    EXPECT_LT(
        test::distance(moved(scene + solver("Matrix-Free"), world()), moved(scene + solver("Assembled"), world())),
        1e-9);
  }
}

}  // namespace
}  // namespace ixos

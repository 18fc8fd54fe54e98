// The incremental potential of every stage: its slope is the residual, and what relaxes the tangent makes it steeper.
#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "time/schemes.hpp"
#include "time/stage_problem.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

/// Damped, loaded, held at one side, its enriched bottom at a wall.
std::string body(const std::string& friction = "") {
  std::string block = test::block_2d(0.5);
  block.insert(block.find(number("Density", 1)), number("Mass Damping", 0.3) + number("Stiffness Damping", 0.05));
  return block +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.4}) +
                                               number("Gamma W", 0.1) + word("Contact Element", "Q1C3") + friction)) +
         list("Boundary Conditions",
              list("Held", word("Node Set", "left")) +
                  list("Wind", word("Type", "Traction") + word("Side Set", "right") + numbers("Vector", {0.1, 0.2})));
}

/// Smooth fields of the coordinates, so that ghosts agree with their owners; zero on the held side x = 0.
std::vector<double> wave(const LocalMesh& mesh, double phase) {
  std::vector<double> field(mesh.coordinates.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double x = mesh.coordinates[i - i % 2];
    field[i] = mesh.is_derivative(i / 2) ? 0.0 : 0.03 * x * std::sin(1.7 * mesh.coordinates[i] + phase);
  }
  return field;
}

/// Compares differences of the potential with the residual, at every stage of the tables.
void expect_slopes(const std::string& scene, const std::vector<Table>& tables) {
  Simulation s(test::scene(scene + test::time_integrator("Newmark", 0.1, 1)), world());
  Model& model = s.model();
  for (const Table& table : tables)
    for (std::size_t k = 0; k < table.stages.size(); ++k) {
      std::vector<State> known(k + 1);
      for (std::size_t j = 0; j <= k; ++j) {
        const double phase = 0.9 * static_cast<double>(j);
        known[j] = {wave(model.mesh(), phase), wave(model.mesh(), phase + 1), wave(model.mesh(), phase + 2)};
      }
      known[0].histories = model.create_histories();
      StepMemories memories = model.create_memories();
      model.begin_step({known_states(known, 1).front(), 0.1, &known[0].histories}, memories);
      StageProblem problem(model, table);
      problem.arm(k, known, 0.1, memories);
      const auto map = problem.map();
      Vector x(map), direction(map), f(map), moved(map);
      const auto u = wave(model.mesh(), 0.4), d = wave(model.mesh(), 2.5);
      for (int i = 0; i < model.space().owned(); ++i) {
        x.replaceLocalValue(i, u[static_cast<std::size_t>(i)]);
        direction.replaceLocalValue(i, d[static_cast<std::size_t>(i)]);
      }
      ASSERT_TRUE(problem.residual(x, f)) << table.name;
      ASSERT_TRUE(problem.is_gradient());
      EXPECT_EQ(problem.way_left(x), 0);
      const double slope = f.dot(direction), h = 1e-4;
      moved.update(1.0, x, h, direction, 0.0);
      const Potential ahead = problem.potential(moved);
      moved.update(1.0, x, -h, direction, 0.0);
      const Potential behind = problem.potential(moved);
      EXPECT_NEAR((ahead.value - behind.value) / (2 * h), slope, 1e-6 * std::abs(slope) + 1e-10 * ahead.magnitude)
          << table.name << ", stage " << k + 1;
      EXPECT_GT(std::abs(slope), 1e-3);
    }
}

TEST(StagePotentialTest, ItsSlopeIsTheResidual) {
  expect_slopes(body(),
                {newmark(0.3, 0.6), bathe_composite(0.3, 0.45), gautam_sauer_composite(0.25, 0.5, 5, Path::Linear),
                 gautam_sauer_composite(0.25, 0.5, 5, Path::Kinematic), average_vector_field(4, 8),
                 average_vector_field(4, 0), gautam_sauer_composite(0.25, 0.5, 0, Path::Linear)});
}

// Friction follows the mean in closed form, and the law beside it the points.
TEST(StagePotentialTest, ItsSlopeIsTheResidualWithFriction) {
  const std::string constant = list("Friction", word("Type", "Constant Stress") + number("Stress", 2) +
                                                    number("Sharpness", 1) + number("Stiffness", 200)),
                    smoothed = list("Friction",
                                    word("Type", "Smoothed") + number("Coefficient", 200) + number("Slip Speed", 0.1));
  for (const std::string& friction : {constant, smoothed}) {
    std::string scene = body(friction);
    if (const std::string far = "{0, -0.4}"; friction == smoothed)
      scene.replace(scene.find(far), far.size(), "{0, -0.2}");
    expect_slopes(scene, {newmark(0.3, 0.6), average_vector_field(4, 3), average_vector_field(4, 2),
                          average_vector_field(4, 0), gautam_sauer_composite(0.25, 0.5, 3, Path::Linear),
                          gautam_sauer_composite(0.25, 0.5, 5, Path::Kinematic)});
  }
}

TEST(StagePotentialTest, RelaxedTangentsAreSteeper) {
  // d . K d grows from the exact tangent to the one without negative interaction stiffness, and with each shift.
  Simulation s(test::scene(body() + test::time_integrator("Newmark", 0.1, 1)), world());
  Model& model = s.model();
  const Table table = newmark(0.25, 0.5);
  StageProblem problem(model, table);
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  std::vector<State> start{{rest, rest, rest}};
  start[0].histories = model.create_histories();
  StepMemories memories = model.create_memories();
  problem.arm(0, start, 0.1, memories);
  const auto map = problem.map();
  Vector x(map), direction(map), product(map);
  x.putScalar(0.0);
  const auto d = wave(model.mesh(), 2.5);
  for (int i = 0; i < model.space().owned(); ++i) direction.replaceLocalValue(i, d[static_cast<std::size_t>(i)]);
  const auto w = problem.create_operator();
  double before = -1e300;
  for (int level = 0; level <= 4; ++level) {
    problem.relax_tangent(level);
    problem.tangent(x, *w);
    w->apply(direction, product);
    const double curvature = direction.dot(product);
    EXPECT_GT(curvature, before) << level;
    before = curvature;
  }
}

// At the start of the step no point is in reach of the penalty, so that its rounding is known within the step only.
TEST(StagePotentialTest, AStiffLawThatBeginsToActConvergesToItsRounding) {
  Simulation s(test::scene_file("hertz.xml", {"Mesh/Box/Divisions={31, 23}", "Nonlinear Solver/Tolerance=1e-11",
                                              "Interactions/Sphere/Penalty/Stiffness=10000"}),
               world());
  for (int n = 0; n < 2; ++n) {
    const StepResult result = s.integrator().step(0.1);
    ASSERT_TRUE(result.converged) << result.reason;
    EXPECT_LT(result.newton_iterations, 50);
  }
  EXPECT_LT(test::report_of(s).interaction_report().least_gap, 0.01) << "it acts";
}

}  // namespace
}  // namespace ixos

#include "time/default_linear_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

std::unique_ptr<Model> plate(Inertia inertia) {
  BoxShape shape;
  shape.divisions = {3, 2, 1};
  return test::model_of(box(shape), test::elastic(neo_hooke, 0.2), inertia);
}

TEST(DefaultLinearSolverTest, StiffnessIsThatOfTheTangent) {
  const auto model = plate(Inertia::Consistent);
  // beta dt^2 K + M
  EXPECT_NEAR(tangent_stiffness(*model, newmark(0.25, 0.5), 0.1), 0.25 * 0.01 * model->scales().stiffest, 1e-12);
  EXPECT_TRUE(std::isinf(tangent_stiffness(*model, newmark(0.25, 0.5), INFINITY)));
  EXPECT_TRUE(std::isinf(tangent_stiffness(*plate(Inertia::None), static_equilibrium(), 0.1)));
  EXPECT_TRUE(std::isinf(tangent_stiffness(*plate(Inertia::Lumped), central_difference(0.9), 0.1)));
}

/// A block above a wall, 2D or 3D, with or without viscosity.
Simulation block(int dimension, int cells, const std::string& scheme, double step, const std::string& material = "") {
  const bool plane = dimension == 2;
  const std::string box =
      test::count("Dimension", dimension) +
      test::numbers("Lengths", plane ? std::vector<double>{4, 2} : std::vector<double>{4, 2, 1}) +
      test::counts("Divisions", plane ? std::vector<int>{2 * cells, cells} : std::vector<int>{2 * cells, cells, cells});
  const std::vector<double> point = plane ? std::vector<double>{0, -0.5} : std::vector<double>{0, 0, -0.5};
  return Simulation(
      test::scene(test::list("Mesh", test::word("Type", "Box") + test::list("Box", box)) +
                  test::list("Materials", test::list("Rubber", test::number("Poisson's Ratio", 0.3) + material)) +
                  test::list("Interactions",
                             test::list("Wall", test::word("Side Set", "bottom") + test::numbers("Point", point))) +
                  test::time_integrator(scheme, step, 1)),
      test::world());
}

std::string in_words(const Teuchos::ParameterList& list) {
  std::ostringstream text;
  list.print(text, Teuchos::ParameterList::PrintOptions().showTypes(true).showFlags(false));
  return text.str();
}

TEST(DefaultLinearSolverTest, ItIsThatOfAScene) {
  struct Case {
    int dimension, cells;
    Table table;
    double step;
    std::string material, solver;
  };
  const std::string viscous = test::number("Viscosity", 0.4);
  for (const Case& c : {Case{2, 3, average_vector_field(4, 8), 0.1, "", "Direct"},
                        {2, 24, newmark(0.25, 0.5), 0.1, "", "Direct (Band)"},
                        {2, 42, newmark(0.25, 0.5), 0.1, "", "Belos"},
                        {3, 3, newmark(0.25, 0.5), 0.1, viscous, "Direct"},
                        {2, 3, energy_momentum(), 0.1, "", "Direct (Band LU)"},
                        {3, 8, newmark(0.25, 0.5), 1e-4, "", "matrix-free"}}) {
    const Simulation scene = block(c.dimension, c.cells, c.table.name, c.step, c.material);
    const Teuchos::ParameterList own = completed_linear_solver({}, stage_size(scene.model(), c.table, c.step));
    EXPECT_EQ(in_words(own), in_words(scene.parameters().sublist("Linear Solver"))) << c.table.name;
    EXPECT_NE(linear_solver_in_words(own).find(c.solver), std::string::npos) << linear_solver_in_words(own);
  }
}

/// Energy-Momentum's tangent is unsymmetric.
TEST(DefaultLinearSolverTest, ItSolvesSymmetricAndUnsymmetricStages) {
  for (const Table& table : {average_vector_field(4, 8), energy_momentum()}) {
    const auto model = plate(Inertia::Consistent);
    Integrator integrator(*model, table, default_linear_solver(*model, table, 0.1), {});
    std::vector<double> velocity = test::at_rest(*model);
    for (std::size_t i = 0; i < velocity.size(); i += 2) velocity[i] = 0.3 * model->mesh().coordinates[i + 1];
    integrator.initialize(test::at_rest(*model), velocity, 0);
    EXPECT_TRUE(integrator.step(0.1).converged) << table.name;
  }
}

}  // namespace
}  // namespace ixos

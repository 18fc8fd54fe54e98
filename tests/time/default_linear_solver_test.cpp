#include "time/default_linear_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
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
  EXPECT_NEAR(tangent_stiffness(*model, newmark(0.25, 0.5), 0.1), 0.25 * 0.01 * model->stiffest(), 1e-12);
  EXPECT_TRUE(std::isinf(tangent_stiffness(*model, newmark(0.25, 0.5), INFINITY)));
  EXPECT_TRUE(std::isinf(tangent_stiffness(*plate(Inertia::None), static_equilibrium(), 0.1)));
  EXPECT_TRUE(std::isinf(tangent_stiffness(*plate(Inertia::Lumped), central_difference(0.9), 0.1)));
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

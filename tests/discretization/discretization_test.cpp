// Further couplings: the pattern, and a model that moves as before with them.
#include "discretization/discretization.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mesh/generators/shapes.hpp"
#include "support/comparison.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

std::unique_ptr<Model> block(double damping = 0) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {4, 3, 0};
  Material material = test::elastic(neo_hooke, 0.3);
  material.viscosity = material.mass_damping = material.stiffness_damping = damping;
  auto model = test::model_of(box(shape), material, Inertia::Consistent);
  for (int node = 0; node < model->mesh().nodes(); ++node)
    if (model->mesh().coordinates[2 * static_cast<std::size_t>(node)] == 0)
      model->constraints().add(2 * node, 1.0, nullptr);
  return model;
}

/// Every third of the rank's nodes, and a pair.
std::vector<std::vector<int>> stencils(const Model& model) {
  std::vector<int> far;
  for (int node = 0; node < model.mesh().nodes(); node += 3) far.push_back(node);
  if (model.mesh().nodes() < 2) return {far};
  return {far, {0, model.mesh().nodes() - 1}};
}

TEST(DiscretizationTest, StencilsAreCoupled) {
  const auto model = block();
  const int before = model->pattern().pairs();
  EXPECT_EQ(model->discretization().version(), 0);
  const auto more = stencils(*model);
  model->couple(more);
  EXPECT_EQ(model->discretization().version(), 1);
  EXPECT_GE(model->pattern().pairs(), before);
  for (const std::vector<int>& stencil : more)
    for (int row : stencil)
      for (int column : stencil) EXPECT_EQ(model->pattern().pair(row, column) >= 0, row < model->pattern().rows());
  EXPECT_THROW(model->couple({{0, model->mesh().nodes()}}), std::out_of_range);
  EXPECT_EQ(model->discretization().version(), 1);
}

/// The state after five steps; the second model is coupled further after the second step.
void expect_same_motion(const Table& table, double damping) {
  SCOPED_TRACE(table.name);
  const auto plain = block(damping), coupled = block(damping);
  Integrator straight = test::direct(*plain, table), renewed = test::direct(*coupled, table);
  for (Integrator* integrator : {&straight, &renewed}) {
    std::vector<double> v = test::at_rest(*plain);
    for (std::size_t i = 0; i < v.size(); i += 2) {
      v[i] = 0.2 * plain->mesh().coordinates[i];
      v[i + 1] = -0.1 * plain->mesh().coordinates[i];
    }
    integrator->initialize(test::at_rest(*plain), v, 0);
  }
  for (int step = 0; step < 5; ++step) {
    if (step == 2) coupled->couple(stencils(*coupled));
    ASSERT_TRUE(straight.step(0.1).converged);
    ASSERT_TRUE(renewed.step(0.1).converged);
  }
  EXPECT_LT(plain->space().maximum(test::distance(straight.state().u, renewed.state().u)), 1e-11);
  EXPECT_LT(plain->space().maximum(test::distance(straight.acceleration(), renewed.acceleration())), 1e-8);
}

TEST(DiscretizationTest, AModelMovesAsBeforeWithFurtherCouplings) {
  for (const Table& table : {newmark(0.25, 0.5), bathe_composite(0, 0.5), average_vector_field(4, 4)}) {
    expect_same_motion(table, 0);
    expect_same_motion(table, 0.02);
  }
}

}  // namespace
}  // namespace ixos

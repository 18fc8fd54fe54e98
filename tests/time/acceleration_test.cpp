// Accelerations that are known: of closed forms, and of forces that were made for them.
#include "time/acceleration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using test::at_rest;

constexpr double density = 0.7;

Material material(double mass_damping = 0) {
  Material result = test::elastic(linear_elastic, 0.2);
  result.density = density;
  result.mass_damping = mass_damping;
  return result;
}

/// A block of 3 by 2.
std::unique_ptr<Model> block(const Material& of, Inertia inertia) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {4, 3, 0};
  return test::model_of(box(shape), of, inertia);
}

/// The direct solver, or one for tangents without a matrix: then the mass has no matrix either.
std::shared_ptr<const LinearSolverFactory> linear_solver(bool matrix_free) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", matrix_free ? "Belos" : "Direct");
  list.set("Preconditioner Type", matrix_free ? "Chebyshev" : "None");
  list.set("Operator", matrix_free ? "Matrix-Free" : "Assembled");
  return std::make_shared<LinearSolverFactory>(completed_linear_solver(list, {2, 100, test::world()->getSize()}));
}

/// How a mass is solved for, and to which relative accuracy.
struct Way {
  Inertia inertia;
  bool matrix_free;
  double accuracy;
};
const Way ways[] = {
    {Inertia::Consistent, false, 1e-13}, {Inertia::Consistent, true, 1e-10}, {Inertia::Lumped, false, 1e-13}};

/// A smooth field of the place, so that ghosts agree with their owners; between 1 and 3.
std::vector<double> wave(const Model& model) {
  std::vector<double> field = at_rest(model);
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = 2 + std::sin(1.3 * model.mesh().coordinates[i] + static_cast<double>(i % 2));
  return field;
}

/// Returns M a, a local array that is complete for owned degrees of freedom.
std::vector<double> inertia_of(const Model& model, const std::vector<double>& a) {
  std::vector<double> result(a.size(), 0.0);
  model.mass()->multiply(a.data(), result.data());
  return result;
}

/// A state of a model at a time.
State state_of(std::vector<double> u, std::vector<double> v, double time = 0) {
  State state;
  state.u = std::move(u);
  state.v = std::move(v);
  state.time = time;
  return state;
}

// Mass-proportional damping and weight give all nodes the acceleration of a rigid body.
TEST(AccelerationTest, ABodyFallsAgainstItsDamping) {
  const double gravity[] = {0.1, -0.5}, speed[] = {2, 3}, alpha = 0.4;
  for (const Way& way : ways) {
    const auto model = block(material(alpha), way.inertia);
    std::vector<double> pull = at_rest(*model), v(pull);
    for (std::size_t i = 0; i < v.size(); ++i) {
      pull[i] = gravity[i % 2];
      v[i] = speed[i % 2];
    }
    // The history is 1 at that time.
    model->loads().add(inertia_of(*model, pull), expression("4*t", "", ""));
    std::vector<double> a;
    const State state = state_of(at_rest(*model), v, 0.25);
    EXPECT_TRUE(Acceleration(*model, linear_solver(way.matrix_free)).solve(state.place(), a));
    ASSERT_EQ(a.size(), v.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], gravity[i % 2] - alpha * speed[i % 2], 10 * way.accuracy) << i;
  }
}

// The forces M a of a field a give that field back. Its values are prescribed at the left end, where a further push
// changes the reactions alone.
TEST(AccelerationTest, PrescribedAccelerationsAndTheRestMakeOneField) {
  const double time = 0.5, push = 0.25;
  for (const Way& way : ways) {
    const auto model = block(material(), way.inertia);
    const std::vector<double> field = wave(*model);
    const auto motion = expression("t^3", "3*t^2", "6*t");
    const LocalMesh& mesh = model->mesh();
    for (int node : mesh.node_sets[mesh.node_set("left")])
      for (int dof : {2 * node, 2 * node + 1})
        model->constraints().add(dof, field[static_cast<std::size_t>(dof)] / (6 * time), motion);
    std::vector<double> force = inertia_of(*model, field);
    for (int dof : model->constraints().dofs()) force[static_cast<std::size_t>(dof)] += push;
    model->loads().add(force, constant(1));
    Acceleration acceleration(*model, linear_solver(way.matrix_free));
    State state = state_of(at_rest(*model), at_rest(*model), time);
    for (int repeat = 0; repeat < 2; ++repeat) {  // the second time with the matrix that is there
      ASSERT_TRUE(acceleration.solve(state.place(), state.a));
      for (std::size_t i = 0; i < field.size(); ++i) EXPECT_NEAR(state.a[i], field[i], 10 * way.accuracy) << i;
    }
    acceleration.record_forces(state);
    const auto owned = static_cast<std::size_t>(model->space().owned());
    ASSERT_EQ(state.load.size(), owned);
    ASSERT_EQ(state.reaction.size(), model->constraints().empty() ? 0 : owned);
    for (std::size_t i = 0; i < owned; ++i) EXPECT_EQ(state.load[i], force[i]);
    for (std::size_t i = 0; i < state.reaction.size(); ++i) {
      if (model->constraints().holds(static_cast<int>(i)))
        EXPECT_NEAR(state.reaction[i], -push, 10 * way.accuracy);
      else
        EXPECT_EQ(state.reaction[i], 0);
    }
  }
}

// One square of length 1 with E = 1, nu = 0, its bottom held, its top on rollers and raised by U. The elastic energy
// U^2/2 pulls the top back. Its mass counts as 1/3 or, lumped, as 1/2.
TEST(AccelerationTest, AnOscillatorIsPulledBack) {
  const double raised = 0.01;
  for (const Way& way : ways) {
    Material soft = test::elastic(linear_elastic, 0);
    const auto model = test::model_of(box({}), soft, way.inertia);
    const LocalMesh& mesh = model->mesh();
    for (int node : mesh.node_sets[mesh.node_set("bottom")])
      for (int dof : {2 * node, 2 * node + 1}) model->constraints().add(dof, 1, nullptr);
    for (int node : mesh.node_sets[mesh.node_set("top")]) model->constraints().add(2 * node, 1, nullptr);
    std::vector<double> u = at_rest(*model), a;
    for (std::size_t i = 1; i < u.size(); i += 2) u[i] = raised * mesh.coordinates[i];
    const State state = state_of(u, at_rest(*model));
    EXPECT_TRUE(Acceleration(*model, linear_solver(way.matrix_free)).solve(state.place(), a));
    const double top = (way.inertia == Inertia::Lumped ? -2 : -3) * raised;
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], i % 2 == 1 && mesh.coordinates[i] == 1 ? top : 0, raised * 10 * way.accuracy) << i;
  }
}

// One corner turns its cell inside out. Ranks that do not see it hear of it.
TEST(AccelerationTest, AnInvertedCellIsInadmissibleOnAllRanks) {
  const auto model = block(test::elastic(neo_hooke, 0.2), Inertia::Consistent);
  std::vector<double> u = at_rest(*model), a;
  const std::vector<double>& x = model->mesh().coordinates;
  for (std::size_t i = 0; i < u.size(); i += 2)
    if (x[i] == 3 && x[i + 1] == 2) u[i] = u[i + 1] = -2;
  Acceleration acceleration(*model, linear_solver(false));
  const State inverted = state_of(u, at_rest(*model)), rest = state_of(at_rest(*model), at_rest(*model));
  EXPECT_FALSE(acceleration.balance(inverted.place()));
  EXPECT_FALSE(acceleration.solve(inverted.place(), a));
  EXPECT_TRUE(acceleration.balance(rest.place()));
  EXPECT_TRUE(acceleration.solve(rest.place(), a));
}

TEST(AccelerationTest, WithoutInertiaThereIsNone) {
  const auto model = block(material(), Inertia::None);
  model->loads().add(wave(*model), constant(1));
  std::vector<double> a(7, 5.0);
  const State rest = state_of(at_rest(*model), at_rest(*model));
  EXPECT_TRUE(Acceleration(*model, linear_solver(false)).solve(rest.place(), a));
  EXPECT_EQ(a, at_rest(*model));
}

}  // namespace
}  // namespace ixos

#include "model/conditions.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "embedding/semi_discrete_evaluator.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/surface_interaction.hpp"
#include "support/refusal.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

/// 3 by 2 L0, 6 by 4 cells, density 0.5.
std::unique_ptr<Model> plate() {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  Material rubber = test::elastic(linear_elastic, 0.2);
  rubber.density = 0.5;
  return test::model_of(box(shape), rubber, Inertia::Consistent);
}

/// The sum of all loads at a time, over all ranks.
std::vector<double> total(const Model& model, double time) {
  std::vector<double> force = test::at_rest(model), sum(2, 0.0);
  model.loads().add_force(time, 1.0, force.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i) sum[i % 2] += force[i];
  model.space().sum(sum.data(), 2);
  return sum;
}

void expect_total(const std::vector<double>& sum, double x, double y) {
  EXPECT_NEAR(sum[0], x, 1e-13);
  EXPECT_NEAR(sum[1], y, 1e-13);
}

TEST(ConditionsTest, LoadsAddUpToMeasureTimesVector) {
  const auto ramp = function_of_time([](double t) { return TimeValue{2 * t, 2, 0}; });
  auto model = plate();
  add_traction(*model, "right", {0.3, -0.1}, ramp);  // on 2 L0
  expect_total(total(*model, 1.5), 3 * 2 * 0.3, -3 * 2 * 0.1);
  model = plate();
  add_body_force(*model, "", {0, -4}, constant(1));  // in 6 L0^2
  expect_total(total(*model, 0), 0, -24);
  model = plate();
  add_gravity(*model, "body", {1, -10}, constant(2));
  expect_total(total(*model, 0), 2 * 0.5 * 6, -2 * 0.5 * 60);
  model = plate();
  add_point_force(*model, "left", {0.5, 0}, constant(1));  // on 5 nodes
  add_point_force(*model, "left", {0, 1}, constant(1));
  expect_total(total(*model, 0), 2.5, 5);
}

TEST(ConditionsTest, ComponentsOfASetFollowTheMotion) {
  auto model = plate();
  prescribe(*model, "left", "x");
  prescribe(*model, "top", "y", function_of_time([](double t) { return TimeValue{t * t, 2 * t, 2}; }));
  std::vector<double> u(test::at_rest(*model).size(), 7.0), v(u), a(u);
  model->constraints().set(3.0, u.data(), v.data(), a.data());
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const bool left = mesh.coordinates[2 * node] == 0, top = mesh.coordinates[2 * node + 1] == 2;
    EXPECT_EQ(u[2 * node], left ? 0 : 7);
    EXPECT_EQ(u[2 * node + 1], top ? 9 : 7);
    EXPECT_EQ(v[2 * node + 1], top ? 6 : 7);
    EXPECT_EQ(a[2 * node + 1], top ? 2 : 7);
  }
}

TEST(ConditionsTest, WrongNamesAndVectorsAreRefused) {
  auto model = plate();
  expect_contains(refusal([&] { prescribe(*model, "lft", "x"); }), "did you mean \"left\"?");
  expect_contains(refusal([&] { prescribe(*model, "left", "xz"); }), "\"xz\" names z, but the mesh has 2 dimensions");
  expect_contains(refusal([&] { prescribe(*model, "left", ""); }), "no component is named");
  expect_contains(refusal([&] { add_traction(*model, "rigth", {1, 0}, constant(1)); }), "did you mean \"right\"?");
  expect_contains(refusal([&] { add_body_force(*model, "bdy", {1, 0}, constant(1)); }), "did you mean \"body\"?");
  expect_contains(refusal([&] { add_gravity(*model, "", {1, 0, 0}, constant(1)); }), "has 3 components");
  expect_contains(refusal([&] { add_point_force(*model, "left", {1, 0}, nullptr); }), "no function of time");
  EXPECT_TRUE(model->loads().empty());

  prescribe(*model, "left", "all");
  prescribe(*model, "left", "x");  // the same again
  // The corner belongs to both sets; it is node 28 of the mesh, from 0.
  expect_contains(refusal([&] { prescribe(*model, "top", "x", constant(1)); }),
                  "two conditions prescribe different motions for one degree of freedom: component x of node 29");
}

TEST(ConditionsTest, ARefusedMotionPrescribesNothing) {
  auto model = plate();
  prescribe(*model, "left", "x");
  const std::vector<int> before = model->constraints().dofs();
  // The y of all nodes at the top is free, the x of one corner is not.
  expect_contains(refusal([&] { prescribe(*model, "top", "yx", constant(1)); }), "component x of node 29");
  EXPECT_EQ(model->constraints().dofs(), before);
  EXPECT_FALSE(model->constraints().driven());
}

void expect_closed(Model& model) {
  EXPECT_THROW(prescribe(model, "left", "x"), std::logic_error);
  EXPECT_THROW(add_traction(model, "right", {1, 0}, constant(1)), std::logic_error);
  EXPECT_THROW(model.constraints().add(0, 1.0, nullptr), std::logic_error);
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = flat_wall({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}});
  EXPECT_THROW(add_interaction(model, wall), std::logic_error);
  EXPECT_TRUE(model.loads().empty());
  EXPECT_TRUE(model.constraints().empty());
  EXPECT_FALSE(model.has_interactions());
}

TEST(ConditionsTest, AnIntegratorClosesTheModel) {
  auto model = plate();
  const Integrator integrator = test::direct(*model, newmark(0.25, 0.5));
  expect_closed(*model);
}

TEST(ConditionsTest, AnEvaluatorClosesTheModel) {
  auto model = plate();
  const SemiDiscreteEvaluator evaluator(*model);
  expect_closed(*model);
}

TEST(ConditionsSerialTest, AllComponentsAreThoseOfTheDimension) {
  EXPECT_EQ(components_of("all", 2), (std::vector<int>{0, 1}));
  EXPECT_EQ(components_of("all", 3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(components_of("zx", 3), (std::vector<int>{2, 0}));
}

}  // namespace
}  // namespace ixos

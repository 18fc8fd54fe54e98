#include "model/set_reactions.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "support/refusal.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// 3 by 2 L0, 6 by 4 cells; the left side is held along x, the top along y.
std::unique_ptr<Model> plate() {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  auto model = test::model_of(box(shape), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
  prescribe(*model, "left", "x");
  prescribe(*model, "top", "y");
  return model;
}

/// The force (1 + y, 10) at each owned node; NaN at ghosts, which must not count.
std::vector<double> forces(const Model& model) {
  std::vector<double> f(test::at_rest(model).size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); i += 2) {
    f[i] = 1 + model.mesh().coordinates[i + 1];
    f[i + 1] = 10;
  }
  return f;
}

TEST(SetReactionsTest, SumsAreOfConstrainedDegreesOfFreedom) {
  const auto model = plate();
  const LocalMesh& mesh = model->mesh();
  const std::vector<double> sums =
      set_reactions(*model, forces(*model), {mesh.node_set("top"), mesh.node_set("right"), mesh.node_set("left")});
  ASSERT_EQ(sums.size(), 6U);
  EXPECT_NEAR(sums[0], 3, 1e-14);   // the corner on the left
  EXPECT_NEAR(sums[1], 70, 1e-13);  // 7 nodes
  EXPECT_NEAR(sums[2], 0, 1e-14);
  EXPECT_NEAR(sums[3], 10, 1e-14);  // the corner at the top
  EXPECT_NEAR(sums[4], 5 + (0 + 0.5 + 1 + 1.5 + 2), 1e-13);
  EXPECT_NEAR(sums[5], 10, 1e-14);
}

TEST(SetReactionsTest, OneSetHasItsName) {
  const auto model = plate();
  const std::vector<double> sum = set_reaction(*model, forces(*model), "top");
  ASSERT_EQ(sum.size(), 2U);
  EXPECT_NEAR(sum[1], 70, 1e-13);
  test::expect_contains(test::refusal([&] { set_reaction(*model, forces(*model), "tpo"); }), "did you mean \"top\"?");
}

TEST(SetReactionsTest, AModelWithoutConditionsHasNone) {
  BoxShape shape;
  const auto model = test::model_of(box(shape), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
  EXPECT_EQ(set_reaction(*model, {}, "left"), (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace ixos

#include "model/tied_sets.hpp"

#include <gtest/gtest.h>

#include "mesh/generators/shapes.hpp"
#include "mesh/splitting/refine.hpp"
#include "model/conditions.hpp"
#include "support/refusal.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// Two by two cells, one of them split, and sets of a hanging node with and without all nodes that it follows.
std::unique_ptr<Model> split_box() {
  BoxShape shape;
  shape.dimension = 2;
  shape.divisions = {2, 2, 1};
  Mesh mesh = box(shape);
  RefinedRegion corner;
  corner.upper = {0.1, 0.1};
  refine(mesh, {{"corner", corner}}, 1);
  const Tie& tie = mesh.ties.front();
  mesh.node_sets.push_back({"half", {tie.node, tie.masters.front()}});
  mesh.node_sets.push_back({"whole", {tie.node, tie.masters.front(), tie.masters.back()}});
  mesh.node_sets.push_back({"other half", {tie.masters.back()}});
  return test::model_of(mesh, test::elastic(linear_elastic, 0.3), Inertia::None);
}

TEST(TiedSetsTest, HangingNodesMoveWithAllThatTheyFollowOrNot) {
  const auto half = split_box();
  prescribe(*half, "half", "x", nullptr);
  const std::string refusal = test::refusal([&] { half->close(); });
  test::expect_contains(refusal, "node set \"half\"");
  test::expect_contains(refusal, "which is tied to node");
  const auto model = split_box();
  prescribe(*model, "whole", "x", nullptr);
  for (const int dof : model->constraints().dofs()) EXPECT_FALSE(model->mesh().is_tied(dof / 2));
  model->close();
}

TEST(TiedSetsTest, SeveralConditionsMayHoldTheNodesThatATiedOneFollows) {
  const auto model = split_box();
  prescribe(*model, "half", "x", nullptr);
  prescribe(*model, "other half", "y", nullptr);
  EXPECT_NE(test::refusal([&] { model->check_tied_conditions(); }), "");
  prescribe(*model, "other half", "x", nullptr);
  EXPECT_EQ(test::refusal([&] { model->check_tied_conditions(); }), "");
}

TEST(TiedSetsTest, AMotionMustBeThatOfAllNodesThatATiedOneFollows) {
  const auto model = split_box();
  prescribe(*model, "half", "x", rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
  prescribe(*model, "other half", "x", nullptr);
  EXPECT_NE(test::refusal([&] { model->check_tied_conditions(); }), "");
}

TEST(TiedSetsTest, AModelWithAConstrainedTiedNodeCannotBeUsed) {
  const auto model = split_box();
  model->constraints().add(2 * model->mesh().ties.first(), 1.0, nullptr);
  EXPECT_THROW(model->close(), std::logic_error);
}

}  // namespace
}  // namespace ixos

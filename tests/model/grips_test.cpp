#include "model/grips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "model/traits.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

/// 3 by 2 L0, 6 by 4 cells.
std::unique_ptr<Model> plate(Inertia inertia = Inertia::Consistent) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  return test::model_of(box(shape), test::elastic(neo_hooke, 0.2), inertia);
}

RigidMotion turning(double angle, std::vector<double> point) {
  RigidMotionOptions options;
  options.angle = constant(angle);
  options.point = std::move(point);
  return {2, options};
}

TEST(GripsTest, NodesOfASetTurnAboutThePoint) {
  const auto model = plate();
  grip_rigidly(*model, "Jaw", "left", turning(M_PI / 2, {0, 1}));
  std::vector<double> u(test::at_rest(*model).size(), 7.0);
  model->constraints().set(0, u.data(), nullptr, nullptr);
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const double x = mesh.coordinates[2 * node], y = mesh.coordinates[2 * node + 1];
    EXPECT_NEAR(u[2 * node], x == 0 ? 1 - y : 7, 1e-15);
    EXPECT_NEAR(u[2 * node + 1], x == 0 ? 1 - y : 7, 1e-15);
  }
  ASSERT_EQ(model->grips().size(), 1U);
  EXPECT_TRUE(model->grips()[0].rigid);
  EXPECT_FALSE(has_springs(*model));
}

// A unit force in x and 2 in y at each of the 5 nodes of the left side.
TEST(GripsTest, ForceAndMomentAreThoseOfTheNodalForces) {
  const auto model = plate();
  grip_rigidly(*model, "Jaw", "left", turning(0, {-1, 0.5}));
  const std::vector<double> u = test::at_rest(*model);
  std::vector<double> forces(u.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = i % 2 == 0 ? 1 : 2;
  const GripReaction own = grip_reaction(*model, model->grips()[0], 0, u, u, forces);
  ASSERT_EQ(own.force.size(), 2U);
  ASSERT_EQ(own.moment.size(), 1U);
  EXPECT_NEAR(own.force[0], 5, 1e-14);
  EXPECT_NEAR(own.force[1], 10, 1e-14);
  EXPECT_NEAR(own.moment[0], 5 * (1 * 2 - 0.5 * 1), 1e-13);  // x F_y - y F_x about the point, mean y = 1
}

TEST(GripsTest, NodesShareSpringsEqually) {
  const auto model = plate();
  RigidMotionOptions options;
  options.translation = {constant(0.3), nullptr};
  options.point = {0, 1};
  grip_elastically(*model, "Machine", "left", {2, options}, {{4, 0}, {0, 8}});
  EXPECT_TRUE(has_springs(*model));
  EXPECT_EQ(model->dissipation_names(), std::vector<std::string>{"dashpots of Machine"});
  std::vector<double> u = test::at_rest(*model), v = u;
  for (std::size_t i = 0; i < u.size(); i += 2) {
    u[i] = 0.1 * model->mesh().coordinates[i + 1];  // sheared, mean 0.1
    v[i + 1] = 0.5;
  }
  const GripReaction own = grip_reaction(*model, model->grips()[0], 0, u, v, {});
  EXPECT_NEAR(own.force[0], 4 * (0.3 - 0.1), 1e-14);
  EXPECT_NEAR(own.force[1], -8 * 0.5, 1e-14);
  // -sum y F_x: variance of y = 0, 0.5, ..., 2 is 0.5. The arms of F_y are u_x - 0.3, of mean -0.2.
  EXPECT_NEAR(own.moment[0], 4 * 0.1 * 0.5 + 4 * 0.2, 1e-14);
  const double stored =
      test::ReportAt(*model, u.data()).elastic_energy() - test::ReportAt(*model, u.data()).energy(Part::Elastic);
  EXPECT_NEAR(stored, 4 * 0.3 * (0.15 - 0.1), 1e-14);  // K w (w/2 - u)
}

TEST(GripsTest, BadGripsAreRefused) {
  const auto model = plate();
  const RigidMotion still(2, {});
  expect_contains(refusal([&] { grip_rigidly(*model, "Jaw", "lft", still); }), "did you mean \"left\"?");
  expect_contains(refusal([&] { grip_rigidly(*model, "Jaw", "left", RigidMotion(3, {})); }), "has 3 dimensions");
  prescribe(*model, "top", "y", constant(1.0));
  expect_contains(refusal([&] { grip_rigidly(*model, "Jaw", "left", still); }),
                  "two conditions prescribe different motions for one degree of freedom: component y of node");
  EXPECT_TRUE(model->grips().empty());
  const auto springs = [&](const GripSupport& support) {
    return refusal([&] { grip_elastically(*model, "Machine", "left", still, support); });
  };
  expect_contains(springs({}), "neither a stiffness nor a damping");
  expect_contains(springs({{0, 0}, {}}), "neither a stiffness nor a damping");
  expect_contains(springs({{1, -1}, {}}), "the stiffness has the component -1");
  expect_contains(springs({{}, {1}}), "the damping has 1 components");
  EXPECT_EQ(springs({{1, 1}, {}}), "");
  expect_contains(springs({{1, 1}, {}}), "two grips of the name \"Machine\"");
  expect_contains(refusal([&] {
                    grip_elastically(*plate(Inertia::None), "Machine", "left", still, {{}, {1, 1}});
                  }),
                  "without inertia there are no velocities");
  model->close();
  EXPECT_THROW(grip_rigidly(*model, "Late", "right", still), std::logic_error);
}

/// The same as a cylinder of radius 3 around its left side.
std::unique_ptr<Model> axisymmetric_plate() {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  Mesh mesh = box(shape);
  mesh.axisymmetric = true;
  return test::model_of(mesh, test::elastic(neo_hooke, 0.2), Inertia::Consistent);
}

TEST(GripsTest, AxisymmetricBodiesStayOnTheAxis) {
  const auto model = axisymmetric_plate();
  RigidMotionOptions along_x, along_y;
  along_x.translation = {constant(1.0), nullptr};
  along_y.translation = {nullptr, constant(1.0)};
  for (const RigidMotion& motion : {RigidMotion(2, along_x), turning(0.1, {0, 0})})
    expect_contains(refusal([&] { grip_rigidly(*model, "Jaw", "top", motion); }),
                    "the grip \"Jaw\" moves off the axis of an axisymmetric mesh: it may translate along y only");
  const RigidMotion lift(2, along_y);
  for (const GripSupport& radial : {GripSupport{{4, 8}, {}}, GripSupport{{0, 8}, {4, 0}}})
    expect_contains(refusal([&] { grip_elastically(*model, "Machine", "top", lift, radial); }),
                    "has the radial component 4; on an axisymmetric mesh it acts along y only: use 0");
  grip_elastically(*model, "Machine", "top", lift, {{0, 8}, {}});
  grip_rigidly(*model, "Clamp", "bottom", RigidMotion(2, {}));
  std::vector<double> u(static_cast<std::size_t>(model->space().local()), 0.0);
  const std::vector<double> v(u);
  model->close();
  const GripReaction own = grip_reaction(*model, model->grips()[0], 0, u, v, {});
  EXPECT_EQ(own.force[0], 0);
  EXPECT_NEAR(own.force[1], 8, 1e-14);
  EXPECT_TRUE(own.moment.empty());
  // The radial forces of the rings of 7 nodes, summed.
  const std::vector<double> reactions(u.size(), 0.5);
  EXPECT_EQ(grip_reaction(*model, model->grips()[1], 0, u, v, reactions).force, (std::vector<double>{3.5, 3.5}));
}

// The corner of the side is on the axis, which holds it in x as the grip does.
TEST(GripsTest, ARigidGripMayTouchTheAxis) {
  const auto model = axisymmetric_plate();
  RigidMotionOptions along_y;
  along_y.translation = {nullptr, constant(0.5)};
  grip_rigidly(*model, "Jaw", "top", RigidMotion(2, along_y));
  ASSERT_EQ(model->grips().size(), 1U);
  std::vector<double> u(test::at_rest(*model).size(), 7.0);
  model->constraints().set(0, u.data(), nullptr, nullptr);
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const double x = mesh.coordinates[2 * node], y = mesh.coordinates[2 * node + 1];
    EXPECT_EQ(u[2 * node], x == 0 || y == 2 ? 0 : 7);
    EXPECT_EQ(u[2 * node + 1], y == 2 ? 0.5 : 7);
  }
  // A condition that moves a node off the axis is told why.
  expect_contains(refusal([&] { prescribe(*axisymmetric_plate(), "left", "all", constant(1.0)); }),
                  "of the mesh (nodes on the axis are held in x)");
}

}  // namespace
}  // namespace ixos

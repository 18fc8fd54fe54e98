#include "model/interaction_group.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/model.hpp"
#include "model/surface_interaction.hpp"
#include "support/contact_element.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using test::at_rest;
using test::noise;

/// 3 by 2 (by 1) L0, its lower corner at (0, 0.4, -0.2).
Mesh block(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = {0, 0.4, -0.2};
  shape.lengths = {3, 2, 1};
  shape.divisions = {6, 4, 2};
  return box(shape);
}

SurfaceInteraction wall(const std::string& name, const std::string& side_set, const HalfSpace& half_space) {
  SurfaceInteraction wall;
  wall.name = name;
  wall.side_set = side_set;
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = flat_wall(half_space);
  return wall;
}

std::vector<double> shifted(const Model& model, const std::vector<double>& by) {
  std::vector<double> u = at_rest(model);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = by[i % by.size()];
  return u;
}

const VanDerWaals law(2.5, 25);

/// A rigid block between a floor at y = 0 and a wall at x = 3.3.
std::unique_ptr<Model> cornered() {
  auto model = test::model_of(block(2), test::elastic(linear_elastic, 0.2), Inertia::None);
  add_interaction(*model, wall("Floor", "bottom", {{0, 0, 0}, {0, 1, 0}}));
  add_interaction(*model, wall("Stop", "right", {{3.3, 0, 0}, {-1, 0, 0}}));
  return model;
}

TEST(InteractionGroupTest, ForceAndMomentOfARigidBodyBeforeTwoWalls) {
  const auto model = cornered();
  EXPECT_EQ(model->interaction_names(), (std::vector<std::string>{"Floor", "Stop"}));
  const std::vector<double> u = shifted(*model, {0.05, -0.1});
  const test::ReportAt report(*model, u.data());
  const InteractionGroup floor = report.interaction("Floor"), stop = report.interaction("Stop");
  const double up = 3 * law.traction(0.3), right = -2 * law.traction(0.25);
  const InteractionReport below = floor.report(), beside = stop.report();
  EXPECT_NEAR(below.force[0], 0, 1e-14);
  EXPECT_NEAR(below.force[1], up, 1e-13);
  EXPECT_NEAR(below.least_gap, 0.3, 1e-15);
  EXPECT_NEAR(beside.force[0], right, 1e-13);
  EXPECT_NEAR(beside.force[1], 0, 1e-14);
  EXPECT_NEAR(beside.least_gap, 0.25, 1e-15);
  ASSERT_EQ(floor.moment().size(), 1U);
  EXPECT_NEAR(floor.moment()[0], (1.5 + 0.05) * up, 1e-13);
  EXPECT_NEAR(stop.moment()[0], -(0.4 + 1 - 0.1) * right, 1e-13);
  // Together they are the model's report.
  const InteractionReport all = test::ReportAt(*model, u.data()).interaction_report();
  EXPECT_NEAR(all.force[0], beside.force[0] + below.force[0], 1e-13);
  EXPECT_NEAR(all.force[1], beside.force[1] + below.force[1], 1e-13);
  EXPECT_EQ(all.least_gap, beside.least_gap);
}

TEST(InteractionGroupTest, ContactMeasuresAreThoseOfTheOwnSurface) {
  const auto model = cornered();
  const std::vector<double> u = shifted(*model, {0.15, -0.2});  // gaps 0.2 and 0.15
  EXPECT_NEAR(test::ReportAt(*model, u.data()).interaction("Floor").report().measure, 3, 1e-13);
  EXPECT_NEAR(test::ReportAt(*model, u.data()).interaction("Stop").report().measure, 2, 1e-13);
  const std::vector<double> apart = shifted(*model, {-0.5, -0.2});
  EXPECT_EQ(test::ReportAt(*model, apart.data()).interaction("Stop").report().measure, 0);
  EXPECT_NEAR(test::ReportAt(*model, apart.data()).interaction_report().measure, 3, 1e-13);
}

TEST(InteractionGroupTest, ASurfaceThatJoinsAnInteractionCounts) {
  const auto model = cornered();
  const std::vector<double> u = at_rest(*model);
  const std::vector<double> before = test::ReportAt(*model, u.data()).interaction("Floor").pressure();
  add_interaction(*model, wall("Floor", "top", {{0, 2.8, 0}, {0, -1, 0}}));
  const std::vector<double> after = test::ReportAt(*model, u.data()).interaction("Floor").pressure();
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    const bool top = std::abs(mesh.coordinates[2 * node + 1] - 2.4) < 1e-12;
    EXPECT_EQ(before[node], top ? 0 : after[node]);
    EXPECT_NEAR(after[node], top || mesh.coordinates[2 * node + 1] == 0.4 ? law.traction(0.4) : 0, 1e-13);
  }
}

TEST(InteractionGroupTest, MomentsInSpaceHaveThreeComponents) {
  auto model = test::model_of(block(3), test::elastic(linear_elastic, 0.2), Inertia::None);
  add_interaction(*model, wall("Floor", "bottom", {{0, 0, -0.5}, {0, 0, 1}}));
  const std::vector<double> u = shifted(*model, {0.1, 0.2, -0.05});
  const double up = 6 * law.traction(0.25);
  const std::vector<double> moment = test::ReportAt(*model, u.data()).interaction("Floor").moment();
  ASSERT_EQ(moment.size(), 3U);
  EXPECT_NEAR(moment[0], (0.4 + 1 + 0.2) * up, 1e-12);  // y F_z
  EXPECT_NEAR(moment[1], -(1.5 + 0.1) * up, 1e-12);
  EXPECT_NEAR(moment[2], 0, 1e-13);
}

TEST(InteractionGroupTest, AFactorWeighsForceAndMoment) {
  auto model = test::model_of(block(2), test::elastic(linear_elastic, 0.2), Inertia::None);
  SurfaceInteraction floor = wall("Floor", "bottom", {});
  floor.factor = [](const std::array<double, 3>& x) { return x[0]; };
  add_interaction(*model, floor);
  const std::vector<double> u = at_rest(*model);
  EXPECT_NEAR(test::ReportAt(*model, u.data()).interaction("Floor").report().force[1], 4.5 * law.traction(0.4), 1e-13);
  EXPECT_NEAR(test::ReportAt(*model, u.data()).interaction("Floor").moment()[0], 9 * law.traction(0.4), 1e-13);
}

std::vector<double> center(int dimension) {
  return dimension == 2 ? std::vector<double>{1, -2.1} : std::vector<double>{1, 1.2, -2.8};
}

/// The block on a sphere of radius 2 about center(); its bottom has the contact element.
std::unique_ptr<Model> on_sphere(int dimension, ContactElement element) {
  Mesh mesh = block(dimension);
  test::give_contact_element(mesh, "bottom", element);
  auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
  SurfaceInteraction sphere = wall("Sphere", "bottom", {});
  sphere.obstacle =
      make_obstacle("Sphere", static_cast<std::size_t>(dimension), {{"Radius", 2.0}, {"Center", center(dimension)}});
  add_interaction(*model, sphere);
  return model;
}

// Forces of a sphere point to its centre c, so their moment about the origin is c x F, whatever the displacement.
TEST(InteractionGroupTest, TheMomentAboutASpheresCentreIsZero) {
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1CH, ContactElement::Q2C2, ContactElement::Q2C4})
    for (const int dimension : {2, 3}) {
      const std::vector<double> c = center(dimension);
      const auto model = on_sphere(dimension, element);
      const std::vector<double> u = noise(*model, 0.02);
      const test::ReportAt report(*model, u.data());
      const InteractionGroup group = report.interaction("Sphere");
      const std::vector<double> f = group.report().force, moment = group.moment();
      if (dimension == 2) {
        EXPECT_NEAR(moment[0], c[0] * f[1] - c[1] * f[0], 1e-12);
      } else {
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          EXPECT_NEAR(moment[i], c[j] * f[k] - c[k] * f[j], 1e-12);
        }
      }
      EXPECT_GT(std::abs(f.back()), 1e-3);
    }
}

TEST(InteractionGroupTest, BodiesOfRevolutionHaveNoMoment) {
  Mesh mesh = block(2);
  mesh.axisymmetric = true;
  auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
  add_interaction(*model, wall("Floor", "bottom", {}));
  const std::vector<double> u = at_rest(*model);
  EXPECT_TRUE(test::ReportAt(*model, u.data()).interaction("Floor").moment().empty());
  EXPECT_NEAR(test::ReportAt(*model, u.data()).interaction("Floor").report().force[1], M_PI * 9 * law.traction(0.4),
              1e-12);
}

TEST(InteractionGroupTest, FieldsAreThoseOfTheOwnSurface) {
  const auto model = cornered();
  const std::vector<double> u = shifted(*model, {0.05, -0.1});
  const LocalMesh& mesh = model->mesh();
  const test::ReportAt report(*model, u.data());
  const InteractionGroup floor = report.interaction("Floor"), stop = report.interaction("Stop");
  const std::vector<double> gap = floor.gap(), pressure = stop.pressure();
  const std::vector<double> normal = stop.normal(), traction = floor.traction();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    const bool below = mesh.coordinates[2 * node + 1] == 0.4, beside = mesh.coordinates[2 * node] == 3;
    EXPECT_EQ(std::isnan(gap[node]), !below);
    if (below) {
      EXPECT_NEAR(gap[node], 0.3, 1e-15);
    }
    // The corner belongs to both surfaces; each has its own area there.
    EXPECT_NEAR(traction[2 * node], 0, 1e-14);
    EXPECT_NEAR(traction[2 * node + 1], below ? law.traction(0.3) : 0, 1e-13);
    EXPECT_NEAR(pressure[node], beside ? law.traction(0.25) : 0, 1e-13);
    EXPECT_EQ(normal[2 * node], beside ? -1 : 0);
    EXPECT_EQ(normal[2 * node + 1], 0);
  }
}

TEST(InteractionGroupTest, NormalsOfASpherePointFromItsCentre) {
  for (const int dimension : {2, 3}) {
    const std::vector<double> c = center(dimension);
    const auto model = on_sphere(dimension, ContactElement::Q1CH);
    const std::vector<double> u = noise(*model, 0.02);
    const std::vector<double> normal = test::ReportAt(*model, u.data()).interaction("Sphere").normal();
    const std::vector<double> gap = test::ReportAt(*model, u.data()).interaction("Sphere").gap();
    const LocalMesh& part = model->mesh();
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t node = 0; node < static_cast<std::size_t>(part.owned_nodes); ++node) {
      const bool there = !std::isnan(gap[node]) && !part.is_derivative(node);
      for (std::size_t i = 0; i < d; ++i) {
        const double x = part.coordinates[node * d + i] + u[node * d + i];
        EXPECT_NEAR(normal[node * d + i], there ? (x - c[i]) / (2 + gap[node]) : 0, 1e-14);
      }
    }
  }
}

// A sphere that moves by (0.03, 0.02) t and turns by 0.1 t about the origin.
TEST(InteractionGroupTest, MovedObstaclesAreSeenAtTheTimeOfTheState) {
  Mesh mesh = block(2);
  enrich(mesh, "bottom", ContactElement::Q1CH);
  auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
  SurfaceInteraction sphere = wall("Sphere", "bottom", {});
  sphere.obstacle = make_obstacle("Sphere", 2, {{"Radius", 2.0}, {"Center", {1.0, -2.1}}});
  RigidMotionOptions motion;
  const auto steady = [](double rate) {
    return function_of_time([rate](double t) { return TimeValue{rate * t, rate, 0}; });
  };
  motion.translation = {steady(0.03), steady(0.02)};
  motion.angle = steady(0.1);
  sphere.motion = RigidMotion(2, motion);
  add_interaction(*model, sphere);
  const double t = 1.5, angle = 0.1 * t;
  const double c[] = {0.03 * t + std::cos(angle) + 2.1 * std::sin(angle),
                      0.02 * t + std::sin(angle) - 2.1 * std::cos(angle)};
  const std::vector<double> u = noise(*model, 0.02);
  const test::ReportAt report(*model, u.data(), nullptr, t);
  const InteractionGroup group = report.interaction("Sphere");
  const std::vector<double> f = group.report().force, gap = group.gap(), n = group.normal();
  EXPECT_NEAR(group.moment()[0], c[0] * f[1] - c[1] * f[0], 1e-12);
  const LocalMesh& part = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(part.owned_nodes); ++node)
    for (std::size_t i = 0; i < 2; ++i) {
      const bool there = !std::isnan(gap[node]) && !part.is_derivative(node);
      const double x = part.coordinates[2 * node + i] + u[2 * node + i];
      EXPECT_NEAR(n[2 * node + i], there ? (x - c[i]) / (2 + gap[node]) : 0, 1e-14);
    }
}

TEST(InteractionGroupTest, ListsOfOneNameAreOneInteraction) {
  auto model = test::model_of(block(2), test::elastic(linear_elastic, 0.2), Inertia::None);
  for (const char* side_set : {"bottom", "top"}) add_interaction(*model, wall("Both", side_set, {}));
  EXPECT_EQ(model->interaction_names(), std::vector<std::string>{"Both"});
  const std::vector<double> u = at_rest(*model);
  EXPECT_EQ(test::ReportAt(*model, u.data()).interaction("Both").report().force,
            test::ReportAt(*model, u.data()).interaction_report().force);
}

TEST(InteractionGroupTest, UnknownNamesAreRefused) {
  const auto model = cornered();
  test::expect_contains(test::refusal([&] { test::ReportAt(*model, at_rest(*model).data()).interaction("Flor"); }),
                        "interaction \"Flor\" does not exist; did you mean \"Floor\"?");
}

}  // namespace
}  // namespace ixos

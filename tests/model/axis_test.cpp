#include "model/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "histories/time_function.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "model/conditions.hpp"
#include "model/surface_interaction.hpp"
#include "model/term_sums.hpp"
#include "support/contact_element.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

constexpr double radius = 3, height = 2;

/// A cylinder of radius 3 and height 2 on y = 0.4; its volume is 18 pi.
Mesh cylinder() {
  BoxShape shape;
  shape.lower = {0, 0.4, 0};
  shape.lengths = {radius, height, 0};
  shape.divisions = {6, 4, 1};
  Mesh mesh = box(shape);
  mesh.axisymmetric = true;
  return mesh;
}

std::unique_ptr<Model> body(const Mesh& mesh, Inertia inertia = Inertia::Consistent) {
  Material material = test::elastic(neo_hooke, 0.3);
  material.density = 0.7;
  return test::model_of(mesh, material, inertia);
}

std::vector<double> field(const Model& model, double radial, double axial) {
  std::vector<double> values = test::at_rest(model);
  for (std::size_t k = 0; k < values.size(); k += 2) {
    values[k] = radial * model.mesh().coordinates[k];
    values[k + 1] = axial;
  }
  return values;
}

TEST(AxisTest, NodesOnTheAxisAreHeldThere) {
  const auto model = body(cylinder());
  const LocalMesh& mesh = model->mesh();
  for (int node = 0; node < mesh.nodes(); ++node) {
    EXPECT_EQ(model->constraints().holds(2 * node), mesh.coordinates[2 * static_cast<std::size_t>(node)] == 0) << node;
    EXPECT_FALSE(model->constraints().holds(2 * node + 1));
  }
}

TEST(AxisTest, MassAndMomentaAreThoseOfTheWholeBody) {
  const double mass = 0.7 * M_PI * radius * radius * height;
  for (const Inertia inertia : {Inertia::Consistent, Inertia::Lumped}) {
    const auto model = body(cylinder(), inertia);
    const Momenta momenta = test::ReportAt(*model, test::at_rest(*model).data(), field(*model, 1, 2).data()).momenta();
    EXPECT_EQ(momenta.linear[0], 0);
    EXPECT_NEAR(momenta.linear[1], 2 * mass, 1e-12 * mass);
    EXPECT_EQ(momenta.angular[0], 0);
    // Half the integral of rho (R^2 + 4); a consistent mass is exact.
    if (inertia == Inertia::Consistent) {
      EXPECT_NEAR(momenta.kinetic_energy, 0.5 * mass * (radius * radius / 2 + 4), 1e-12 * mass);
    }
  }
}

TEST(AxisTest, LoadsAreThoseOfTheWholeBody) {
  const auto model = body(cylinder());
  const auto one = value_ramp(1.0, 0.0, 1.0, RampShape::Linear);
  add_traction(*model, "top", {0.0, 1.0}, one);
  add_traction(*model, "right", {1.0, 0.0}, one);
  add_gravity(*model, "", {0.0, -2.0}, one);
  add_body_force(*model, "", {0.0, 3.0}, one);
  const double area = M_PI * radius * radius, volume = area * height;
  const double expected[4][2] = {{0, area}, {2 * M_PI * radius * height, 0}, {0, -2 * 0.7 * volume}, {0, 3 * volume}};
  for (std::size_t load = 0; load < 4; ++load) {
    const std::vector<double>& forces = model->loads().forces(load);
    double sums[2] = {0, 0};
    for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(model->mesh().owned_nodes); ++k) sums[k % 2] += forces[k];
    model->space().sum(sums, 2);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(sums[i], expected[load][i], 1e-12 * volume) << load;
  }
  test::expect_contains(test::refusal([&] {
                          add_gravity(*model, "", {1.0, 0.0}, one);
                        }),
                        "gravity with the radial component 1");
}

TEST(AxisTest, AWallActsOnTheWholeDisk) {
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1CH, ContactElement::Q2C2, ContactElement::Q2C4}) {
    Mesh mesh = cylinder();
    if (element != ContactElement::Q1C1) test::give_contact_element(mesh, "bottom", element, 0);
    const auto model = body(mesh);
    SurfaceInteraction wall;
    wall.side_set = "bottom";
    wall.law = gap_law(VanDerWaals(2.5, 25));
    wall.obstacle = flat_wall({});
    add_interaction(*model, wall);
    const InteractionReport report = test::ReportAt(*model, test::at_rest(*model).data()).interaction_report();
    EXPECT_EQ(report.force[0], 0);
    EXPECT_NEAR(report.force[1], M_PI * radius * radius * VanDerWaals(2.5, 25).traction(0.4), 1e-13);
    EXPECT_NEAR(test::ReportAt(*model, test::at_rest(*model).data()).energy(Part::Interaction),
                M_PI * radius * radius * VanDerWaals(2.5, 25).energy(0.4), 1e-13);
  }
}

TEST(AxisTest, ASphereOnTheAxisActsOnRings) {
  const double ball = 5, gap = 0.4;
  const auto model = body(cylinder());
  SurfaceInteraction below;
  below.side_set = "bottom";
  below.law = gap_law(VanDerWaals(2.5, 25));
  below.obstacle = make_obstacle("Sphere", 2, {{"Center", {0.0, -ball}}, {"Radius", ball}});
  below.points = 20;
  add_interaction(*model, below);
  const InteractionReport report = test::ReportAt(*model, test::at_rest(*model).data()).interaction_report();
  // The axial force on a disk, by the midpoint rule.
  const int n = 200000;
  double force = 0;
  for (int k = 0; k < n; ++k) {
    const double r = radius * (k + 0.5) / n, distance = std::hypot(r, ball + gap);
    force += 2 * M_PI * r * radius / n * VanDerWaals(2.5, 25).traction(distance - ball) * (ball + gap) / distance;
  }
  EXPECT_NEAR(report.force[1], force, 1e-9 * std::abs(force));
  // The nodal force is the gradient of the energy.
  std::vector<double> u = field(*model, 0.02, 0.01);
  const std::vector<double> way = field(*model, 1, -0.3);
  const std::vector<double> f = test::ReportAt(*model, u.data()).nodal_force(Part::Interaction);
  double slope = 0, difference = 0;
  for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(model->mesh().owned_nodes); ++k) slope += f[k] * way[k];
  model->space().sum(&slope, 1);
  const double h = 1e-5;
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> moved = u;
    for (std::size_t k = 0; k < u.size(); ++k) moved[k] += sign * h * way[k];
    difference += sign * test::ReportAt(*model, moved.data()).energy(Part::Interaction) / (2 * h);
  }
  EXPECT_NEAR(slope, difference, 1e-7 * std::abs(slope));
}

TEST(AxisTest, WhatIsNotCoaxialIsRefused) {
  const auto model = body(cylinder());
  const auto message = [&](const std::shared_ptr<const Obstacle>& obstacle) {
    SurfaceInteraction wall;
    wall.side_set = "bottom";
    wall.law = gap_law(VanDerWaals(2.5, 25));
    wall.obstacle = obstacle;
    return test::refusal([&] { add_interaction(*model, wall); });
  };
  test::expect_contains(message(flat_wall({{0.0, -9.0, 0.0}, {0.6, 0.8, 0.0}})), "no body of revolution");
  test::expect_contains(message(make_obstacle("Sphere", 2, {{"Center", {0.1, -9.0}}, {"Radius", 5.0}})),
                        "no body of revolution");
  EXPECT_FALSE(model->has_interactions());
}

TEST(AxisTest, ViscousPowerOfAHomogeneousRate) {
  // The rate of strain is diag(s, t, s): the power is V (2 mu (2 s^2 + t^2) + lambda (2 s + t)^2) times the viscosity.
  Material material = test::elastic(neo_hooke, 0.3);
  material.viscosity = 0.2;
  const auto model = test::model_of(cylinder(), material, Inertia::Consistent);
  const double s = 0.3, t = -0.5, volume = M_PI * radius * radius * height;
  std::vector<double> v = field(*model, s, 0);
  for (std::size_t k = 1; k < v.size(); k += 2) v[k] = t * model->mesh().coordinates[k];
  std::vector<double> f = test::at_rest(*model);
  TermSums(*model).add_rate_force_at(1, test::at_rest(*model).data(), v.data(), f.data());
  double power = 0;
  for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(model->mesh().owned_nodes); ++k) power += f[k] * v[k];
  model->space().sum(&power, 1);
  const Lame lame = lame_constants(1, 0.3);
  const double expected = 0.2 * volume * (2 * lame.mu * (2 * s * s + t * t) + lame.lambda * (2 * s + t) * (2 * s + t));
  EXPECT_NEAR(power, expected, 1e-12 * expected);
}

TEST(AxisTest, NodesBeyondTheAxisAreRefused) {
  Mesh mesh = cylinder();
  mesh.coordinates[0] = -0.1;
  test::expect_contains(test::refusal([&] { check_cells(mesh); }), "node 1 at (-0.1, 0.4) is beyond the axis");
  mesh.coordinates[0] = -1e-13;
  EXPECT_NO_THROW(check_cells(mesh));
  BoxShape shape;
  shape.dimension = 3;
  Mesh solid = box(shape);
  solid.axisymmetric = true;
  test::expect_contains(test::refusal([&] { check_cells(solid); }), "this mesh has 3");
}

}  // namespace
}  // namespace ixos

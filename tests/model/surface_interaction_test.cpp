#include "model/surface_interaction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>

#include "interaction/area_factor.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/contact_element.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

/// A plate of 3 by 2 L0 whose bottom is at y = 0.4.
Mesh plate_mesh() {
  BoxShape shape;
  shape.lower = {0, 0.4, 0};
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  return box(shape);
}

std::unique_ptr<Model> plate() {
  return test::model_of(plate_mesh(), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
}

SurfaceInteraction wall_below() {
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = flat_wall({});
  return wall;
}

TEST(SurfaceInteractionTest, AParallelSurfaceFeelsTheTractionOfItsGap) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.name = "floor";
  add_interaction(*model, wall);
  const std::vector<double> rest = test::at_rest(*model);
  const InteractionReport report = test::ReportAt(*model, rest.data()).interaction_report();
  EXPECT_NEAR(report.force[0], 0, 1e-15);
  EXPECT_NEAR(report.force[1], 3 * VanDerWaals(2.5, 25).traction(0.4), 1e-14);
  EXPECT_NEAR(report.least_gap, 0.4, 1e-15);
  EXPECT_EQ(model->force_terms().back().name, "floor");
}

TEST(SurfaceInteractionTest, LawsOnOneSurfaceAddUp) {
  auto model = plate();
  const auto attraction = make_gap_law("Smooth Dugdale", {{"Constants", "Range"}, {"Range", 0.5}});
  const auto repulsion = make_gap_law("Penalty", {{"Gap", 0.41}});
  for (const auto& law : {attraction, repulsion}) {
    SurfaceInteraction wall = wall_below();
    wall.law = law;
    add_interaction(*model, wall);
  }
  const std::vector<double> rest = test::at_rest(*model);
  EXPECT_NEAR(test::ReportAt(*model, rest.data()).interaction_report().force[1],
              3 * (attraction->traction(0.4)[0] + repulsion->traction(0.4)[0]), 1e-14);
  EXPECT_NEAR(test::ReportAt(*model, rest.data()).energy(Part::Interaction),
              3 * (attraction->energy(0.4)[0] + repulsion->energy(0.4)[0]), 1e-15);
  EXPECT_LT(attraction->traction(0.4)[0], 0);
  EXPECT_GT(repulsion->traction(0.4)[0], 0);
}

TEST(SurfaceInteractionTest, AFactorScalesTheLawOverTheSurface) {
  for (const bool curved : {false, true}) {
    auto model = plate();
    SurfaceInteraction wall = wall_below();
    if (curved) wall.obstacle = make_obstacle("Sphere", 2, {{"Radius", 1e7}, {"Center", {0.0, -1e7}}});
    wall.factor = [](const std::array<double, 3>& x) { return x[0] * x[0] + x[1] - 0.4 + x[2]; };  // x^2 on the bottom
    add_interaction(*model, wall);
    const std::vector<double> rest = test::at_rest(*model);
    const InteractionReport report = test::ReportAt(*model, rest.data()).interaction_report();
    const VanDerWaals law(2.5, 25);
    const double slack = curved ? 1e-6 : 1e-13;
    EXPECT_NEAR(report.force[1], 9 * law.traction(0.4), slack);
    EXPECT_NEAR(test::ReportAt(*model, rest.data()).energy(Part::Interaction), 9 * law.energy(0.4), slack);
    std::vector<double> down = rest;
    for (std::size_t k = 1; k < down.size(); k += 2) down[k] = -0.15;
    EXPECT_NEAR(test::ReportAt(*model, down.data()).interaction_report().measure, 3, 1e-13) << "an area";
  }
}

TEST(SurfaceInteractionTest, FactorsThatAreNoneAreRefused) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.factor = [](const std::array<double, 3>& x) { return 1.1 - x[0]; };
  test::expect_contains(test::refusal([&] { add_interaction(*model, wall); }), "the factor at (");
  test::expect_contains(test::refusal([&] { add_interaction(*model, wall); }), "it must be finite and at least 0");
  wall.factor = [](const std::array<double, 3>&) { return std::nan(""); };
  test::expect_contains(test::refusal([&] { add_interaction(*model, wall); }), "is nan; it must be finite");
}

// x at the nodes, linear between them whatever the contact element: int x T dx and int x 2 x T dx over 0 to 3.
TEST(SurfaceInteractionTest, ANodalFactorIsLinearBetweenCorners) {
  const VanDerWaals law(2.5, 25);
  for (const bool curved : {false, true})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C3, ContactElement::Q1CH,
                                         ContactElement::Q2C2, ContactElement::Q2C4}) {
      Mesh mesh = plate_mesh();
      test::give_contact_element(mesh, "bottom", element);
      auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::Consistent);
      SurfaceInteraction wall = wall_below();
      if (curved) wall.obstacle = make_obstacle("Sphere", 2, {{"Radius", 1e7}, {"Center", {0.0, -1e7}}});
      const LocalMesh& part = model->mesh();
      for (std::size_t node = 0; node < static_cast<std::size_t>(part.nodes()); ++node)
        wall.nodal_factor.push_back(part.is_added(node) ? std::nan("") : part.coordinates[2 * node]);
      wall.name = "once";
      add_interaction(*model, wall);
      wall.factor = [](const std::array<double, 3>& x) { return 2 * x[0]; };
      wall.name = "twice";
      add_interaction(*model, wall);
      const std::vector<double> rest = test::at_rest(*model);
      const double slack = curved ? 3e-6 : 1e-12;
      EXPECT_NEAR(test::ReportAt(*model, rest.data()).interaction("once").report().force[1], 4.5 * law.traction(0.4),
                  slack);
      EXPECT_NEAR(test::ReportAt(*model, rest.data()).interaction("twice").report().force[1], 18 * law.traction(0.4),
                  slack);
    }
}

TEST(SurfaceInteractionTest, NodalFactorsThatAreNoneAreRefused) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  const LocalMesh& part = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(part.nodes()); ++node)
    wall.nodal_factor.push_back(part.coordinates[2 * node] - 0.25);  // node 1 is the corner at x = 0
  const auto message = [&] { return test::refusal([&] { add_interaction(*model, wall); }); };
  test::expect_contains(message(), "the factor at node 1 of the mesh, on the surface \"bottom\", is -0.25");
  for (double& value : wall.nodal_factor) value = 1;
  EXPECT_EQ(message(), "");
  wall.nodal_factor.pop_back();
  test::expect_contains(message(), "the nodal factor of the surface \"bottom\" has");
  EXPECT_EQ(model->interaction_names().size(), 1U);
}

TEST(SurfaceInteractionTest, NothingActsBeyondTheCutoff) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.cutoff = 0.35;
  add_interaction(*model, wall);
  EXPECT_EQ(test::ReportAt(*model, test::at_rest(*model).data()).interaction_report().force[1], 0);
}

TEST(SurfaceInteractionTest, UnsoundOnesAreRefused) {
  auto model = plate();
  const auto message = [&](const std::function<void(SurfaceInteraction&)>& spoil) {
    SurfaceInteraction wall = wall_below();
    spoil(wall);
    return test::refusal([&] { add_interaction(*model, wall); });
  };
  test::expect_contains(message([](SurfaceInteraction& i) { i.law = nullptr; }),
                        "the interaction of the surface \"bottom\" is not allowed: Law is missing");
  test::expect_contains(message([](SurfaceInteraction& i) { i.obstacle = nullptr; }), "has no obstacle");
  test::expect_contains(message([](SurfaceInteraction& i) { i.side_set = "botom"; }), "did you mean \"bottom\"?");
  test::expect_contains(message([](SurfaceInteraction& i) { i.cutoff = 0.3; }), "0.3 cuts off the attraction");
  test::expect_contains(message([](SurfaceInteraction& i) { i.cutoff = -1; }), "-1 cuts off the attraction");
  test::expect_contains(message([](SurfaceInteraction& i) { i.points = 65; }), "Surface Points 65");
  test::expect_contains(message([](SurfaceInteraction& i) { i.margin = 1; }), "Step Margin 1");
  test::expect_contains(message([](SurfaceInteraction& i) {
                          i.obstacle = flat_wall({{0.0, 0.5, 0.0}, {0.0, 1.0, 0.0}});
                        }),
                        "the surface \"bottom\" starts in or below the wall, least gap -0.1");
  EXPECT_FALSE(model->has_interactions());
}

TEST(SurfaceInteractionTest, ALawMustEndWithinTheReachOfTheObstacle) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  const double reach = 1 / (0.1 * M_PI * M_PI / 4);  // 1/(A k^2) = 4.05285
  wall.obstacle = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.1}, {"Period", 4.0}});
  const auto message = [&] { return test::refusal([&] { add_interaction(*model, wall); }); };
  test::expect_contains(message(), "smooth up to 4.05285 only");
  wall.cutoff = 1.001 * reach;
  test::expect_contains(message(), "a Cutoff of at most 4.05285, or the Gap \"Vertical\"");
  wall.cutoff = 0.999 * reach;
  EXPECT_EQ(message(), "");
  wall.cutoff = 0;
  wall.obstacle = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.1}, {"Period", 4.0}, {"Gap", "Vertical"}});
  EXPECT_EQ(message(), "");
}

// The vertical gap is exact for a flat body over waves: the traction's mean over a period, by the rectangle rule.
TEST(SurfaceInteractionTest, AFlatBodyFeelsTheMeanTractionOfTheHeights) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.points = 20;
  wall.obstacle = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.05}, {"Period", 3.0}, {"Gap", "Vertical"}});
  add_interaction(*model, wall);
  double mean = 0;
  for (int k = 0; k < 100; ++k) mean += VanDerWaals(2.5, 25).traction(0.4 - 0.05 * std::cos(2 * M_PI * k / 100)) / 100;
  EXPECT_NEAR(test::ReportAt(*model, test::at_rest(*model).data()).interaction_report().force[1], 3 * mean, 1e-12);
}

// h = 0.05 cos(2 pi x/3), and the gap's gradient (-h', 1) is longer than 1.
TEST(SurfaceInteractionTest, NormalsOfAVerticalGapAreUnitVectors) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.name = "floor";
  wall.obstacle = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.05}, {"Period", 3.0}, {"Gap", "Vertical"}});
  add_interaction(*model, wall);
  const std::vector<double> normal = test::ReportAt(*model, test::at_rest(*model).data()).interaction("floor").normal();
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    if (mesh.coordinates[2 * node + 1] > 0.41) continue;
    const double wave = 2 * M_PI / 3, slope = -0.05 * wave * std::sin(wave * mesh.coordinates[2 * node]);
    EXPECT_NEAR(normal[2 * node], -slope / std::hypot(1, slope), 1e-14);
    EXPECT_NEAR(normal[2 * node + 1], 1 / std::hypot(1, slope), 1e-14);
  }
}

TEST(SurfaceInteractionTest, AnObstacleMayAskForAnAreaFactor) {
  const auto energy = [](bool with_factor) {
    auto model = plate();
    SurfaceInteraction wall = wall_below();
    // A cylinder so large that the gap is 0.4 all over, and whose factor is that of g/R = 4e-7.
    wall.obstacle =
        make_obstacle("Cylinder", 2, {{"Radius", 1e6}, {"Center", {1.5, -1e6}}, {"Area Factor", with_factor}});
    add_interaction(*model, wall);
    return model->force_terms().back().term->energy({test::at_rest(*model).data()});
  };
  EXPECT_NEAR(energy(true) / energy(false) - 1, -0.2e-6, 1e-9);
}

TEST(SurfaceInteractionTest, ASurfaceBeyondTheEdgeOfAFieldIsRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path() + "/flat.txt";
  std::ofstream(path) << "0 0 0 0 0\n";
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  const auto message = [&](double x) {
    wall.obstacle =
        make_obstacle("Height Field", 2, {{"File", path.c_str()}, {"Spacing", {1.0, 1.0}}, {"Point", {x, 0.0}}});
    return test::refusal([&] { add_interaction(*model, wall); });
  };
  for (const char* law : {"Van der Waals", "Morse"}) {
    wall.law = make_gap_law(law);
    EXPECT_EQ(message(1.5), "");  // from -0.5 to 3.5
    test::expect_contains(message(0.5),
                          "the surface \"bottom\" starts beyond the edge of the obstacle, at the place (");
  }
}

}  // namespace
}  // namespace ixos

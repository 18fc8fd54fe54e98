#include "scene/examine/characteristic_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/connected_parts.hpp"
#include "mesh/selection.hpp"
#include "parameters/validation.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/simulation.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr double work = 0.01549567, strength = 0.0624428, gap = 0.2547093;  // of the default law, closed forms

TEST(CharacteristicNumbersTest, TheBallsAreClosedForms) {
  const Simulation simulation(test::scene_file("ball.xml"), test::self());
  const CharacteristicNumbers& numbers = simulation.characteristic_numbers();
  ASSERT_EQ(numbers.bodies.size(), 1U);
  ASSERT_EQ(numbers.surfaces.size(), 1U);
  const BodyNumbers& body = numbers.bodies[0];
  const SurfaceNumbers& surface = numbers.surfaces[0];
  EXPECT_EQ(body.name, "Ball");
  EXPECT_NEAR(body.modulus, 1, 1e-14);
  EXPECT_NEAR(body.plane_modulus, 1 / 0.96, 1e-14);
  EXPECT_NEAR(body.wave_speed, std::sqrt((0.8 / (1.2 * 0.6)) / 5e-7), 1e-9);  // E (1 - nu)/((1 + nu)(1 - 2 nu))
  EXPECT_NEAR(body.size, 10, 1e-12);
  EXPECT_NEAR(body.crossing_time, 10 / body.wave_speed, 1e-15);
  EXPECT_NEAR(surface.work, work, 1e-8);
  EXPECT_NEAR(surface.peak_traction, strength, 1e-7);
  EXPECT_NEAR(surface.equilibrium_gap, gap, 1e-7);
  EXPECT_NEAR(surface.elastic_length, work, 1e-8);
  EXPECT_NEAR(surface.face_length, 10 * std::sin(M_PI / 16), 1e-12);  // chords of a polygon of 16 sides
  EXPECT_NEAR(surface.cohesive_zone, work / 0.96 / (strength * strength), 1e-4);
  EXPECT_NEAR(surface.radius, 5, 1e-12);
  EXPECT_NEAR(surface.tabor, std::cbrt(5 * work * work * 0.96 * 0.96 / (gap * gap * gap)), 1e-5);
  EXPECT_NEAR(surface.attraction_speed, std::sqrt(2 * work / 5e-6), 1e-3);
  EXPECT_NEAR(surface.gap_crossing_time, gap / std::sqrt(2 * work / 5e-6), 1e-8);
  EXPECT_NEAR(surface.least_gap, gap + 2, 1e-6);  // a node stands at the lowest point
}

TEST(CharacteristicNumbersTest, EachPartHasItsOwnCurvature) {
  const auto disk = [](double diameter, double x) {
    return test::list("Disk", test::number("Diameter", diameter)) + test::numbers("Translation", {x, 10});
  };
  const auto block = [](const std::string& name) { return test::list(name, test::word("Block", name + "_body")); };
  const auto wall = [](const std::string& name, const std::string& set) {
    return test::list(name, test::word("Side Set", set));
  };
  const Simulation simulation(
      test::scene(
          test::list("Mesh", test::word("Type", "Parts") +
                                 test::list("Parts", test::list("small", disk(4, 0)) +
                                                         test::list("box", test::word("Type", "Box") +
                                                                               test::numbers("Translation", {50, 1})) +
                                                         test::list("large", disk(10, 20)))) +
          test::list("Materials", block("small") + block("box") + block("large")) +
          test::list("Interactions",
                     wall("A", "large_surface") + wall("B", "box_bottom") + wall("C", "small_surface")) +
          test::time_integrator("Newmark", 0.01, 1)),
      test::self());
  const std::vector<SurfaceNumbers>& surfaces = simulation.characteristic_numbers().surfaces;
  ASSERT_EQ(surfaces.size(), 3U);
  EXPECT_NEAR(surfaces[0].radius, 5, 1e-12);
  EXPECT_EQ(surfaces[1].radius, SurfaceNumbers().radius);
  EXPECT_NEAR(surfaces[2].radius, 2, 1e-12);
}

/// A map makes the sphere of radius 1000 L0 from a box: its nodes alone tell the radius.
TEST(CharacteristicNumbersTest, TheRadiusOfAMappedSphereIsThatOfItsNodes) {
  const Simulation sphere(test::scene_file("jkr.xml"), test::world());
  EXPECT_NEAR(sphere.characteristic_numbers().surfaces[0].radius, 1000, 20);
  EXPECT_NEAR(sphere.characteristic_numbers().surfaces[0].tabor, 1, 0.05);
  const Simulation fine(
      test::scene_file("jkr.xml", {"Mesh/Refine/Contact/Levels=4", "Mesh/Refine/Contact/Upper={10, 0.5}"}),
      test::world());
  EXPECT_NEAR(fine.characteristic_numbers().surfaces[0].radius, 1000, 20);
  const Simulation flat(test::scene_file("strip.xml"), test::world());
  EXPECT_EQ(flat.characteristic_numbers().surfaces[0].radius, 0);
}

TEST(CharacteristicNumbersTest, TheTaborNumberOfASphereBeforeAFlatBody) {
  // 1.8848 at R = 500 and 0.8748 at R = 50 for nu = 0.2.
  for (const auto& [radius, tabor] : {std::pair{50.0, 0.8748}, std::pair{500.0, 1.8848}}) {
    const std::string r = std::to_string(radius);
    const Simulation simulation(
        test::scene_file("strip.xml",
                         {"Interactions/Wall/Obstacle=Sphere", "Interactions/Wall/Sphere/Radius=" + r,
                          "Interactions/Wall/Sphere/Center={0, -" + r + "}", "Mesh/Box/Divisions={40, 2}"}),
        test::self());
    EXPECT_NEAR(simulation.characteristic_numbers().surfaces[0].radius, radius, 1e-9 * radius);
    EXPECT_NEAR(simulation.characteristic_numbers().surfaces[0].tabor, tabor, 1e-4);
  }
}

TEST(CharacteristicNumbersTest, ThinPlatesHaveAShorterZone) {
  // A constant traction over l has the moment s0 l^2/2, and M^2 = 2 W E* h^3/12.
  const double thin = 0.5, zone = cohesive_zone(1, work, strength, thin);
  const double moment = strength * zone * zone / 2;
  EXPECT_NEAR(moment * moment, 2 * work * thin * thin * thin / 12, 1e-15);
  EXPECT_NEAR(cohesive_zone(1, work, strength, 100), work / (strength * strength), 1e-12);
  EXPECT_EQ(cohesive_zone(1, 0, 0, 1), 0);
}

TEST(CharacteristicNumbersTest, TheThicknessIsThatOfTheBodyAlongTheNormal) {
  const Simulation slice(
      test::scene_file("block-on-wall.xml", {"Mesh/Box/Lengths={32, 1, 16}", "Mesh/Box/Divisions={32, 1, 16}"}),
      test::self());
  const SurfaceNumbers& surface = slice.characteristic_numbers().surfaces.at(0);
  EXPECT_NEAR(surface.thickness, 16, 1e-12) << "not the width of the slice";
  EXPECT_EQ(slice.characteristic_numbers().bodies.at(0).size, 32);
}

TEST(CharacteristicNumbersTest, BlocksThatAreConnectedAreOneBody) {
  Teuchos::ParameterList list =
      validated(test::scene_file("strip.xml", {"Mesh/Box/Divisions={40, 4}"}), scene_parameters());
  const SceneNode scene(list, "");
  const auto materials = read_materials(scene.sublist("Materials"));
  const auto interactions = read_interactions(scene.sublist("Interactions"));
  Mesh mesh = scene_mesh(list.sublist("Mesh"), ".");
  std::vector<int>& nodes = mesh.blocks.at(0).nodes;  // row by row of cells: the upper half becomes a block of its own
  const auto half = nodes.begin() + static_cast<std::ptrdiff_t>(nodes.size() / 2);
  const ElementBlock backing{"backing", mesh.blocks[0].type, {half, nodes.end()}};
  nodes.erase(half, nodes.end());
  mesh.blocks.push_back(backing);
  mesh.side_sets = {side_set_named(mesh, "contact")};  // the others lie on the upper half, too
  const CharacteristicNumbers numbers =
      characteristic_numbers(scene, materials, interactions, mesh, connected_parts(mesh));
  EXPECT_NEAR(numbers.surfaces.at(0).thickness, 10, 1e-12);
  EXPECT_EQ(numbers.surfaces.at(0).interaction, 0U);
}

TEST(CharacteristicNumbersTest, AColumnOfTheGravityLengthHasTheStressEAtItsFoot) {
  EXPECT_NEAR(gravity_length(2e6, 1000 * 9.81), 203.87, 0.01);  // soft rubber: 204 m
}

TEST(CharacteristicNumbersTest, ACutoffTakesWorkAway) {
  const auto of = [](const std::string& cutoff) {
    const Simulation simulation(
        test::scene_file("strip.xml", {"Interactions/Wall/Cutoff=" + cutoff, "Mesh/Box/Divisions={40, 2}"}),
        test::self());
    return simulation.characteristic_numbers().surfaces[0].work;
  };
  EXPECT_LT(of("1"), of("2"));
  EXPECT_LT(of("2"), of("0"));
}

}  // namespace
}  // namespace ixos

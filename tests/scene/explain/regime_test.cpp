#include "scene/explain/regime.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/explain/si_explanation.hpp"
#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

/// A flat surface of size 1 on a bulky body with E* = 1.
SurfaceNumbers flat(double work, double strength) {
  SurfaceNumbers surface;
  surface.work = work;
  surface.peak_traction = strength;
  surface.cohesive_zone = cohesive_zone(1, work, strength, 1e6);
  surface.extent = 1;
  return surface;
}

TEST(RegimeTest, TheZoneAgainstTheSurfaceDecides) {
  EXPECT_EQ(regime(flat(1e-3, 0.01)), Regime::FlawTolerant);  // E* W/s0^2 = 10
  EXPECT_EQ(regime(flat(1e-3, 0.06)), Regime::Between);       // 0.28
  EXPECT_EQ(regime(flat(1e-3, 0.2)), Regime::Brittle);        // 0.025
}

TEST(RegimeTest, TheLeastStrengthHasAZoneOfATenth) {
  const double strength = least_strength(flat(1e-3, 0.2));
  EXPECT_LT(strength, 0.2);
  EXPECT_NEAR(flat(1e-3, strength).cohesive_zone, 0.1, 1e-12);
}

TEST(RegimeTest, RoundSurfacesGoByTheirTaborNumber) {
  SurfaceNumbers ball = flat(1e-3, 0.2);
  ball.radius = 5;
  for (const auto& [tabor, words] :
       {std::pair(0.05, "the limit of DMT"), {1.0, "both count"}, {7.0, "the limit of JKR"}}) {
    ball.tabor = tabor;
    test::expect_contains(regime_in_words(ball), words);
  }
  EXPECT_EQ(regime_in_words(SurfaceNumbers()), "");
}

// The scenes state radius and Tabor's number of a rigid plane before a body with the reduced radius and modulus.
TEST(RegimeTest, PairsGoByTheReducedRadiusAndModulus) {
  for (const auto& [file, tabor] : {std::pair("jkr-spheres.xml", 1.0), {"cylinders.xml", 3.0}}) {
    const Simulation simulation(read_scene_file(std::string(IXOS_XML_DIRECTORY) + "/" + file), test::world());
    const SurfaceNumbers& pair = simulation.characteristic_numbers().pairs.at(0);
    EXPECT_NEAR(pair.radius, 500, 1) << file;
    EXPECT_NEAR(pair.tabor, tabor, 0.005 * tabor) << file;
  }
  Teuchos::ParameterList balls = read_scene_file(std::string(IXOS_XML_DIRECTORY) + "/two-balls.xml");
  const Simulation simulation(balls, test::world());
  const SurfaceNumbers& pair = simulation.characteristic_numbers().pairs.at(0);
  EXPECT_NEAR(pair.elastic_length, 2 * pair.work / simulation.characteristic_numbers().bodies.at(0).modulus, 1e-12);
  EXPECT_NEAR(pair.radius, 2.5, 1e-9);
  EXPECT_GT(pair.normal[0], 0.8);
}

TEST(RegimeTest, FlatPairsGoByTheZoneOfBothBodies) {
  using test::counts, test::list, test::number, test::numbers, test::word;
  const auto part = [](const std::string& name, const std::vector<double>& lower, const std::vector<double>& lengths,
                       const std::vector<int>& divisions) {
    return list(name, word("Type", "Box") + list("Box", numbers("Lower", lower) + numbers("Lengths", lengths) +
                                                            counts("Divisions", divisions)));
  };
  const auto material = [](const std::string& block, double modulus) {
    return list(block, word("Block", block + "_body") + number("Young's Modulus", modulus) +
                           number("Poisson's Ratio", 0) + number("Density", 1));
  };
  const auto scene = [&](const std::string& primary) {
    return test::scene(
        list("Mesh", word("Type", "Parts") + list("Parts", part("film", {0, 1.3}, {1, 0.5}, {4, 2}) +
                                                               part("block", {-0.4, 0}, {2, 1}, {5, 2}) +
                                                               part("post", {3, 0}, {1, 3}, {1, 3}))) +
        list("Materials", material("film", 100) + material("block", 1) + material("post", 1)) +
        list("Interactions", list("Pair", word("Side Set", "film_bottom") + word("Primary Side Set", primary))) +
        test::time_integrator("Newmark", 0.1, 1));
  };
  const Simulation simulation(scene("block_top"), test::world());
  const SurfaceNumbers& pair = simulation.characteristic_numbers().pairs.at(0);
  const double modulus = 1 / (1 / 100.0 + 1), softness = 1 / (100 * 0.125) + 1;
  EXPECT_NEAR(pair.thickness, 1 / std::cbrt(modulus * softness), 1e-12);
  EXPECT_NEAR(pair.elastic_length, pair.work * 1.01, 1e-15);
  EXPECT_NEAR(pair.extent, 1, 1e-12);
  EXPECT_NEAR(pair.largest_gap - pair.least_gap, 0, 1e-12);
  EXPECT_NEAR(pair.cohesive_zone, cohesive_zone(modulus, pair.work, pair.peak_traction, pair.thickness), 1e-15);
  EXPECT_EQ(pair.radius, 0);
  test::expect_contains(regime_in_words(pair), "the cohesive zone is");
  const Simulation away(scene("post_left"), test::world());
  test::expect_contains(explain_numbers(away), "Pair: two surfaces of one part, or that do not face each other");
}

TEST(RegimeTest, AnElectrodeHasNone) {
  const Simulation simulation(
      test::scene(test::list("Mesh", test::word("Type", "Box")) +
                  test::list("Materials", test::list("Body", test::number("Density", 1))) +
                  test::list("Interactions",
                             test::list("Wall", test::word("Side Set", "bottom") + test::numbers("Point", {0, -1}) +
                                                    test::word("Law", "Electrostatic") +
                                                    test::list("Electrostatic", test::number("Voltage", 0.1) +
                                                                                    test::number("Permittivity", 1) +
                                                                                    test::number("Insulation", 0.1)))) +
                  test::time_integrator("Newmark", 0.1, 1)),
      test::world());
  const SurfaceNumbers& electrode = simulation.characteristic_numbers().surfaces.at(0);
  EXPECT_GT(electrode.work, 0);
  EXPECT_EQ(regime_in_words(electrode), "");
  EXPECT_EQ(explain_numbers(simulation).find("cohesive zone"), std::string::npos);
}

TEST(RegimeTest, ExtentsAreThoseOfTheFace) {
  const auto extent = [](const std::string& mesh, const std::string& set, const std::string& normal) {
    const Simulation simulation(
        test::scene(mesh + test::list("Materials", test::list("Body", test::number("Density", 1))) +
                    test::list("Interactions", test::list("Wall", test::word("Side Set", set) + normal)) +
                    test::time_integrator("Newmark", 0.1, 1)),
        test::world());
    return simulation.characteristic_numbers().surfaces.at(0).extent;
  };
  const auto box = [](const std::vector<double>& lengths, const std::vector<int>& divisions,
                      const std::string& more = "") {
    return test::list(
        "Mesh", test::word("Type", "Box") + more +
                    test::list("Box", test::count("Dimension", static_cast<int>(lengths.size())) +
                                          test::numbers("Lengths", lengths) + test::counts("Divisions", divisions)));
  };
  const std::string below = test::numbers("Point", {0, -1});
  EXPECT_NEAR(extent(box({4, 2}, {4, 2}), "bottom", below), 4, 1e-12);
  EXPECT_NEAR(extent(box({4, 2}, {4, 2}), "left", test::numbers("Point", {-1, 0}) + test::numbers("Normal", {1, 0})), 2,
              1e-12);
  const std::string turned =
      test::list("Map", test::word("X", "x*cos(0.4) - y*sin(0.4)") + test::word("Y", "x*sin(0.4) + y*cos(0.4)"));
  EXPECT_NEAR(extent(box({4, 2}, {4, 2}, turned), "bottom",
                     test::numbers("Point", {std::sin(0.4), -std::cos(0.4)}) +
                         test::numbers("Normal", {-std::sin(0.4), std::cos(0.4)})),
              4, 1e-12);
  EXPECT_NEAR(extent(box({4, 3, 2}, {4, 3, 2}), "bottom",
                     test::numbers("Point", {0, 0, -1}) + test::numbers("Normal", {0, 0, 1})),
              3, 1e-12);
  EXPECT_NEAR(extent(box({4, 2}, {4, 2}, test::word("Geometry", "Axisymmetric")), "bottom", below), 4, 1e-12);
}

}  // namespace
}  // namespace ixos

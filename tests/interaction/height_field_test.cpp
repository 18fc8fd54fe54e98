// The obstacle "Height Field", and its surface.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle_fixture.hpp"
#include "interaction/spline_surface.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

using test::Point;

constexpr double period = 8, k = 2 * M_PI / period;

/// Writes one period of A cos(k x) [cos(k y)] as a text, with a crest at the origin; returns its path.
std::string wave_file(const std::string& folder, double amplitude, int samples, bool both) {
  const std::string path = folder + "/waves" + std::to_string(samples) + (both ? "xy" : "x") + ".txt";
  std::ofstream file(path);
  file.precision(17);
  const double distance = period / samples, start = -0.5 * distance * (samples - 1);
  for (int j = 0; j < (both ? samples : 1); ++j) {
    for (int i = 0; i < samples; ++i)
      file << amplitude * std::cos(k * (start + i * distance)) * (both ? std::cos(k * (start + j * distance)) : 1.0)
           << ' ';
    file << '\n';
  }
  return path;
}

class HeightFieldTest : public testing::Test {
 protected:
  std::shared_ptr<const Obstacle> field(std::size_t dimension, double amplitude, bool both, const Settings& more = {},
                                        int samples = 128) {
    const double distance = period / samples;
    Settings settings{{"File", wave_file(folder_.path(), amplitude, samples, both).c_str()},
                      {"Spacing", {distance, distance}},
                      {"Periodic", true}};
    settings.insert(settings.end(), more.begin(), more.end());
    return make_obstacle("Height Field", dimension, settings);
  }
  test::TemporaryFolder folder_;
};

TEST_F(HeightFieldTest, AFieldOfOneWaveIsASineWall) {
  const auto wall = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.5}, {"Period", period}});
  const auto rough = field(2, 0.5, false);
  const auto rough_in_space = field(3, 0.5, false);
  EXPECT_NEAR(rough->reach(), wall->reach(), 1e-3 * wall->reach());
  test::RandomPoints points({-30, 0.6, 0}, {30, 2.5, 0});
  for (int i = 0; i < 100; ++i) {
    const Point x = points();
    const ObstacleGap a = wall->at(test::packed(x)), b = rough->at(test::packed(x));
    const ObstacleGap c = rough_in_space->at(test::packed({x[0], 17, x[1]}));
    EXPECT_NEAR(a.gap[0], b.gap[0], 1e-7);
    EXPECT_NEAR(a.normal[0][0], b.normal[0][0], 1e-5);
    EXPECT_NEAR(a.bend[0][0][0], b.bend[0][0][0], 2e-3);
    EXPECT_NEAR(c.gap[0], b.gap[0], 1e-13);
    EXPECT_EQ(c.normal[1][0], 0);
  }
}

// cos u cos v = (cos(u + v) + cos(u - v))/2: two waves along the diagonals.
TEST_F(HeightFieldTest, AFieldOfTwoWavesIsASineWallAlongTheDiagonal) {
  const auto wall = make_obstacle("Sine Wall", 3,
                                  {{"Amplitude", 0.2},
                                   {"Period", period / std::sqrt(2.0)},
                                   {"Second Amplitude", 0.2},
                                   {"Second Period", period / std::sqrt(2.0)},
                                   {"Direction", {1.0, 1.0, 0.0}}});
  const auto rough = field(3, 0.4, true);
  test::RandomPoints points({-20, -20, 0.45}, {20, 20, 2});
  for (int i = 0; i < 100; ++i) {
    const Point x = points();
    const ObstacleGap a = wall->at(test::packed(x)), b = rough->at(test::packed(x));
    if (a.gap[0] > 0.9 * wall->reach()) continue;
    EXPECT_NEAR(a.gap[0], b.gap[0], 1e-6);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(a.normal[j][0], b.normal[j][0], 1e-4);
  }
}

TEST_F(HeightFieldTest, NormalBendMeanAndBoundsHold) {
  test::RandomPoints points({-10, -10, 0.35}, {10, 10, 1.3});
  for (const char* measure : {"Distance", "Vertical"}) {
    const auto rough = field(3, 0.3, true, {{"Gap", measure}});
    for (int i = 0; i < 60; ++i) {
      const Point x0 = points(), x1 = points();
      // The second derivatives have kinks where the pieces of the spline meet.
      test::expect_derivatives(*rough, x0, 3, 1e-5, 1e-4);
      test::expect_mean(*rough, x0, x1);
      test::expect_bounds(*rough, x0, x1, 0.05, 0.2, 0.5);
    }
  }
}

TEST_F(HeightFieldTest, AFieldEndsAtItsEdge) {
  const auto rough = field(2, 0.3, false, {{"Periodic", false}});
  const double edge = 0.5 * period * 127 / 128;
  EXPECT_NEAR(test::gap(*rough, {0, 1, 0}), 0.7, 1e-6);
  EXPECT_TRUE(std::isfinite(test::gap(*rough, {edge - 1e-9, 1, 0})));
  EXPECT_EQ(test::gap(*rough, {edge + 1e-9, 1, 0}), -std::numeric_limits<double>::infinity());
  // A step ends there.
  const double step = rough->admissible_step(test::packed({0, 1, 0}), test::packed({2 * edge, 0, 0}), 0.1)[0];
  EXPECT_LE(step, 0.5);
  EXPECT_GE(step, 0.49);
}

TEST_F(HeightFieldTest, TheLevelChoosesTheZero) {
  for (const auto& [level, height] : {std::pair{"File", 0.7}, {"Mean", 0.7}, {"Top", 1.0}})
    EXPECT_NEAR(test::gap(*field(2, 0.3, false, {{"Level", level}}), {0, 1, 0}), height, 1e-4) << level;
}

TEST_F(HeightFieldTest, WhatDoesNotFitIsRefused) {
  const auto refused = [&](const std::string& text, std::size_t dimension, Settings more, const std::string& words) {
    const std::string path = folder_.path() + "/refused.txt";
    std::ofstream(path) << text;
    more.push_back({"File", path.c_str()});
    test::expect_contains(test::refusal([&] { make_obstacle("Height Field", dimension, more); }), words);
  };
  const Settings spacing{{"Spacing", {1.0, 1.0}}};
  refused("1 2 3 4\n", 2, {}, "Spacing: is missing");
  refused("1 2 3\n", 2, spacing, "has 1 rows of 3 heights; a row needs at least 4");
  refused("1 2 3 4\n1 2 3 4\n1 2 3 4\n1 2 3 4\n", 2, spacing, "in two dimensions it must have one row");
  refused("1 2 3 4\n1 2 3 4\n", 3, spacing, "it needs 1 row, or at least 4");
  refused("1 2 3 nan\n", 2, spacing, "File: ");
  refused("1 2 3 nan\n", 2, spacing, "line 1, number 4: \"nan\" is no height");
}

}  // namespace
}  // namespace ixos

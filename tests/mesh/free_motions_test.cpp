#include "mesh/free_motions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ixos {
namespace {

using Point = std::array<double, 3>;

const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

/// The corners of a box from `lower` with sides 4, 2 and, in space, 6.
std::vector<Point> corners(MotionSpace space, const Point& lower = {}) {
  std::vector<Point> result;
  for (const double a : {0.0, 4.0})
    for (const double b : {0.0, 2.0})
      for (const double c : {0.0, 6.0})
        if (c == 0 || space == MotionSpace::Space) result.push_back({lower[0] + a, lower[1] + b, lower[2] + c});
  return result;
}

std::string words(MotionSpace space, const std::vector<Restraint>& restraints, const Point& lower = {}) {
  return in_words(free_motions(corners(space, lower), restraints, space));
}

std::size_t count(MotionSpace space, const std::vector<Restraint>& restraints) {
  const FreeMotions found = free_motions(corners(space), restraints, space);
  return found.translations.size() + found.rotations.size();
}

TEST(FreeMotionsTest, ABodyWithoutRestraintsHasAllMotions) {
  EXPECT_EQ(words(MotionSpace::Plane, {}), "any translation and the rotation");
  EXPECT_EQ(words(MotionSpace::Space, {}), "any translation and any rotation");
  EXPECT_EQ(words(MotionSpace::Revolved, {}), "the translation along the axis");
  EXPECT_EQ(count(MotionSpace::Plane, {}), 3U);
  EXPECT_EQ(count(MotionSpace::Space, {}), 6U);
}

TEST(FreeMotionsTest, InThePlane) {
  const MotionSpace plane = MotionSpace::Plane;
  const Point a{0, 0, 0}, b{4, 0, 0}, c{0, 2, 0};
  EXPECT_EQ(words(plane, {{a, x}, {a, y}, {b, x}, {b, y}}), "");
  EXPECT_EQ(words(plane, {{a, x}, {a, y}, {b, y}}), "") << "statically determinate";
  EXPECT_EQ(words(plane, {{a, y}, {b, y}}), "the translation along (1, 0)") << "a frictionless floor";
  EXPECT_EQ(words(plane, {{a, x}, {c, x}, {a, y}, {b, y}}), "") << "two planes of symmetry";
  EXPECT_EQ(words(plane, {{a, x}, {a, y}}), "the rotation about (0, 0)") << "a hinge";
  EXPECT_EQ(words(plane, {{b, x}, {b, y}}), "the rotation about (4, 0)");
  // Normals of a circle about (2, 1) hold the place, not the angle.
  EXPECT_EQ(words(plane, {{a, {2 / std::sqrt(5), 1 / std::sqrt(5), 0}}, {b, {-2 / std::sqrt(5), 1 / std::sqrt(5), 0}}}),
            "the rotation about (2, 1)");
  // Directions through one point far away leave the rotation about it: a mechanism to first order.
  EXPECT_EQ(words(plane, {{{0, 0, 0}, {10 / std::sqrt(149), 7 / std::sqrt(149), 0}},
                          {{4, 0, 0}, {6 / std::sqrt(85), 7 / std::sqrt(85), 0}},
                          {{0, 2, 0}, {10 / std::sqrt(125), 5 / std::sqrt(125), 0}}}),
            "the rotation about (10, 7)");
}

TEST(FreeMotionsTest, InSpace) {
  const MotionSpace space = MotionSpace::Space;
  const Point a{0, 0, 0}, b{4, 0, 0}, c{0, 2, 0}, d{0, 0, 6};
  std::vector<Restraint> floor{{a, z}, {b, z}, {c, z}};
  EXPECT_EQ(words(space, floor), "translations normal to (0, 0, 1) and the rotation about the axis along (0, 0, 1)");
  floor.push_back({a, x});
  EXPECT_EQ(words(space, floor), "the translation along (0, 1, 0) and the rotation about the axis along (0, 0, 1)");
  floor.push_back({a, y});
  EXPECT_EQ(words(space, floor), "the rotation about the axis along (0, 0, 1) through (0, 0, 3)");
  floor.push_back({c, x});
  EXPECT_EQ(words(space, floor), "");
  EXPECT_EQ(words(space, {{a, x}, {a, y}, {a, z}}), "any rotation");
  EXPECT_EQ(words(space, {{a, x}, {a, y}, {a, z}, {d, x}, {d, y}, {d, z}}),
            "the rotation about the axis along (0, 0, 1) through (0, 0, 3)");
}

TEST(FreeMotionsTest, OfABodyOfRevolution) {
  EXPECT_EQ(words(MotionSpace::Revolved, {{{1, 0, 0}, x}}), "the translation along the axis");
  EXPECT_EQ(words(MotionSpace::Revolved, {{{1, 0, 0}, {0.6, 0.8, 0}}}), "");
}

// Neither the place of the origin, the unit of length nor many more restraints of one kind change the answer.
TEST(FreeMotionsTest, DependOnNeitherOriginNorScale) {
  for (const double scale : {1e-9, 1.0, 1e9})
    for (const double shift : {0.0, 1e3}) {
      const auto place = [&](double u, double v) { return Point{scale * (u + shift), scale * (v - shift), 0}; };
      const std::vector<Point> body{place(0, 0), place(4, 0), place(4, 2), place(0, 2)};
      std::vector<Restraint> restraints;
      for (int k = 0; k <= 1000; ++k) restraints.push_back({place(4 * k / 1000.0, 0), y});
      EXPECT_EQ(in_words(free_motions(body, restraints, MotionSpace::Plane)), "the translation along (1, 0)")
          << scale << ", " << shift;
      restraints.push_back({place(0, 1), x});
      EXPECT_TRUE(free_motions(body, restraints, MotionSpace::Plane).empty()) << scale << ", " << shift;
    }
}

}  // namespace
}  // namespace ixos

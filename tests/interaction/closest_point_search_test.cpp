#include "interaction/closest_point_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ixos {
namespace {

/// h = A cos a + B cos b without the planes of symmetry that a sine wall uses: the search alone must find the closest
/// point.
struct Bumps {
  static constexpr std::size_t variables = 2;
  double first, second;

  const Bumps& reader() const { return *this; }
  Height<2> at(const GraphPoint<2>& a) const {
    Height<2> height{};
    using std::experimental::cos;
    using std::experimental::sin;
    height.value = first * cos(a[0]) + second * cos(a[1]);
    height.slope = {-first * sin(a[0]), -second * sin(a[1])};
    height.bend[0][0] = -first * cos(a[0]);
    height.bend[1][1] = -second * cos(a[1]);
    return height;
  }
  GraphPoint<2> kept(const GraphPoint<2>& place, const GraphPoint<2>& /*x*/) const { return place; }
  double sharpest() const { return std::max(first, second); }
  double bend_length() const { return 1; }
};

// From a closest point, up along the normal to less than the reach: the closest point must come back. Slopes up to 4;
// many lanes differ.
TEST(ClosestPointSearchTest, FindsTheClosestPointOfEveryPlaceWithinTheReach) {
  std::mt19937 random(3);
  for (const double size : {0.1, 0.5, 1.0, 4.0}) {
    const Bumps bumps{size, 0.6 * size};
    for (int k = 0; k < 200; ++k) {
      std::uniform_real_distribution<double> place(-7, 7), share(-0.9, 0.9);
      GraphPoint<2> projection;
      Pack distance;
      for (std::size_t l = 0; l < Pack::size(); ++l) {
        projection[0][l] = place(random);
        projection[1][l] = place(random);
        distance[l] = share(random) / bumps.sharpest();
      }
      const Height<2> height = bumps.at(projection);
      const Pack w =
          std::experimental::sqrt(1.0 + height.slope[0] * height.slope[0] + height.slope[1] * height.slope[1]);
      const GraphPoint<2> x{Pack(projection[0] - distance * height.slope[0] / w),
                            Pack(projection[1] - distance * height.slope[1] / w)};
      const ClosestPoint<2> found = find_closest_point(bumps, x, Pack(height.value + distance / w));
      for (std::size_t l = 0; l < Pack::size(); ++l)
        for (std::size_t i = 0; i < 2; ++i)
          EXPECT_NEAR(double(found.place[i][l]), double(projection[i][l]), 1e-9) << size << ' ' << double(distance[l]);
    }
  }
}

struct Slope {
  static constexpr std::size_t variables = 1;
  const Slope& reader() const { return *this; }
  Height<1> at(const GraphPoint<1>& a) const { return {Pack(0.75 * a[0]), {Pack(0.75)}, {}}; }
  GraphPoint<1> kept(const GraphPoint<1>& place, const GraphPoint<1>& /*x*/) const { return place; }
  double sharpest() const { return 0; }
  double bend_length() const { return 1; }
};

TEST(ClosestPointSearchTest, OnAPlaneTheClosestPointIsAcross) {
  const ClosestPoint<1> projection = find_closest_point(Slope(), {Pack(0.0)}, Pack(1.25));
  EXPECT_NEAR(projection.place[0][0], 0.6, 1e-15);  // the distance is 1
}

}  // namespace
}  // namespace ixos

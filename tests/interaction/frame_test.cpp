#include "interaction/frame.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "support/refusal.hpp"

namespace ixos {
namespace {

Frame read(const std::vector<double>& point, const std::vector<double>& normal, const std::vector<double>& direction,
           std::size_t dimension) {
  Teuchos::ParameterList list;
  list.set("Point", Teuchos::Array<double>(point));
  list.set("Normal", Teuchos::Array<double>(normal));
  list.set("Direction", Teuchos::Array<double>(direction));
  return read_frame(SceneNode(list, "Wall"), dimension);
}

TEST(FrameTest, TheAxesAreAtRightAnglesAndRightHanded) {
  const Frame frame = read({1, 2, 3}, {1, 2, 2}, {1, 0, 0}, 3);
  const auto& a = frame.axes;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(a[i][0] * a[j][0] + a[i][1] * a[j][1] + a[i][2] * a[j][2], i == j ? 1 : 0, 1e-15);
  EXPECT_NEAR(a[2][1], 2.0 / 3, 1e-15);
  EXPECT_GT(a[0][0], 0.9);
  EXPECT_NEAR(a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                  a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]),
              1, 1e-15);
}

TEST(FrameTest, CoordinatesComeBack) {
  const Frame frame = read({1, 2, 3}, {1, 2, 2}, {0, 1, 0}, 3);
  const PackPoint local = frame.to_local({4.0, -1.0, 0.5}), back = frame.to_space(local);
  EXPECT_NEAR(back[0][0], 3, 1e-15);
  EXPECT_NEAR(back[1][0], -3, 1e-15);
  EXPECT_NEAR(back[2][0], -2.5, 1e-15);
}

TEST(FrameTest, WithoutParametersTheWallIsLevel) {
  const Frame space = read({}, {}, {}, 3), plane = read({}, {}, {}, 2);
  EXPECT_EQ(space.axes[0], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(space.axes[2], (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(plane.axes[0], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(plane.axes[1], (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(plane.axes[2], (std::array<double, 3>{0, 1, 0}));
  // A wall across the first axis has a direction, too.
  EXPECT_NEAR(read({}, {1, 0, 0}, {}, 3).axes[0][1], 1, 1e-15);
}

TEST(FrameTest, ADirectionAcrossTheWallIsRefused) {
  test::expect_contains(test::refusal([] { read({}, {0, 0, 1}, {0, 0, -2}, 3); }), "Wall/Direction");
  test::expect_contains(test::refusal([] {
                          read({}, {}, {1, 0}, 2);
                        }),
                        "Wall/Direction: not allowed in two dimensions");
}

}  // namespace
}  // namespace ixos

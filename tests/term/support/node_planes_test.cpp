#include "term/support/node_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

TEST(NodePlanesTest, ProjectsOntoWhatThePlanesShare) {
  NodePlanes planes;
  EXPECT_TRUE(planes.empty());
  planes.add(1, 3, {2, 2, 0});
  planes.add(1, 3, {0, 0, 5});
  planes.add(1, 3, {1, 1, 1});  // follows from the others
  EXPECT_EQ(planes.normals(1).size(), 2);
  EXPECT_TRUE(planes.normals(0).empty());
  std::vector<double> x{1, 2, 3, 4, 6, 7};
  planes.project(x.data(), 2);
  const std::vector<double> expected{1, 2, 3, -1, 1, 0};
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-14) << i;
  planes.project(x.data(), 2);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-14) << i;
}

TEST(NodePlanesTest, LeavesNodesBehindTheEndAlone) {
  NodePlanes planes;
  planes.add(1, 2, {1, 0});
  std::vector<double> x{1, 2, 3, 4};
  planes.project(x.data(), 1);
  EXPECT_EQ(x, (std::vector<double>{1, 2, 3, 4}));
}

TEST(NodePlanesTest, WhatIsLeftAcrossIsTheRest) {
  NodePlanes planes;
  planes.add(0, 2, {3, 4});
  const std::vector<double> x{2, -1};
  std::vector<double> inside = x, across(2, 0.0);
  planes.project(inside.data(), 1);
  planes.add_across(1, x.data(), across.data(), 1);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(inside[i] + across[i], x[i], 1e-15);
  EXPECT_NEAR(across[0] * 4 - across[1] * 3, 0, 1e-15);
  EXPECT_NEAR(inside[0] * 3 + inside[1] * 4, 0, 1e-15);
}

TEST(NodePlanesTest, ComponentsThatAreHeldDropOutOfTheNormals) {
  NodePlanes planes;
  planes.add(0, 3, {1, 1, 1});
  planes.hold(0, 0);
  ASSERT_EQ(planes.normals(0).size(), 1);
  EXPECT_NEAR(planes.normals(0)[0][1], std::sqrt(0.5), 1e-15);
  planes.hold(0, 1);
  EXPECT_EQ(planes.normals(0)[0], (Vec<3>{0, 0, 1}));
  planes.hold(0, 2);
  EXPECT_TRUE(planes.normals(0).empty());
  planes.hold(7, 0);  // has no plane
}

}  // namespace
}  // namespace ixos

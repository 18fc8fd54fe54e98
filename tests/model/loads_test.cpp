#include "model/loads.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ixos {
namespace {

TEST(LoadsSerialTest, MeansAreOfTheHistory) {
  Loads loads;
  EXPECT_TRUE(loads.empty());
  loads.add({1, 2}, expression("t^2", "", ""));
  loads.add({0, 1}, constant(3));
  std::vector<double> f(2, 0.0);
  loads.add_mean({{0.0, 0.5}, {1.0, 0.5}}, 2.0, 1.0, f.data());
  EXPECT_NEAR(f[0], (4 + 9) / 2.0, 1e-15);
  EXPECT_NEAR(f[1], (4 + 9) + 3, 1e-15);
}

TEST(LoadsSerialTest, ForcesAreSumsOfHistoriesTimesTheirForces) {
  Loads loads;
  loads.add({1, 2}, expression("t", "", ""));
  loads.add({10, 0}, constant(3));
  std::vector<double> f{100, 200};
  loads.add_force(2.0, 0.5, f.data());
  EXPECT_EQ(f, (std::vector<double>{100 + 0.5 * (2 + 30), 200 + 0.5 * 4}));
}

TEST(LoadsSerialTest, ForcesCanBeReplaced) {
  Loads loads;
  EXPECT_EQ(loads.add({1, 2}, constant(1)), 0);
  EXPECT_EQ(loads.add({10, 20}, constant(2)), 1);
  loads.replace(1, {3, 4});
  std::vector<double> f(2, 0.0);
  loads.add_force(0.0, 1.0, f.data());
  EXPECT_EQ(f, (std::vector<double>{1 + 6, 2 + 8}));
  EXPECT_THROW(loads.replace(2, {0, 0}), std::out_of_range);
}

TEST(LoadsSerialTest, AnUndefinedHistoryIsNotFinite) {
  Loads loads;
  EXPECT_TRUE(loads.are_finite(1.0));
  loads.add({1}, constant(1));
  loads.add({1}, expression("1/(t-1)", "", ""));
  EXPECT_TRUE(loads.are_finite(2.0));
  EXPECT_FALSE(loads.are_finite(1.0));
}

}  // namespace
}  // namespace ixos

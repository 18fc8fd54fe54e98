// Costs of runs, fitted to samples of known laws.
#include "study/advice/cost_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

TEST(CostModelTest, FindsPowersAndScale) {
  std::vector<CostSample> samples;
  for (double steps : {100.0, 200.0, 400.0})
    for (double dofs : {1e3, 4e3, 1.6e4})
      samples.push_back({steps, dofs, 1e-6 * std::pow(steps, 0.8) * std::pow(dofs, 1.5)});
  const CostModel model = fit_costs(samples);
  EXPECT_NEAR(model.step_power, 0.8, 0.01);
  EXPECT_NEAR(model.dof_power, 1.5, 0.01);
  const double expected = 1e-6 * std::pow(800, 0.8) * std::pow(6.4e4, 1.5);
  EXPECT_NEAR(model.seconds(800, 6.4e4) / expected, 1, 0.05);
}

TEST(CostModelTest, PowersThatNothingTellsKeepTheirDefaults) {
  const CostModel model = fit_costs({{100, 1000, 2}, {200, 1000, 4}});
  EXPECT_NEAR(model.step_power, 1, 0.05);
  EXPECT_EQ(model.dof_power, CostModel().dof_power);
  EXPECT_NEAR(model.seconds(100, 1000), 2, 0.1);
  const CostModel one = fit_costs({{100, 1000, 2}});
  EXPECT_NEAR(one.seconds(100, 1000), 2, 1e-9);
  EXPECT_NEAR(one.seconds(300, 1000), 6, 1e-9);
}

TEST(CostModelTest, PowersStayInTheirRange) {
  // Disturbed measurements: the longer run seems to be cheaper.
  const CostModel model = fit_costs({{100, 1000, 9}, {1000, 1000, 1}});
  EXPECT_GT(model.step_power, 0);
  EXPECT_GT(model.seconds(2000, 1000), model.seconds(1000, 1000));
}

/// Taken at their word, runs of 0.02 s and 0.46 s say that costs grow 23-fold with the mesh. But the 0.02 s are noise.
TEST(CostModelTest, ShortRunsTellLittle) {
  const CostModel model = fit_costs({{100, 80, 0.02}, {100, 375, 0.46}});
  EXPECT_LT(model.dof_power, 1.6);
  EXPECT_NEAR(model.seconds(100, 375), 0.46, 0.1);
  const CostModel longer = fit_costs({{100, 80, 20}, {100, 375, 460}});
  EXPECT_GT(longer.dof_power, 1.9);
}

TEST(CostModelTest, NothingIsKnownWithoutSamples) {
  EXPECT_EQ(fit_costs({}).scale, 0);
  EXPECT_EQ(fit_costs({{0, 10, 1}, {10, 10, 0}}).scale, 0);
}

}  // namespace
}  // namespace ixos

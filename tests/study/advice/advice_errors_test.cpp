// Errors of settings, from formulas whose exact values are known.
#include "study/advice/advice_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

using test::cross;
using test::directions_of_formula;
using test::sample_of;

constexpr double exact = 4;

double smooth(double dt, double h, const AdvicePoint&) { return exact * (1 + 0.1 * dt * dt - 0.2 * h * h); }

class AdviceErrorsTest : public testing::Test {
 protected:
  AdviceErrors errors(const std::vector<AdviceSample>& samples, bool is_error = false, double noise = 0) const {
    return {directions_, base_, samples, {is_error}, {noise}};
  }
  const AdviceDirections directions_ = directions_of_formula();
  const AdvicePoint base_{{0, 2}, {0, 0}, {0, 0}};
};

TEST_F(AdviceErrorsTest, PartsAddUp) {
  const AdviceErrors found = errors(cross(directions_, base_, 3, 2, smooth));
  EXPECT_NEAR(found.exact(0), exact, 1e-6);
  const AdvicePoint point{{0, 1}, {0, 2}, {0, 0}};  // dt 1/2, h 1/4: 0.025 and 0.0125
  const AdviceEstimate estimate = found.estimate(point);
  EXPECT_NEAR(estimate.parts[0][0], 0.025, 0.001);
  EXPECT_NEAR(estimate.parts[0][1], 0.0125 * 3, 0.001) << "three meshes alone";
  EXPECT_NEAR(estimate.largest(), 0.025 + 0.0125 * 3, 0.002);
  EXPECT_GE(estimate.largest(), std::abs(smooth(0.5, 0.25, point) / exact - 1));
  EXPECT_EQ(estimate.worst_direction(), mesh_direction);
  EXPECT_EQ(estimate.beyond, 0U);
  EXPECT_EQ(found.estimate({{0, 4}, {0, 3}, {0, 0}}).beyond, 1U);
  EXPECT_NE(found.reason(time_direction, 0).find("order 2"), std::string::npos);
}

TEST_F(AdviceErrorsTest, WhatWasNotRunIsUnknown) {
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 0, smooth);
  EXPECT_TRUE(std::isinf(errors(samples).estimate(base_).largest())) << "one mesh tells nothing of its error";
  samples = cross(directions_, base_, 3, 2, smooth);
  const AdviceErrors found = errors(samples);
  EXPECT_TRUE(std::isinf(found.estimate({{1, 2}, {0, 1}, {0, 0}}).largest())) << "the other scheme";
  EXPECT_TRUE(std::isinf(found.estimate({{0, 2}, {0, 1}, {1, 0}}).largest())) << "the other tolerance";
}

TEST_F(AdviceErrorsTest, OneRunOfAnotherSchemeMayBeLuck) {
  // The other scheme crosses the limit at the base step.
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    return smooth(dt, h, point) + (point[0].branch == 1 ? exact * (0.3 * (dt - 0.25) - 0.1 * dt * dt) : 0);
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, formula);
  const AdvicePoint other{{1, 2}, {0, 0}, {0, 0}}, coarser{{1, 1}, {0, 0}, {0, 0}};
  samples.push_back(sample_of(directions_, other, formula));
  EXPECT_LT(errors(samples).finest_error(0, 1, 0), 0.01);
  EXPECT_TRUE(std::isinf(errors(samples).estimate(other).largest()));
  samples.push_back(sample_of(directions_, coarser, formula));
  // The error of the coarser run, 0.075, counts as falling with second order at most.
  EXPECT_GE(errors(samples).estimate(other).parts[0][0], 0.075 / 4);
  EXPECT_GE(errors(samples).estimate(coarser).parts[0][0], 0.07);
  EXPECT_TRUE(std::isinf(errors(samples).estimate({{1, 3}, {0, 0}, {0, 0}}).largest())) << "finer than its runs";
}

TEST_F(AdviceErrorsTest, TheBranchOfTheBaseLeads) {
  // The base has the other element, of second order; the first one has an error of first order.
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    return exact * (1 + 0.1 * dt * dt + (point[1].branch == 1 ? 0.02 * h * h : 0.2 * h));
  };
  const AdvicePoint base{{0, 2}, {1, 0}, {0, 0}};
  std::vector<AdviceSample> samples = cross(directions_, base, 3, 2, formula);
  const AdviceErrors found(directions_, base, samples, {false}, {0.0});
  EXPECT_EQ(found.own(mesh_direction), 1U);
  EXPECT_NEAR(found.exact(0), exact, 1e-6);
  EXPECT_NEAR(found.estimate({{0, 3}, {1, 2}, {0, 0}}).parts[0][1], 0.02 / 16 * 3, 1e-4);
  // Runs of the first element are judged by that limit.
  for (std::size_t level : {0, 1}) samples.push_back(sample_of(directions_, {{0, 2}, {0, level}, {0, 0}}, formula));
  const AdviceErrors both(directions_, base, samples, {false}, {0.0});
  EXPECT_NEAR(both.estimate({{0, 2}, {0, 1}, {0, 0}}).parts[0][1], 0.1, 0.01);
}

TEST_F(AdviceErrorsTest, TwoSizesThatAgreeAreDoubtedIfOthersDiffer) {
  // Two meshes of the other element agree, 0.1 away from the limit that the first element approaches.
  const auto formula = [](double, double h, const AdvicePoint& point) {
    return exact * (1 + (point[1].branch == 1 ? 0.1 : 0.05 * h));
  };
  const AdvicePoint base{{0, 2}, {1, 0}, {0, 0}};
  std::vector<AdviceSample> samples = cross(directions_, base, 3, 1, formula);
  for (std::size_t level : {0, 1, 2}) samples.push_back(sample_of(directions_, {{0, 2}, {0, level}, {0, 0}}, formula));
  const AdviceErrors found(directions_, base, samples, {false}, {0.0});
  // A third of the distance at least, from 1.1 to the limit 1.
  EXPECT_GE(found.estimate(base).parts[0][1], 0.1 / 3 / 1.1);
}

TEST_F(AdviceErrorsTest, AStepOnAFineMeshCountsBesideTheBase) {
  const auto formula = [](double dt, double h, const AdvicePoint&) {
    return exact * (1 + (h < 0.3 ? 1.0 : 0.01) * dt * dt);
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 4, 2, formula);
  const AdvicePoint fine{{0, 4}, {0, 2}, {0, 0}}, twin{{0, 3}, {0, 2}, {0, 0}};
  samples.push_back(sample_of(directions_, fine, formula));
  EXPECT_LT(errors(samples).estimate(fine).parts[0][0], 1e-3);
  samples.push_back(sample_of(directions_, twin, formula));
  EXPECT_GE(errors(samples).estimate(fine).parts[0][0], 1.0 / 256);  // (1/16)^2
}

TEST_F(AdviceErrorsTest, ChoicesCountFromTheScenesOwn) {
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    return smooth(dt, h, point) + (point[2].branch == 1 ? 0.003 * exact : 0);
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, formula);
  samples.push_back(sample_of(directions_, {{0, 2}, {0, 0}, {1, 0}}, formula));
  const AdviceErrors found = errors(samples);
  EXPECT_EQ(found.estimate(base_).parts[0][2], 0);
  // The column of the base is smaller than the exact value.
  const double column = 1 + 0.1 / 16 - 0.2;
  EXPECT_NEAR(found.estimate({{0, 2}, {0, 1}, {1, 0}}).parts[0][2], 0.003 / column, 1e-6);
}

TEST_F(AdviceErrorsTest, AModelHasTheErrorOfItsColumn) {
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, smooth);
  const AdvicePoint other{{0, 2}, {0, 0}, {1, 0}}, finer{{0, 2}, {0, 1}, {1, 0}};
  samples.push_back(sample_of(directions_, other, smooth));
  EXPECT_NEAR(errors(samples).estimate(finer).parts[0][2], 0, 1e-14) << "number and column agree";
  samples.back().comparisons = {{2, {0.2}}};
  EXPECT_NEAR(errors(samples).estimate(finer).parts[0][2], 0.2, 1e-14) << "the number agrees, the column does not";
  EXPECT_NEAR(errors(samples).finest_error(2, 1, 0), 0.2, 1e-14);
  EXPECT_EQ(errors(samples).estimate(base_).parts[0][2], 0);
  samples.back().comparisons.clear();
  EXPECT_TRUE(std::isinf(errors(samples).estimate(finer).largest())) << "nothing was compared";
  EXPECT_TRUE(std::isinf(errors(samples).finest_error(2, 1, 0)));
}

TEST_F(AdviceErrorsTest, AModelMustNotAgreeByTheChangeOfAnotherLevel) {
  AdviceDirections directions = directions_;
  directions.all[time_direction].branches[1].same_limit = false;  // as Static for a scheme with inertia
  std::vector<AdviceSample> samples = cross(directions, base_, 3, 2, smooth);
  for (std::size_t level : {1, 2, 3}) {
    samples.push_back(sample_of(directions, {{1, level}, {0, 0}, {0, 0}}, smooth));
    samples.back().comparisons = {{time_direction, {level == 2 ? 0.02 : 0.1}}};
  }
  const AdviceErrors found(directions, base_, samples, {false}, {0.0});
  EXPECT_NEAR(found.model_error(time_direction, {1, 1}, 0), 0.1, 1e-14);
  EXPECT_NEAR(found.model_error(time_direction, {1, 2}, 0), 0.02, 1e-14);
  EXPECT_NEAR(found.model_error(time_direction, {1, 4}, 0), 0.1, 1e-14) << "that of the finest";
  EXPECT_TRUE(std::isinf(found.model_error(time_direction, {1, 0}, 0)));
  EXPECT_EQ(found.model_error(time_direction, {0, 0}, 0), 0);
  EXPECT_GE(found.estimate({{1, 3}, {0, 1}, {0, 0}}).parts[0][0], 0.0999);
}

TEST_F(AdviceErrorsTest, ALawMustHoldForTheStrainsOfTheRuns) {
  AdviceDirections directions = directions_;
  directions.all[2].branches[1].law = "Linear Elastic";
  const double quarter = std::atan(1.0);  // 45 degrees
  std::vector<AdviceSample> samples = cross(directions, base_, 3, 2, smooth);
  const AdvicePoint other{{0, 2}, {0, 0}, {1, 0}};
  samples.push_back(sample_of(directions, other, smooth));
  const auto error = [&] { return AdviceErrors(directions, base_, samples, {false}, {0.0}).model_error(2, {1, 0}, 0); };
  EXPECT_TRUE(std::isinf(error())) << "no run measured strains";
  samples.back().strains = {0, 0, 0};  // what the other law itself says does not count
  EXPECT_TRUE(std::isinf(error()));
  samples.front().strains = {0.02, -0.001, 0.002};
  EXPECT_NEAR(error(), 0.02 * 0.02 / 2 + 0.002, 1e-8);
  samples[1].strains = {quarter, -0.001, 0.001};
  EXPECT_NEAR(error(), 1 - std::sqrt(0.5) + 0.002, 1e-14) << "the largest of all runs";
  const AdviceErrors found(directions, base_, samples, {false}, {0.0});
  EXPECT_GE(found.estimate(other).parts[0][2], 0.29);
  EXPECT_EQ(found.estimate(base_).parts[0][2], 0) << "the scene's own law";
}

TEST_F(AdviceErrorsTest, WhatWasNotRefinedIsNotExamined) {
  const std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, smooth);
  for (std::size_t d : {0, 1, 2}) EXPECT_TRUE(errors(samples).is_examined(base_, d, 0)) << d;
  AdviceDirections directions = directions_;
  directions.all[mesh_direction].branches[0].levels.resize(1);  // a mesh from a file
  const std::vector<AdviceSample> steps = cross(directions_, base_, 3, 0, smooth);
  const AdviceErrors found(directions, base_, steps, {false}, {0.0});
  EXPECT_TRUE(found.is_examined(base_, time_direction, 0));
  EXPECT_FALSE(found.is_examined(base_, mesh_direction, 0));
  EXPECT_EQ(found.reason(mesh_direction, 0), not_examined);
  // An error on one mesh tells nothing of that on a finer one.
  EXPECT_FALSE(AdviceErrors(directions_, base_, steps, {true}, {0.0}).is_examined(base_, mesh_direction, 0));
  EXPECT_TRUE(AdviceErrors(directions_, base_, samples, {true}, {0.0}).is_examined(base_, mesh_direction, 0));
}

TEST_F(AdviceErrorsTest, AFinerLevelThatWasNotRunIsNotExamined) {
  AdviceDirections directions = directions_;
  directions.all[2] = {"points", {{"", {}, {{"3", 2, {}}, {"5", 1, {}}, {"10", 0.5, {}}}}}, 1, true};
  const AdvicePoint base{{0, 2}, {0, 0}, {0, 1}}, coarse{{0, 2}, {0, 0}, {0, 0}}, fine{{0, 2}, {0, 0}, {0, 2}};
  std::vector<AdviceSample> samples = cross(directions, base, 3, 2, smooth);
  samples.push_back(sample_of(directions, coarse, smooth));
  const AdviceErrors before(directions, base, samples, {false}, {0.0});
  EXPECT_FALSE(before.is_examined(base, 2, 0)) << "only fewer points were run";
  EXPECT_TRUE(before.is_examined(coarse, 2, 0)) << "against the scene's own";
  samples.push_back(sample_of(directions, fine, smooth));
  EXPECT_TRUE(AdviceErrors(directions, base, samples, {false}, {0.0}).is_examined(base, 2, 0));
}

TEST_F(AdviceErrorsTest, InteractionIsMeasured) {
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    return smooth(dt, h, point) + 0.4 * exact * dt * h;
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, formula);
  const AdvicePoint off{{0, 1}, {0, 1}, {0, 0}};
  const double before = errors(samples).estimate(off).largest();
  EXPECT_EQ(errors(samples).interaction(off, 0), 0) << "nothing tells of it";
  samples.push_back(sample_of(directions_, off, formula));
  // dt h between (1/4, 1) and (1/2, 1/2): 0.4 (1/2 - 1/4) (1 - 1/2).
  EXPECT_NEAR(errors(samples).interaction(off, 0), 0.05, 0.005);
  EXPECT_NEAR(errors(samples).estimate(off).largest(), before + 0.05, 0.005);
  EXPECT_NEAR(errors(samples).interaction({{0, 1}, {0, 2}, {0, 0}}, 0), 0.05, 0.005) << "that of the coarser run";
  EXPECT_EQ(errors(samples).interaction(base_, 0), 0);
}

TEST_F(AdviceErrorsTest, NoiseCounts) {
  const std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, smooth);
  EXPECT_NEAR(errors(samples, false, 0.01).estimate(base_).largest() - errors(samples).estimate(base_).largest(), 0.01,
              1e-12);
}

TEST_F(AdviceErrorsTest, AnErrorIsExactlyZero) {
  // An energy error of second order in the step, a little larger on finer meshes.
  const auto formula = [](double dt, double h, const AdvicePoint&) { return 0.1 * dt * dt + 0.001 * (1 - h); };
  const AdviceErrors found = errors(cross(directions_, base_, 3, 2, formula), true);
  EXPECT_EQ(found.exact(0), 0);
  const AdvicePoint point{{0, 1}, {0, 2}, {0, 0}};
  EXPECT_GE(found.estimate(point).largest(), formula(0.5, 0.25, point));
  EXPECT_LE(found.estimate(point).largest(), 1.1 * formula(0.5, 0.25, point));
}

TEST_F(AdviceErrorsTest, RunsThatFailedAreNoChoice) {
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 2, smooth);
  const AdvicePoint point{{0, 0}, {0, 1}, {0, 0}};
  EXPECT_TRUE(std::isfinite(errors(samples).estimate(point).largest()));
  samples.push_back(test::failed_sample(point));
  EXPECT_TRUE(std::isinf(errors(samples).estimate(point).largest()));
}

TEST_F(AdviceErrorsTest, DifferencesMeasuredElsewhereCount) {
  // The time steps on the coarsest mesh, the meshes at another base; nothing interacts.
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 0, smooth);
  const AdvicePoint finer{{0, 2}, {0, 1}, {0, 0}};
  for (const AdviceSample& sample : cross(directions_, finer, 2, 3, smooth)) samples.push_back(sample);
  const AdviceErrors found(directions_, finer, samples, {false}, {0.0});
  EXPECT_EQ(found.levels(time_direction, 0), (std::vector<std::size_t>{0, 1, 2, 3})) << "the last one from elsewhere";
  EXPECT_NEAR(found.exact(0), exact, 1e-9);
}

TEST_F(AdviceErrorsTest, ABetterElementTellsTheLimit) {
  // The scene's own element converges with the ripple of its mesh, the other one with second order.
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    const double ripple = 0.05 * h * std::sin(40 * h);
    return exact * (1 + 0.1 * dt * dt - (point[1].branch == 1 ? 0.02 * h * h : 0.2 * h * h + ripple));
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 3, formula);
  const double before = errors(samples).estimate({{0, 2}, {0, 3}, {0, 0}}).parts[0][mesh_direction];
  for (std::size_t level = 0; level < 4; ++level)
    samples.push_back(sample_of(directions_, {{0, 2}, {1, level}, {0, 0}}, formula));
  const AdviceErrors found = errors(samples);
  EXPECT_NEAR(found.exact(0), exact, 1e-4);
  const double after = found.estimate({{0, 2}, {0, 3}, {0, 0}}).parts[0][mesh_direction];
  EXPECT_LT(after, before);
  EXPECT_GE(after, std::abs(0.2 / 64 + 0.05 / 8 * std::sin(5.0)) * 0.99);
  EXPECT_NE(found.reason(mesh_direction, 0).find("the limit is that of Q2"), std::string::npos);
}

TEST_F(AdviceErrorsTest, LimitsThatContradictAreUncertain) {
  // The other element converges to another value.
  const auto formula = [](double dt, double h, const AdvicePoint& point) {
    return smooth(dt, h, point) + (point[1].branch == 1 ? 0.1 * exact + 0.199 * exact * h * h : 0);
  };
  std::vector<AdviceSample> samples = cross(directions_, base_, 3, 3, formula);
  for (std::size_t level = 0; level < 4; ++level)
    samples.push_back(sample_of(directions_, {{0, 2}, {1, level}, {0, 0}}, formula));
  EXPECT_GE(errors(samples).estimate({{0, 2}, {0, 3}, {0, 0}}).parts[0][mesh_direction], 0.09);
}

TEST_F(AdviceErrorsTest, HopeReducesAnUncertainty) {
  const AdviceErrors found = errors(cross(directions_, base_, 3, 2, smooth));
  const AdvicePoint point{{0, 2}, {0, 2}, {0, 0}};
  EXPECT_NEAR(found.hopeful(mesh_direction).estimate(point).parts[0][mesh_direction], 1.5 * 0.0125, 1e-3);
  EXPECT_EQ(found.hopeful(mesh_direction).estimate(point).parts[0][time_direction],
            found.estimate(point).parts[0][time_direction]);
}

}  // namespace
}  // namespace ixos

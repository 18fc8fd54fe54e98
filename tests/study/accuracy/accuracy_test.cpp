// Runs to an accuracy, of formulas in place of a scene: those that keep it, and all that ends the others.
#include "study/accuracy/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"

namespace ixos {
namespace {

AccuracyQuestion question(double accuracy, const std::vector<std::string>& texts = {"final x"}) {
  AccuracyQuestion result;
  for (const std::string& text : texts) result.quantities.emplace_back(text);
  result.accuracy = accuracy;
  return result;
}

AccuracySettings coarse() { return {1e-3, 2, 0.04, 1e-6}; }

/// A run of one unit of time, whose steps are the longest ones.
AccuracyRun run(const AccuracySettings& settings, const std::vector<double>& values) {
  AccuracyRun result;
  result.settings = settings;
  result.mean_step = settings.longest_step;
  result.steps = std::lround(1 / settings.longest_step);
  result.values = values;
  return result;
}

AccuracyRun failed(const AccuracySettings& settings, AccuracyOutcome outcome, const std::string& problem) {
  AccuracyRun result = run(settings, {});
  result.outcome = outcome;
  result.problem = problem;
  return result;
}

TEST(AccuracyTest, TheErrorIsAtMostTheReportedOneAndThatIsWithinTheAccuracy) {
  for (double accuracy : {1e-2, 1e-4, 1e-6}) {
    const AccuracyResult result = run_to_accuracy(question(accuracy), coarse(), [](const AccuracySettings& settings) {
      const double h = settings.longest_step;
      return run(settings, {2 + 30 * h * h + 10 * h * h * h});
    });
    ASSERT_EQ(result.status, AccuracyStatus::Kept);
    EXPECT_GE(result.runs.size(), 3u);
    EXPECT_TRUE(result.limit.empty());
    const AchievedAccuracy& achieved = result.achieved.front();
    EXPECT_EQ(achieved.value, result.runs.back().values.front());
    EXPECT_LE(std::abs(achieved.value - 2) / 2, achieved.error);
    EXPECT_LE(achieved.error, accuracy);
  }
}

TEST(AccuracyTest, EachRunHalvesTheSteps) {
  const AccuracyResult result = run_to_accuracy(question(1e-4), coarse(), [](const AccuracySettings& settings) {
    return run(settings, {1 + settings.longest_step * settings.longest_step});
  });
  ASSERT_GE(result.runs.size(), 4u);
  for (std::size_t i = 1; i < result.runs.size(); ++i) {
    const AccuracySettings &before = result.runs[i - 1].settings, &now = result.runs[i].settings;
    EXPECT_NEAR(now.longest_step, before.longest_step / 2, 1e-12);
    EXPECT_NEAR(now.tolerance, before.tolerance / 8, 1e-12);
    EXPECT_NEAR(now.gap_ratio, std::sqrt(before.gap_ratio), 1e-12);
  }
}

/// An error of second order in the steps, and one of order `order` in the faces of a mesh that follows the front.
AccuracyResult on_following_mesh(double accuracy, double size, double order) {
  AccuracySettings first = coarse();
  first.mesh = {2, 0.25, 0.1};
  return run_to_accuracy(question(accuracy), first, [=](const AccuracySettings& settings) {
    const double h = settings.longest_step;
    return run(settings, {2 + 3 * h * h + size * std::pow(settings.mesh.part, order)});
  });
}

TEST(AccuracyTest, AMeshThatFollowsTheFrontIsJudgedAfterTheSteps) {
  for (const double order : {1.0, 2.0}) {
    const double size = 0.4;
    const AccuracyResult result = on_following_mesh(1e-2, size, order);
    ASSERT_EQ(result.status, AccuracyStatus::Kept) << result.limit;
    const AccuracyRun& last = result.runs.back();
    EXPECT_GT(last.settings.mesh.levels, 2);
    EXPECT_EQ(last.settings.mesh.part, std::ldexp(0.25, 2 - last.settings.mesh.levels));
    EXPECT_EQ(last.settings.mesh.strain, std::ldexp(0.1, 2 - last.settings.mesh.levels));
    EXPECT_EQ(last.settings.longest_step, result.runs[result.runs.size() - 2].settings.longest_step);
    const AchievedAccuracy& achieved = result.achieved.front();
    EXPECT_EQ(achieved.value, last.values.front());
    EXPECT_LE(std::abs(achieved.value - 2) / 2, achieved.error + 1e-12);
    EXPECT_GE(achieved.mesh_error, size * std::pow(last.settings.mesh.part, order) / achieved.value * (1 - 1e-12));
    EXPECT_LE(achieved.error, 1e-2);
  }
}

TEST(AccuracyTest, AMeshThatIsNeverFineEnoughIsTheLimit) {
  const AccuracyResult slow = on_following_mesh(1e-3, 1, 1);
  EXPECT_EQ(slow.status, AccuracyStatus::Missed);
  EXPECT_EQ(slow.limit, "the mesh, with Mesh/Adapt/Levels = 6 and Part = 0.0156");
  const AccuracyResult rough = on_following_mesh(1e-3, 0.1, 0.1);
  EXPECT_EQ(rough.status, AccuracyStatus::Missed);
  EXPECT_EQ(rough.limit,
            "finer meshes no longer reduce the error: cells that Mesh/Adapt leaves as they are may be too coarse");
  EXPECT_EQ(on_following_mesh(1e-2, 0, 1).status, AccuracyStatus::Kept) << "one finer mesh tells";
}

TEST(AccuracyTest, EveryQuantityCounts) {
  const auto both = [](const AccuracySettings& settings) {
    const double h = settings.longest_step;
    return run(settings, {1.0, 1 + 5 * h});
  };
  const AccuracyResult result = run_to_accuracy(question(1e-2, {"final x", "final y"}), coarse(), both);
  ASSERT_EQ(result.status, AccuracyStatus::Kept);
  EXPECT_EQ(result.achieved[0].error, 0);
  EXPECT_LE(5 * result.runs.back().mean_step, 1e-2);
}

TEST(AccuracyTest, AnErrorCountsByItself) {
  const AccuracyResult result = run_to_accuracy(
      question(1e-3, {"energy error"}), coarse(),
      [](const AccuracySettings& settings) { return run(settings, {settings.longest_step * settings.longest_step}); });
  ASSERT_EQ(result.status, AccuracyStatus::Kept);
  EXPECT_EQ(result.achieved.front().error, result.runs.back().values.front());
}

TEST(AccuracyTest, StepsThatSomethingElseBoundsAreShortenedAllTheSame) {
  const double bound = 0.001;  // a stable step, say
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [&](const AccuracySettings& settings) {
    AccuracySettings used = settings;
    used.longest_step = std::min(settings.longest_step, bound);
    return run(used, {1 + 1e4 * used.longest_step * used.longest_step});
  });
  ASSERT_EQ(result.status, AccuracyStatus::Kept);
  EXPECT_LE(std::abs(result.achieved.front().value - 1), 1e-2);
  EXPECT_LT(result.runs.back().mean_step, bound / 2) << "equal runs must not count as an agreement";
}

TEST(AccuracyTest, AValueThatDoesNotConvergeEndsTheRuns) {
  int sign = 1;
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [&](const AccuracySettings& settings) {
    sign = -sign;
    return run(settings, {1 + 0.1 * sign});
  });
  EXPECT_EQ(result.status, AccuracyStatus::Missed);
  EXPECT_LT(result.runs.size(), 8u);
  EXPECT_GE(result.achieved.front().error, 0.1);
  test::expect_contains(result.limit, "shorter steps no longer reduce the error");
}

TEST(AccuracyTest, AChangeOfSignIsNoReasonToGiveUp) {
  // The third run seems to have an order; the fourth shows that it has none.
  const std::vector<double> errors{-0.012, -0.0016, -0.0002, -0.0003, 0, 0, 0, 0, 0, 0};
  std::size_t number = 0;
  const AccuracyResult result = run_to_accuracy(question(1e-3), coarse(), [&](const AccuracySettings& settings) {
    return run(settings, {1 + errors[number++]});
  });
  EXPECT_EQ(result.status, AccuracyStatus::Kept);
  EXPECT_GT(result.runs.size(), 4u);
}

TEST(AccuracyTest, AnErrorThatStaysEndsTheRuns) {
  const AccuracyResult result = run_to_accuracy(question(1e-3, {"energy error"}), coarse(),
                                                [](const AccuracySettings& settings) { return run(settings, {0.1}); });
  EXPECT_EQ(result.status, AccuracyStatus::Missed);
  EXPECT_LT(result.runs.size(), 8u);
}

TEST(AccuracyTest, AValueThatTendsToZeroHasNoRelativeError) {
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [](const AccuracySettings& settings) {
    return run(settings, {settings.longest_step});
  });
  EXPECT_EQ(result.status, AccuracyStatus::Missed);
  EXPECT_TRUE(std::isinf(result.achieved.front().error));
  test::expect_contains(result.limit, "be 0");
}

TEST(AccuracyTest, SlowConvergenceEndsAfterTenRuns) {
  const AccuracyResult result = run_to_accuracy(question(1e-8), coarse(), [](const AccuracySettings& settings) {
    return run(settings, {1 + settings.longest_step});
  });
  EXPECT_EQ(result.status, AccuracyStatus::Missed);
  EXPECT_EQ(result.runs.size(), 10u);
  test::expect_contains(result.limit, "10 runs");
}

TEST(AccuracyTest, ACoarseRunMayFail) {
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [](const AccuracySettings& settings) {
    const double h = settings.longest_step;
    return h > 0.03 ? failed(settings, AccuracyOutcome::Failed, "no step converged") : run(settings, {1 + h * h});
  });
  EXPECT_EQ(result.status, AccuracyStatus::Kept);
  EXPECT_EQ(result.runs.size(), 4u);
}

TEST(AccuracyTest, ThreeFailuresEndTheRuns) {
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [](const AccuracySettings& settings) {
    return failed(settings, AccuracyOutcome::NoValue, "there is no contact");
  });
  EXPECT_EQ(result.status, AccuracyStatus::NoRun);
  EXPECT_EQ(result.runs.size(), 3u);
  EXPECT_EQ(result.limit, "there is no contact");
  EXPECT_TRUE(result.achieved.empty());
}

TEST(AccuracyTest, ASignalEndsTheRuns) {
  const AccuracyResult result = run_to_accuracy(question(1e-2), coarse(), [](const AccuracySettings& settings) {
    return failed(settings, AccuracyOutcome::Interrupted, "interrupted by a signal");
  });
  EXPECT_EQ(result.status, AccuracyStatus::Interrupted);
  EXPECT_EQ(result.runs.size(), 1u);
}

}  // namespace
}  // namespace ixos

// Errors of sequences, from functions of the size whose limits are known.
#include "study/common/sequence_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

namespace ixos {
namespace {

/// Points at 1, 1/2, 1/4, ...
std::vector<SequencePoint> halved(std::size_t count, const std::function<double(double)>& value) {
  std::vector<SequencePoint> points;
  for (double size = 1; points.size() < count; size /= 2) points.push_back({size, value(size)});
  return points;
}

/// Expects that each bound holds, and that it falls towards the finest point.
void expect_bounds(const std::vector<SequencePoint>& points, const SequenceErrors& found, double exact) {
  ASSERT_EQ(found.errors.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GE(found.errors[i], std::abs(points[i].value - exact)) << i;
    EXPECT_LE(found.errors[i], found.errors[i > 0 ? i - 1 : 0]) << i;
  }
}

TEST(SequenceErrorTest, APowerIsExtrapolated) {
  for (double order : {1.0, 1.5, 2.0, 4.0}) {
    const auto points = halved(4, [&](double h) { return 3 - 0.2 * std::pow(h, order); });
    const SequenceErrors found = sequence_errors(points);
    EXPECT_TRUE(found.asymptotic) << found.reason;
    EXPECT_NEAR(found.order, order, 1e-6);
    EXPECT_NEAR(found.limit, 3, 1e-9);
    // The error itself, and half of that of the finest.
    const double finest = 0.2 * std::pow(0.125, order);
    EXPECT_NEAR(found.errors[3], 1.5 * finest, 1e-9);
    EXPECT_NEAR(found.errors[0], 0.2 + 0.5 * finest, 1e-9);
  }
}

TEST(SequenceErrorTest, ThreePointsAreTrustedLess) {
  const auto points = halved(3, [](double h) { return 3 - 0.2 * h * h; });
  const SequenceErrors found = sequence_errors(points);
  EXPECT_FALSE(found.asymptotic);
  EXPECT_NEAR(found.order, 2, 1e-6);
  EXPECT_NEAR(found.limit, 3, 1e-9);
  EXPECT_NEAR(found.errors[2], 3 * 0.2 / 16, 1e-9);
  // A higher order counts as 2.
  const SequenceErrors high = sequence_errors(halved(3, [](double h) { return 3 - 0.2 * std::pow(h, 4); }));
  EXPECT_EQ(high.order, 2);
  EXPECT_GE(high.errors[2], 0.2 / 256);
}

TEST(SequenceErrorTest, SizesNeedNotHalve) {
  std::vector<SequencePoint> points;
  for (double h : {0.9, 0.5, 0.4, 0.1}) points.push_back({h, 1 + h * h});
  const SequenceErrors found = sequence_errors(points);
  EXPECT_TRUE(found.asymptotic) << found.reason;
  EXPECT_NEAR(found.order, 2, 1e-6);
  EXPECT_NEAR(found.limit, 1, 1e-9);
}

TEST(SequenceErrorTest, AnOscillationIsBounded) {
  // The finest value is the limit by coincidence.
  const std::vector<SequencePoint> points{{1, 1.2}, {0.5, 0.9}, {0.25, 1.04}, {0.125, 1.0}};
  const SequenceErrors found = sequence_errors(points);
  EXPECT_FALSE(found.asymptotic);
  EXPECT_EQ(found.limit, 1.0);
  // The differences 0.3, 0.14 and 0.04, reduced with the size from 0.5, 0.25 and 0.125 to 0.125.
  EXPECT_NEAR(found.errors[3], 1.5 * 0.075, 1e-12);
  EXPECT_NE(found.reason.find("change their sign"), std::string::npos);
  expect_bounds(points, found, 1.0);
}

TEST(SequenceErrorTest, AnAdviceTrustsTheLastTwoDifferences) {
  const std::vector<SequencePoint> points{{1, 1.2}, {0.5, 0.9}, {0.25, 1.04}, {0.125, 1.0}};
  // The difference 0.3 counts as falling with the square of the size, 0.14 and 0.04 in proportion to it.
  EXPECT_NEAR(sequence_errors(points, true).errors[3], 1.5 * 0.07, 1e-12);
  const std::vector<SequencePoint> calm{{1, 1.2}, {0.5, 0.9}, {0.25, 1.001}, {0.125, 1.0}};
  EXPECT_NEAR(sequence_errors(calm, true).errors[3], 1.5 * 0.0505, 1e-12);
  const std::vector<SequencePoint> calmer{{1, 1.2}, {0.5, 0.9}, {0.25, 0.901}, {0.125, 0.9}};
  EXPECT_NEAR(sequence_errors(calmer, true).errors[3], 1.5 * 0.3 / 16, 1e-12);
}

TEST(SequenceErrorTest, ALuckyCrossingCountsAsTheFinerErrors) {
  // The ball with Generalized-Alpha: 0.052 at 0.005 T0, but 0.26 at 0.001 T0.
  const std::vector<SequencePoint> points{{0.01, 1.9}, {0.005, 1.052}, {0.001, 1.26}, {0.0005, 1.1}};
  const SequenceErrors found = sequence_errors(points);
  EXPECT_GE(found.errors[1], std::abs(1.26 - found.limit));
  EXPECT_GE(found.errors[1], found.errors[2]);
}

TEST(SequenceErrorTest, SlowAndIrregularSequencesAreNotAsymptotic) {
  const SequenceErrors slow = sequence_errors(halved(4, [](double h) { return 1 + 0.1 * std::pow(h, 0.2); }));
  EXPECT_FALSE(slow.asymptotic);
  EXPECT_EQ(slow.order, 0);
  EXPECT_NE(slow.reason.find("do not fall as a power"), std::string::npos) << slow.reason;
  // The last three points alone would be of second order.
  const std::vector<SequencePoint> unconfirmed{{1, 1.3}, {0.5, 1.16}, {0.25, 1.04}, {0.125, 1.01}};
  const SequenceErrors found = sequence_errors(unconfirmed);
  EXPECT_FALSE(found.asymptotic);
  EXPECT_NE(found.reason.find("three sizes alone"), std::string::npos) << found.reason;
}

TEST(SequenceErrorTest, TwoPointsAreBounded) {
  const SequenceErrors found = sequence_errors(halved(2, [](double h) { return 2 + 0.1 * h; }));
  EXPECT_FALSE(found.asymptotic);
  EXPECT_NEAR(found.errors[1], 1.5 * 0.05, 1e-12);
  EXPECT_NEAR(found.errors[0], 2.5 * 0.05, 1e-12) << "the difference, and the error of the finer one";
}

TEST(SequenceErrorTest, ASizeWithoutEffectHasNoError) {
  const SequenceErrors found = sequence_errors(halved(3, [](double) { return 7; }));
  EXPECT_EQ(found.errors, (std::vector<double>{0, 0, 0}));
  EXPECT_NE(found.reason.find("no effect"), std::string::npos);
}

TEST(SequenceErrorTest, BoundsHoldForErrorsOfSeveralPowers) {
  // q = 1 + a h + b h^2 + c h^3 with random signs: crossings and extrema among the points are frequent.
  for (const auto& [count, share] : {std::pair<std::size_t, double>{4, 0.9}, {5, 0.97}}) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    double held = 0, all = 0;
    for (int i = 0; i < 2000; ++i) {
      const double a = any(random), b = any(random), c = any(random);
      const auto points = halved(count, [&](double h) { return 1 + 0.1 * (a * h + b * h * h + c * h * h * h); });
      const SequenceErrors found = sequence_errors(points);
      for (std::size_t p = 0; p < points.size(); ++p, ++all)
        held += found.errors[p] >= std::abs(points[p].value - 1) ? 1 : 0;
    }
    EXPECT_GE(held, share * all) << count;
  }
}

TEST(SequenceErrorTest, BoundsHoldForErrorsThatFallSlowly) {
  for (double power : {0.45, 0.5, 0.6}) {
    const auto points = halved(3, [&](double h) { return 1 + std::pow(h, power); });
    const SequenceErrors found = sequence_errors(points, true);
    EXPECT_EQ(found.order, 0) << power;
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_GE(found.errors[i], points[i].value - 1) << power;
  }
}

/// A run of size 2 failed. Differences that grow have no power.
TEST(SequenceErrorTest, BoundsHoldWhereALevelIsMissing) {
  for (double power : {0.45, 0.5, 0.6}) {
    std::vector<SequencePoint> points;
    for (double h : {4.0, 1.0, 0.5}) points.push_back({h, 1 + std::pow(h, power)});
    const SequenceErrors found = sequence_errors(points, true);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_GE(found.errors[i], points[i].value - 1) << power;
  }
  const SequenceErrors growing = sequence_errors({{4, 1.1}, {2, 1.2}, {1, 1.4}}, true);
  EXPECT_NEAR(growing.errors[2], 1.5 * 0.2 / (std::pow(2, 0.4) - 1), 1e-12);
}

TEST(SequenceErrorTest, OtherSequencesAreJudgedByTheLimit) {
  const std::vector<SequencePoint> points{{1, 1.001}, {0.5, 1.05}};
  const std::vector<double> errors = errors_against(points, 1, 0.01);
  EXPECT_NEAR(errors[1], 0.06, 1e-12);
  EXPECT_EQ(errors[0], errors[1]) << "1.001 is a coincidence";
}

TEST(SequenceErrorTest, ErrorsBetweenAndBeyondThePoints) {
  const auto points = halved(4, [](double h) { return 1 + 0.1 * h * h; });
  const SequenceErrors found = sequence_errors(points);
  EXPECT_EQ(error_at(points, found, 0.5), found.errors[1]);
  EXPECT_EQ(error_at(points, found, 0.3), found.errors[1]) << "that of the coarser neighbour";
  EXPECT_NEAR(error_at(points, found, 0.0625), found.errors[3] / 4, 1e-9) << "of second order";
  EXPECT_TRUE(std::isinf(error_at(points, found, 2)));
  SequenceErrors bound = found;
  bound.asymptotic = false;
  EXPECT_NEAR(error_at(points, bound, 0.0625), found.errors[3] / 2, 1e-12) << "in proportion";
}

TEST(SequenceErrorTest, NoSequences) {
  EXPECT_THROW(sequence_errors({{1, 1}}), std::invalid_argument);
  EXPECT_THROW(sequence_errors({{1, 1}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(sequence_errors({{1, 1}, {0, 2}}), std::invalid_argument);
}

}  // namespace
}  // namespace ixos

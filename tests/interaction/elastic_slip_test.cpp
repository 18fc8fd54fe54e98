#include "interaction/elastic_slip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ixos {
namespace {

using Slip = ElasticSlip<double, 3>;
using Vector = Slip::Vector;

constexpr double stiffness = 2;
const Small<double, 3> plane{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};

Vector sum(const Vector& a, const Vector& b, double factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// Random paths in the plane z = 0, around a threshold of 1: the radius at which sliding begins is 0.5.
class RandomPaths {
 public:
  template <class Visit>
  void operator()(int count, const Visit& visit) {
    for (int n = 0; n < count; ++n) {
      const double size = std::pow(10, 2 * unit_(random_)), length = std::pow(10, 3 * unit_(random_) - 1);
      const Vector q0{size * unit_(random_), size * unit_(random_), 0};
      Vector way{length * unit_(random_), length * unit_(random_), 0};
      if (n % 5 == 0) way = sum({}, q0, -2.2);  // through the origin
      visit(n % 7 == 0 ? Vector{} : q0, way);
    }
  }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(ElasticSlipTest, SticksWithASpringAndSlidesAtTheThreshold) {
  const Slip slip(stiffness, 1.0);
  const auto sticking = slip.at({0.3, -0.2, 0}, plane);
  EXPECT_EQ(sticking.traction, (Vector{0.6, -0.4, 0}));
  EXPECT_EQ(sticking.by_threshold, Vector{});
  EXPECT_EQ(slip.energy({0.3, -0.2, 0}), 0.13);
  const auto sliding = slip.at({3, -4, 0}, plane);
  EXPECT_NEAR(sliding.traction[0], 0.6, 1e-15);
  EXPECT_NEAR(sliding.traction[1], -0.8, 1e-15);
  EXPECT_NEAR(slip.energy({3, -4, 0}), 5 - 0.25, 1e-15);
  EXPECT_NEAR(sliding.stiffness[0][0], 0.2 * (1 - 0.36), 1e-16);
  EXPECT_NEAR(sliding.stiffness[0][1], 0.2 * 0.48, 1e-16);
}

// A surface that is apart does not hold itself.
TEST(ElasticSlipTest, NothingResistsWithoutAThreshold) {
  const Slip none(stiffness, 0.0);
  for (const Vector& q : {Vector{}, Vector{0.2, -0.1, 0}})
    for (const Vector& way : {Vector{}, Vector{1e-12, 0, 0}, Vector{0.3, 0.1, 0}})
      for (const auto& response : {none.at(sum(q, way), plane), none.mean(q, way, plane)})
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_EQ(response.traction[i], 0);
          for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(response.stiffness[i][j], 0) << i << j;
        }
}

TEST(ElasticSlipTest, TheMeanDoesTheWorkOfThePotential) {
  const Slip slip(stiffness, 1.0);
  RandomPaths()(100000, [&](const Vector& q0, const Vector& way) {
    const double start = slip.energy(q0), end = slip.energy(sum(q0, way));
    ASSERT_NEAR(inner(slip.mean(q0, way, plane).traction, way), end - start, 4e-15 * (start + end));
  });
}

TEST(ElasticSlipTest, TheMeanIsTheIntegralOverThePath) {
  const Slip slip(stiffness, 1.0);
  RandomPaths()(200, [&](const Vector& q0, const Vector& way) {
    const int points = 4000;
    Slip::Response middle;
    for (int k = 0; k < points; ++k) {
      const double xi = (k + 0.5) / points;
      const auto own = slip.at(sum(q0, way, xi), plane);
      for (std::size_t i = 0; i < 3; ++i) {
        middle.traction[i] += own.traction[i] / points;
        middle.by_threshold[i] += own.by_threshold[i] / points;
        for (std::size_t j = 0; j < 3; ++j) middle.stiffness[i][j] += xi * own.stiffness[i][j] / points;
      }
    }
    const auto mean = slip.mean(q0, way, plane);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(mean.traction[i], middle.traction[i], 1e-5);
      EXPECT_NEAR(mean.by_threshold[i], middle.by_threshold[i], 5e-4);
      for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(mean.stiffness[i][j], middle.stiffness[i][j], 1e-3);
    }
  });
}

TEST(ElasticSlipTest, TheMeansDerivativesAreDifferences) {
  RandomPaths()(20000, [&](const Vector& q0, const Vector& way) {
    const double length = std::sqrt(inner(way, way));
    if (length < 0.01) return;
    const Slip slip(stiffness, 1.0);
    const auto mean = slip.mean(q0, way, plane);
    const double h = 1e-5 * length;
    for (std::size_t j = 0; j < 2; ++j) {
      Vector ahead = way, behind = way;
      ahead[j] += h;
      behind[j] -= h;
      const auto a = slip.mean(q0, ahead, plane), b = slip.mean(q0, behind, plane);
      for (std::size_t i = 0; i < 2; ++i)
        ASSERT_NEAR((a.traction[i] - b.traction[i]) / (2 * h), mean.stiffness[i][j], 2e-5 * stiffness);
    }
    const auto a = Slip(stiffness, 1 + 1e-6).mean(q0, way, plane), b = Slip(stiffness, 1 - 1e-6).mean(q0, way, plane);
    for (std::size_t i = 0; i < 2; ++i) ASSERT_NEAR((a.traction[i] - b.traction[i]) / 2e-6, mean.by_threshold[i], 1e-5);
    // The potential of the mean grows along the path with the mean's power.
    if (std::sqrt(inner(q0, q0)) > 0.6) return;  // an elastic slip is seldom beyond the radius
    const double more = slip.mean_potential(q0, sum(way, way, 1e-4)),
                 less = slip.mean_potential(q0, sum(way, way, -1e-4));
    ASSERT_NEAR((more - less) / 2e-4, inner(mean.traction, way), 1e-4 * (slip.energy(q0) + slip.energy(sum(q0, way))));
  });
}

// In steady sliding a step begins where the last one ended, at the radius up to rounding.
TEST(ElasticSlipTest, ThePotentialOfTheMeanIsSmoothWhereSlidingBegins) {
  const Slip slip(stiffness, 1.0);
  for (const double length : {1e-3, 0.1, 5.0, 100.0})
    for (const double angle : {0.1, 1.0, 1.5, 2.0}) {
      const Vector way{length * std::cos(angle), length * std::sin(angle), 0};
      const double known = slip.mean_potential({0.5, 0, 0}, way), h = 1e-4;
      for (const double beside : {0.5 - 1e-13, 0.5 - 1e-16, 0.5 + 1e-16, 0.5 + 1e-13})
        EXPECT_NEAR(slip.mean_potential({beside, 0, 0}, way), known, 1e-6 * std::abs(known)) << length << ' ' << angle;
      const double more = slip.mean_potential({0.5, 0, 0}, sum(way, way, h)),
                   less = slip.mean_potential({0.5, 0, 0}, sum(way, way, -h));
      const double slope = inner(slip.mean({0.5, 0, 0}, way, plane).traction, way);
      EXPECT_NEAR((more - less) / (2 * h), slope, 1e-5 * length) << length << ' ' << angle;
    }
}

// Work = change of stored energy + dissipation in random steps, of which each may have another threshold.
TEST(ElasticSlipTest, DissipationIsTheThresholdTimesThePlasticSlip) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  Vector e{};
  double worst = 0, work = 0, dissipated = 0;
  for (int n = 0; n < 100000; ++n) {
    const double threshold = 0.5 + 0.4 * unit(random), radius = threshold / stiffness;
    const Vector way{unit(random), unit(random), 0}, q = sum(e, way);
    const Slip slip(stiffness, threshold);
    const double length = std::sqrt(inner(q, q)), excess = std::max(std::sqrt(inner(e, e)) - radius, 0.0);
    Vector next = slip.at(q, plane).traction;
    for (double& component : next) component /= stiffness;
    const Vector plastic = sum(q, next, -1);
    const double lost = threshold * std::sqrt(inner(plastic, plastic)) + stiffness * excess * excess / 2;
    const double stored = stiffness * (inner(next, next) - inner(e, e)) / 2;
    const double done = inner(slip.mean(e, way, plane).traction, way);
    EXPECT_GE(lost, 0);
    EXPECT_EQ(length > radius, lost - stiffness * excess * excess / 2 > 1e-14);
    worst = std::max(worst, std::abs(done - stored - lost));
    work += done;
    dissipated += lost;
    e = next;
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_NEAR(work, dissipated + stiffness * inner(e, e) / 2, 1e-11 * work);
}

TEST(ElasticSlipTest, PacksAreNumbersSideBySide) {
  using Packs = ElasticSlip<Pack, 2>;
  const Small<Pack, 2> line{{{Pack(1.0), Pack(0.0)}, {Pack(0.0), Pack(0.0)}}};
  const ElasticSlip<double, 2> one(stiffness, 1.0);
  const Small<double, 2> of_one{{{1, 0}, {0, 0}}};
  const Pack from([](auto i) { return 0.3 * static_cast<double>(i) - 0.7; });
  const auto mean = Packs(stiffness, 1.0).mean({from, Pack(0.0)}, {Pack(0.9), Pack(0.0)}, line);
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    const auto own = one.mean({from[lane], 0}, {0.9, 0}, of_one);
    EXPECT_NEAR(mean.traction[0][lane], own.traction[0], 1e-16);
    EXPECT_NEAR(mean.stiffness[0][0][lane], own.stiffness[0][0], 1e-15);
    EXPECT_EQ(double(mean.stiffness[1][1][lane]), 0);
  }
}

}  // namespace
}  // namespace ixos

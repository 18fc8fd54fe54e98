#include "run/relaxation_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/snapshot.hpp"
#include "material/maxwell_branch.hpp"

namespace ixos {
namespace {

constexpr double tau = 2;
constexpr HistoryUpdate updates[] = {HistoryUpdate::BackwardEuler, HistoryUpdate::SecondOrder};

/// One body of one branch.
std::vector<HistoryStress> stressed(double stress, HistoryUpdate update = HistoryUpdate::BackwardEuler) {
  return {HistoryStress{update, {tau}, {stress}, stress, stress}};
}

/// Stress of a strain that grows to 1 in the first step and is held: as the steps compute it, and exact.
struct Held {
  double stress = 0, exact = 0;
  void step(double x, HistoryUpdate update) {
    const double s = x * (1 + x / 2), first = stress == 0 ? 1 : 0;
    exact = exact * std::exp(-x) + first * (1 - std::exp(-x)) / x;
    if (update == HistoryUpdate::BackwardEuler)
      stress = (stress + first) / (1 + x);
    else
      stress = (stress + first * (1 + s / 2)) / (1 + s);
  }
};

/// Returns the share of a watch, and that of the error of the stress, weighted alike.
std::pair<double, double> shares(const std::vector<double>& steps, HistoryUpdate update) {
  RelaxationWatch watch;
  Held held;
  double error = 0, stress = 0;
  for (double x : steps) {
    held.step(x, update);
    watch.step(stressed(held.stress, update), tau * x);
    error += x * held.stress * std::abs(held.stress - held.exact);
    stress += x * held.stress * held.stress;
  }
  return {watch.share(), error / stress};
}

TEST(RelaxationWatchTest, OneStepHasItsError) {
  for (HistoryUpdate update : updates)
    for (double x : {0.1, 1.0 / 3, 1.0, 4.0}) {
      const auto [watched, found] = shares({x}, update);
      EXPECT_NEAR(watched, found, 1e-12) << x;
    }
}

// The watch takes no less than the error, and no more than twice it.
TEST(RelaxationWatchTest, RelaxationHasItsError) {
  for (HistoryUpdate update : updates)
    for (double x : {0.05, 0.1, 1.0 / 3, 1.0, 4.0}) {
      const auto count = static_cast<std::size_t>(std::ceil(4 / x));
      const auto [watched, found] = shares(std::vector<double>(count, x), update);
      EXPECT_GE(watched, (1 - 1e-9) * found) << x;
      EXPECT_LE(watched, 2 * found) << x;
      std::vector<double> unequal;
      for (std::size_t n = 0; n < count; ++n) unequal.push_back(n % 2 == 0 ? x : x / 3);
      const auto [watched_too, found_too] = shares(unequal, update);
      EXPECT_GE(watched_too, (1 - 1e-9) * found_too) << x;
      EXPECT_LE(watched_too, 2.5 * found_too) << x;
    }
  EXPECT_GT(shares(std::vector<double>(12, 1.0 / 3), HistoryUpdate::BackwardEuler).first, 0.1);
  EXPECT_LT(shares(std::vector<double>(12, 1.0 / 3), HistoryUpdate::SecondOrder).first, 0.02);
}

TEST(RelaxationWatchTest, HalfTheStepHasHalfTheErrorOrAQuarter) {
  const auto share = [](double x, HistoryUpdate update) {
    return shares(std::vector<double>(static_cast<std::size_t>(4 / x + 0.5), x), update).first;
  };
  EXPECT_NEAR(share(0.02, updates[0]) / share(0.01, updates[0]), 2, 0.05);
  EXPECT_NEAR(share(0.02, updates[1]) / share(0.01, updates[1]), 4, 0.1);
}

/// A strain that vibrates quickly, with 125 steps a period of tau/2.5, has an error of x/2 of the stress.
TEST(RelaxationWatchTest, VibrationsDoNotAddUp) {
  RelaxationWatch watch;
  const double x = 1.0 / 312.5;
  double stress = 0, before = 0;
  for (int n = 1; n <= 5000; ++n) {
    const double strain = std::sin(2 * 3.14159265358979 * n / 125);
    stress = (stress + strain - before) / (1 + x);
    before = strain;
    watch.step(stressed(std::abs(stress)), tau * x);
  }
  EXPECT_NEAR(watch.share(), x / 2, 0.1 * x);
}

TEST(RelaxationWatchTest, BranchesCountWithTheirShareOfTheStress) {
  RelaxationWatch alone, beside, idle;
  Held held;
  for (int n = 1; n < 20; ++n) {
    held.step(1, updates[0]);
    std::vector<HistoryStress> bodies = stressed(held.stress);
    alone.step(bodies, tau);
    bodies[0].all *= 10;  // an elastic law nine times as stiff
    beside.step(bodies, tau);
    bodies[0].sum = 0;
    idle.step(bodies, tau);
  }
  EXPECT_NEAR(beside.share(), alone.share() / 10, 1e-14);
  EXPECT_EQ(idle.share(), 0);
  EXPECT_EQ(RelaxationWatch().share(), 0);
}

TEST(RelaxationWatchTest, ASnapshotBringsItBack) {
  RelaxationWatch watch;
  Snapshot snapshot([&](Record& record) { watch.transfer(record); });
  watch.step(stressed(0.5), 2);
  snapshot.save();
  watch.step(stressed(0.3), 1);
  const double share = watch.share();
  for (int n = 0; n < 3; ++n) watch.step(stressed(1), 2);
  snapshot.restore();
  watch.step(stressed(0.3), 1);
  EXPECT_EQ(watch.share(), share);
}

}  // namespace
}  // namespace ixos

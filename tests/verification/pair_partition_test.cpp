// Two bodies on several ranks.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::Collision;

constexpr double dt = 0.001;
constexpr int steps = 45;

/// A whole collision on this run's ranks has the trajectory and the history of one on a single rank.
TEST(PairPartitionTest, ThePartitionOfARunDoesNotMatter) {
  const Mesh disks = test::two_disks(3, {6.1, 2.4});
  for (const char* scheme : {"Average Vector Field", "Energy-Momentum"})
    for (const std::string& pair : {std::string(), test::word("Passes", "Two")}) {
      const std::string options = scheme[0] == 'A' ? test::count("Interaction Points", 5) : "";
      Collision parts(scheme, dt, options, pair, disks);
      Collision whole(scheme, dt, options, pair, disks, "a_surface", "b_surface", 0, test::self());
      double least = 1;
      for (int step = 0; step < steps; ++step) {
        for (Collision* collision : {&parts, &whole})
          ASSERT_TRUE(collision->simulation().integrator().step(dt).converged) << scheme << " " << step;
        const Momenta p = parts.momenta(), w = whole.momenta();
        EXPECT_NEAR(p.kinetic_energy, w.kinetic_energy, 1e-10);
        EXPECT_LT(test::distance(p.linear, w.linear), 1e-12);
        EXPECT_LT(test::distance(p.angular, w.angular), 1e-10);
        EXPECT_NEAR(test::total_energy(parts.simulation()), test::total_energy(whole.simulation()), 1e-10);
        EXPECT_NEAR(parts.least_gap(), whole.least_gap(), 1e-9);
        least = std::min(least, parts.least_gap());
      }
      EXPECT_LT(least, 0.3);
      const auto a = test::gathered(parts.simulation().model(), parts.simulation().integrator().state().u);
      const auto b = test::gathered(whole.simulation().model(), whole.simulation().integrator().state().u);
      EXPECT_LT(test::distance(a, b), 1e-9) << scheme;
    }
}

}  // namespace
}  // namespace ixos

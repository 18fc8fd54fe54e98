// Two surfaces in two passes.
#include "term/pair/two_passes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "model/surface_pair.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

/// Two disks with one pair.
struct Disks {
  std::unique_ptr<Model> model;
  const Interaction* term;

  Disks(Passes passes, const char* secondary = "a_surface", const char* primary = "b_surface")
      : model(test::model_of_bodies(test::two_disks(3, {5, 3.6}), {"a_surface", "b_surface"})) {
    SurfacePair pair;
    pair.side_set = secondary;
    pair.primary = primary;
    pair.law = gap_law(VanDerWaals(2.5, 25));
    pair.passes = passes;
    pair.cutoff = 0.9;  // the matrix leaves nothing out
    add_pair(*model, pair);
    term = dynamic_cast<const Interaction*>(model->force_terms().back().term);
  }
  std::vector<double> force(const std::vector<double>& u) const {
    std::vector<double> f(u.size(), 0.0);
    EXPECT_TRUE(term->add_force({nullptr, nullptr, u.data()}, end_rule(), f.data()));
    return f;
  }
  double energy(const std::vector<double>& u) const { return term->energy({u.data()}); }
};

TEST(TwoPassesSerialTest, TheirForceAndEnergyAreTheMeansOfBothOrders) {
  const Disks two(Passes::Two), one(Passes::One), other(Passes::One, "b_surface", "a_surface");
  const std::vector<double> u = test::smooth_field(*two.model, 0.02);
  EXPECT_NEAR(two.energy(u), (one.energy(u) + other.energy(u)) / 2, 1e-15);
  const auto f = two.force(u), g = one.force(u), h = other.force(u);
  for (std::size_t k = 0; k < f.size(); ++k) EXPECT_NEAR(f[k], (g[k] + h[k]) / 2, 1e-15);
  InteractionReport both, first, second;
  two.term->reports().report({u.data()}, both);
  one.term->reports().report({u.data()}, first);
  other.term->reports().report({u.data()}, second);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(both.force[i], (first.force[i] - second.force[i]) / 2, 1e-15);
  EXPECT_EQ(both.least_gap, std::min(first.least_gap, second.least_gap));
}

/// Without reaction each surface has the force that it has as the secondary one.
TEST(TwoPassesSerialTest, WithoutReactionEachSurfaceHasItsOwnForce) {
  const Disks without(Passes::TwoWithoutReaction), one(Passes::One), other(Passes::One, "b_surface", "a_surface");
  const std::vector<double> u = test::smooth_field(*one.model, 0.02);
  const auto f = without.force(u), g = one.force(u), h = other.force(u);
  double difference = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const double* const x = &one.model->mesh().coordinates[k / 2 * 2];
    const bool on_first = std::hypot(x[0], x[1]) < 3.01;
    EXPECT_NEAR(f[k], on_first ? g[k] : h[k], 1e-15);
    difference = std::max(difference, std::abs(g[k] - h[k]));
  }
  EXPECT_GT(difference, 1e-7);
  EXPECT_NEAR(without.energy(u), (one.energy(u) + other.energy(u)) / 2, 1e-15);
  EXPECT_FALSE(without.term->is_gradient(end_rule()));
  EXPECT_FALSE(without.term->follows(Mean::DiscreteGradient));
}

TEST(TwoPassesSerialTest, TangentsAreDerivatives) {
  for (const Passes passes : {Passes::Two, Passes::TwoWithoutReaction}) {
    const Disks disks(passes);
    const Model& model = *disks.model;
    const std::vector<double> u = test::smooth_field(model, 0.02), way = test::noise(model, 1);
    std::vector<double> ahead = u, behind = u;
    const double h = 1e-6;
    for (std::size_t k = 0; k < u.size(); ++k) {
      ahead[k] += h * way[k];
      behind[k] -= h * way[k];
    }
    const auto up = disks.force(ahead), down = disks.force(behind);
    std::vector<double> values(static_cast<std::size_t>(model.pattern().pairs()) * 4, 0.0), product(u.size(), 0.0);
    const Segment segment{nullptr, nullptr, u.data()};
    disks.term->add_tangent(segment, end_rule(), Tangent::Exact, values.data());
    model.pattern().for_each_row(values.data(), [&](int row, const auto& entries) {
      entries([&](int column, double value) {
        product[static_cast<std::size_t>(row)] += value * way[static_cast<std::size_t>(column)];
      });
    });
    double largest = 0;
    for (const double value : product) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < u.size(); ++k)
      EXPECT_NEAR((up[k] - down[k]) / (2 * h), product[k], 1e-8 + 1e-8 * largest);
    EXPECT_GT(largest, 0.01);
    if (passes != Passes::Two) continue;
    const auto action = disks.term->create_action();
    action->linearize(segment, end_rule(), Tangent::Exact, {});
    std::vector<double> y(u.size(), 0.0);
    action->add_product(way.data(), y.data());
    for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(y[k], product[k], 1e-6 * largest);
  }
}

}  // namespace
}  // namespace ixos

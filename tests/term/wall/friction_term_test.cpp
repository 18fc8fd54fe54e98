// Friction of a surface along obstacles.
#include "term/wall/friction_term.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "term/friction_fixture.hpp"

namespace ixos {
namespace {

using test::all_frictions;
using test::for_each_case;
using test::friction;
using test::Shape;
using test::Sliding;

// After a few steps that slide, a long step slides on, and a short one sticks.
TEST(FrictionTermTest, TangentsAreDifferencesAndActionsAreTangents) {
  for_each_case([](Sliding& s, const Friction& friction) {
    const std::vector<double> from = s.slide();
    const std::vector<double> way = test::smooth_field(*s.model, 0.5);
    for (const double length : {0.8, 0.01, 1e-5})
      for (const Rule& rule : {end_rule(), gauss_rule(3), point_rule({0.5}, {1.0}), exact_rule()}) {
        std::vector<double> to = s.at(3 + length), ahead = to, behind = to;
        const double h = 1e-7;
        for (std::size_t k = 0; k < to.size(); ++k) {
          ahead[k] += h * way[k];
          behind[k] -= h * way[k];
        }
        const auto f1 = s.force({from.data(), nullptr, ahead.data()}, rule);
        const auto f0 = s.force({from.data(), nullptr, behind.data()}, rule);
        const Segment here{from.data(), nullptr, to.data()};
        const auto k_way = s.product(here, rule, way);
        for (std::size_t k = 0; k < k_way.size(); ++k) ASSERT_NEAR((f1[k] - f0[k]) / (2 * h), k_way[k], 3e-5) << length;
        std::vector<double> y(to.size(), 0.0);
        s.for_each([&](const Interaction& term, const auto& steps) {
          EXPECT_EQ(term.is_gradient(rule), !friction.current);
          const auto action = term.create_action();
          ASSERT_EQ(action == nullptr, friction.current);
          if (friction.current) return;
          action->linearize(steps.in(here), rule, Tangent::Exact, {});
          action->add_product(way.data(), y.data());
        });
        for (std::size_t k = 0; k < k_way.size() && !friction.current; ++k) ASSERT_NEAR(y[k], k_way[k], 1e-14);
      }
  });
}

// Steps of all lengths, some of which nobody accepts: work = stored + dissipated.
TEST(FrictionTermTest, TheMeansWorkIsStoredOrDissipated) {
  for_each_case([](Sliding& s, const Friction& friction) {
    std::vector<double> from = s.at(0);
    double work = 0, lost = 0;
    const Rule rules[] = {exact_rule(), gauss_rule(5), discrete_gradient_rule()};
    for (int n = 1; n <= 30; ++n) {
      const std::vector<double> to = s.at(0.3 * n + (n % 3 == 0 ? 0.28 : 0)), other = s.at(2.0 * n, 3);
      const double before = s.energy(from);
      s.begin(from);
      s.force({from.data(), nullptr, other.data()}, exact_rule());
      s.begin(from);  // again, since the step was rejected
      const auto f = s.force({from.data(), nullptr, to.data()}, rules[n % 3]);
      const double dissipated = s.accept(from, to), step_work = s.dot(f, to, from);
      EXPECT_GE(dissipated, 0);
      EXPECT_NEAR(step_work, s.energy(to) - before + dissipated, 1e-15) << n;
      EXPECT_EQ(s.energy(to), s.energy(from));  // between steps the elastic slip alone counts
      work += step_work;
      lost += dissipated;
      from = to;
    }
    EXPECT_GT(lost, 1e-3);
    EXPECT_NEAR(work, s.energy(from) + lost, 1e-13);
    if (friction.type == FrictionType::Smoothed) {
      EXPECT_EQ(s.energy(from), 0);
    }
  });
}

TEST(FrictionTermTest, AFalsifiedForceBreaksTheAccount) {
  Sliding s(2, ContactElement::Q1C1, all_frictions[0], Shape::Flat);
  const std::vector<double> from = s.at(0), to = s.at(1);
  s.begin(from);
  auto f = s.force({from.data(), nullptr, to.data()}, exact_rule());
  for (double& component : f) component *= 1 + 1e-6;
  const double lost = s.accept(from, to);
  EXPECT_GT(std::abs(s.dot(f, to, from) - s.energy(to) - lost), 1e-10);
}

// The traction of a rigid surface that slides far before a wall is the threshold, against the way.
TEST(FrictionTermTest, SlidesAtTheThresholdAndReportsIt) {
  for (const FrictionType type : {FrictionType::ConstantStress, FrictionType::ExtendedAmontons}) {
    Friction own = friction(type, false);
    own.sharpness = 0;
    Sliding s(2, ContactElement::Q1C1, own, Shape::Flat);
    std::vector<double> from = test::at_rest(*s.model), to = from;
    for (std::size_t k = 0; k < to.size(); k += 2) to[k] = 0.4;
    s.begin(from);
    const double lost = s.accept(from, to);
    const VanDerWaals law(2.5, 25);
    const double threshold =
        type == FrictionType::ConstantStress
            ? own.stress
            : own.coefficient * (law.traction(Pack(0.27))[0] - law.traction(Pack(law.adhesion_gap()))[0]);
    InteractionReport report;
    s.for_each([&](const Interaction& term, const auto& steps) { term.reports().report(steps.at(to.data()), report); });
    double sums[2] = {report.force[0], report.force[1]};
    s.model->space().sum(sums, 2);
    EXPECT_NEAR(sums[0], -2 * threshold, 1e-15);
    EXPECT_EQ(sums[1], 0);
    const double radius = threshold / own.stiffness;
    EXPECT_NEAR(lost, 2 * threshold * (0.4 - radius), 1e-15);
    EXPECT_NEAR(s.energy(to), own.stiffness * radius * radius, 1e-16);
    std::vector<double> slip(static_cast<std::size_t>(s.model->mesh().nodes()), 0.0), measure = slip;
    CountedSides counted;
    s.for_each([&](const Interaction& term, const auto& steps) {
      term.reports().add_nodal(SurfaceNumber::Slip, steps.at(to.data()), slip.data());
      term.reports().add_nodal_measure(counted, measure.data());
    });
    for (std::size_t node = 0; node < slip.size(); ++node)
      if (measure[node] > 0) {
        EXPECT_NEAR(slip[node] / measure[node], 0.4 - radius, 1e-15);
      }
  }
}

// A surface that is pulled off frees the spring, and the work is booked.
TEST(FrictionTermTest, AThresholdThatFallsReleasesTheSpring) {
  for (const bool current : {false, true}) {
    Sliding s(2, ContactElement::Q1C1, friction(FrictionType::ExtendedAmontons, current), Shape::Flat);
    std::vector<double> rest = test::at_rest(*s.model), slid = rest, off = rest;
    for (std::size_t k = 0; k < slid.size(); k += 2) slid[k] = off[k] = 0.4;
    for (std::size_t k = 1; k < off.size(); k += 2) off[k] = 1;
    s.begin(rest);
    s.accept(rest, slid);
    const double stored = s.energy(slid);
    EXPECT_GT(stored, 0);
    s.begin(slid);
    const auto f = s.force({slid.data(), nullptr, off.data()}, exact_rule());
    const double lost = s.accept(slid, off);
    EXPECT_EQ(s.energy(off), 0);
    EXPECT_NEAR(lost, stored, 1e-16);
    EXPECT_NEAR(s.dot(f, off, slid), 0, 1e-16);
  }
}

}  // namespace
}  // namespace ixos

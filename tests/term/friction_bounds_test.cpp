// Friction: what it keeps, bounds, potentials and sums beside force and tangent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "term/friction_fixture.hpp"
#include "term/wall/moved_interaction.hpp"

namespace ixos {
namespace {

using test::for_each_case;
using test::friction;
using test::Shape;
using test::Sliding;

TEST(FrictionBoundsTest, KeptTangentsAreTangents) {
  for_each_case([](Sliding& s, const Friction&) {
    const std::vector<double> from = s.slide(), to = s.at(3.4);
    const Segment segment{from.data(), nullptr, to.data()};
    for (const Rule& rule : {end_rule(), gauss_rule(3)}) {
      const std::vector<double> force = s.force(segment, rule);
      std::vector<double> f(force.size(), 0.0);
      std::vector<std::unique_ptr<KeptPoints>> kept;
      s.for_each([&](const Interaction& term, const auto& steps) {
        kept.push_back(term.create_kept());
        EXPECT_TRUE(term.add_force_and_keep(steps.in(segment), rule, *kept.back(), f.data()));
      });
      for (std::size_t k = 0; k < f.size(); ++k) ASSERT_NEAR(f[k], force[k], 1e-16);
      for (const Tangent kind : {Tangent::Exact, Tangent::Convex}) {
        const std::vector<double> values = s.tangent(segment, rule, kind);
        std::vector<double> own(values.size(), 0.0);
        for (std::size_t i = 0; i < s.terms.size(); ++i)
          s.terms[i]->add_kept_tangent(s.steps[i]->in(segment), rule, kind, *kept[i], own.data());
        for (std::size_t k = 0; k < own.size(); ++k) ASSERT_NEAR(own[k], values[k], 1e-14);
      }
    }
  });
}

// In two dimensions a surface that slides on has no curvature, one that turns back sticks.
TEST(FrictionBoundsTest, ConvexTangentsAreSymmetricWithoutNegativeCurvature) {
  for_each_case([](Sliding& s, const Friction&) {
    const std::vector<double> from = s.slide(), zero(from.size(), 0.0), a = test::smooth_field(*s.model, 0.5),
                              b = test::noise(*s.model, 0.5);
    for (const double n : {3.4, 2.999})
      for (const Rule& rule : {end_rule(), exact_rule()}) {
        const std::vector<double> to = s.at(n);
        const Segment segment{from.data(), nullptr, to.data()};
        const auto ka = s.product(segment, rule, a, Tangent::Convex), kb = s.product(segment, rule, b, Tangent::Convex);
        EXPECT_NEAR(s.dot(ka, b, zero), s.dot(kb, a, zero), 1e-13);
        EXPECT_GT(s.dot(ka, a, zero), n < 3 ? 1e-3 : -1e-15);
        EXPECT_GT(s.dot(kb, b, zero), n < 3 ? 1e-3 : -1e-15);
      }
  });
}

TEST(FrictionBoundsTest, TheForceOfTheMeanIsTheSlopeOfItsPotential) {
  for_each_case([](Sliding& s, const Friction& friction) {
    if (friction.current) return;  // has no potential
    const std::vector<double> from = s.slide(), direction = test::smooth_field(*s.model, 0.5);
    for (const double length : {0.8, 0.01}) {
      const std::vector<double> to = s.at(3 + length), zero(to.size(), 0.0);
      const double h = 1e-5;
      double change = 0;
      for (const double sign : {-1.0, 1.0}) {
        std::vector<double> u = to;
        for (std::size_t k = 0; k < u.size(); ++k) u[k] += sign * h * direction[k];
        s.for_each([&](const Interaction& term, const auto& steps) {
          change += sign * term.mean_potential(steps.segment(from.data(), nullptr, u.data()));
        });
      }
      s.model->space().sum(&change, 1);
      const auto f = s.force({from.data(), nullptr, to.data()}, exact_rule());
      EXPECT_NEAR(change / (2 * h), s.dot(f, direction, zero), 1e-5 * (1e-2 + std::abs(s.dot(f, direction, zero))));
    }
  });
}

// A surface that is lifted off has no stiffness at all, so neither a bound nor rounding.
TEST(FrictionBoundsTest, RowSumsBoundTheTangentAndEndWithContact) {
  for_each_case([](Sliding& s, const Friction& friction) {
    if (friction.type == FrictionType::Smoothed) return;  // has no longest stable step
    const std::vector<double> from = s.slide(), to = s.at(2.999);
    const Segment segment{nullptr, nullptr, to.data()};
    std::vector<double> bound(from.size(), 0.0);
    s.for_each([&](const Interaction& term, const auto& steps) {
      EXPECT_TRUE(term.add_row_sums(steps.in(segment), bound.data()));
    });
    double largest = 0;
    s.model->pattern().for_each_row(s.tangent(segment, end_rule()).data(), [&](int row, const auto& entries) {
      double sum = 0;
      entries([&](int, double value) { sum += std::abs(value); });
      ASSERT_LE(sum, bound[static_cast<std::size_t>(row)] * (1 + 1e-12));
      largest = std::max(largest, sum);
    });
    EXPECT_GT(s.model->space().maximum(largest), 0.1);
    if (friction.type != FrictionType::ExtendedAmontons) return;
    std::vector<double> off = to;
    const auto d = static_cast<std::size_t>(s.model->mesh().dimension);
    for (std::size_t k = d - 1; k < off.size(); k += d)
      if (!s.model->mesh().is_derivative(k / d)) off[k] += 1;
    std::fill(bound.begin(), bound.end(), 0.0);
    s.for_each([&](const Interaction& term, const auto& steps) {
      term.add_row_sums(steps.segment(nullptr, nullptr, off.data()), bound.data());
    });
    EXPECT_EQ(*std::max_element(bound.begin(), bound.end()), 0);
    s.begin(to);
    s.accept(to, off);
    s.begin(off);
    double rounding = 0;
    s.for_each([&](const Interaction& term, const auto& steps) { rounding += term.rounding(steps.at(off.data())); });
    EXPECT_EQ(rounding, 0);
    for (const double value : s.tangent({nullptr, nullptr, off.data()}, end_rule())) ASSERT_EQ(value, 0);
  });
}

// A rigid surface of area 2 with a slip q: the stiffness is eps, and T_s/q beyond the threshold.
TEST(FrictionBoundsTest, RoundingIsThatOfTheStiffnessThatActs) {
  Friction own = friction(FrictionType::ConstantStress, false);
  own.sharpness = 0;
  Sliding s(2, ContactElement::Q1C1, own, Shape::Flat);
  const std::vector<double> rest = test::at_rest(*s.model);
  const auto rounding = [&](double q) {
    std::vector<double> u = rest;
    for (std::size_t k = 0; k < u.size(); k += 2) u[k] = q;
    s.begin(rest);
    double sum = 0;
    s.for_each([&](const Interaction& term, const auto& steps) { sum += term.rounding(steps.at(u.data())); });
    s.model->space().sum(&sum, 1);
    return std::sqrt(sum) / q;
  };
  const double radius = own.stress / own.stiffness, sticking = rounding(0.5 * radius);
  EXPECT_GT(sticking, 0.1 * own.stiffness);
  EXPECT_NEAR(rounding(0.9 * radius), sticking, 1e-14);
  EXPECT_NEAR(rounding(8 * radius), sticking / 8, 1e-14);
}

TEST(FrictionBoundsTest, AFactorScalesForceAndWorkButNoSlip) {
  for (const FrictionType type : {FrictionType::ExtendedAmontons, FrictionType::Smoothed}) {
    SurfaceOptions scaled;
    scaled.factor.of_place = [](const std::array<double, 3>&) { return 0.25; };
    Sliding whole(3, ContactElement::Q1C2, friction(type, false), Shape::Round),
        quarter(3, ContactElement::Q1C2, friction(type, false), Shape::Round, scaled);
    const std::vector<double> from = whole.at(0), to = whole.at(1);
    whole.begin(from);
    quarter.begin(from);
    const Segment segment{from.data(), nullptr, to.data()};
    const auto f = whole.force(segment, exact_rule()), g = quarter.force(segment, exact_rule());
    for (std::size_t k = 0; k < f.size(); ++k) ASSERT_NEAR(g[k], 0.25 * f[k], 1e-17);
    EXPECT_NEAR(quarter.accept(from, to), 0.25 * whole.accept(from, to), 1e-16);
    std::vector<double> slip(static_cast<std::size_t>(whole.model->mesh().nodes()), 0.0), other = slip;
    whole.terms[0]->reports().add_nodal(SurfaceNumber::Slip, whole.steps[0]->at(to.data()), slip.data());
    quarter.terms[0]->reports().add_nodal(SurfaceNumber::Slip, quarter.steps[0]->at(to.data()), other.data());
    for (std::size_t node = 0; node < slip.size(); ++node) EXPECT_EQ(slip[node], other[node]);
  }
}

// Before an obstacle that translates and turns, a surface at rest slides, too.
TEST(FrictionBoundsTest, TangentsBeforeMovedObstaclesAreDifferences) {
  for_each_case([](Sliding& s, const Friction&) {
    const LocalMesh& mesh = s.model->mesh();
    const auto at_rate = [](double rate) {
      return function_of_time([rate](double t) { return TimeValue{rate * t, rate, 0}; });
    };
    RigidMotionOptions options;
    options.translation = {at_rate(0.05), at_rate(-0.01), at_rate(0.01)};
    options.translation.resize(static_cast<std::size_t>(mesh.dimension));
    options.point.resize(static_cast<std::size_t>(mesh.dimension), 0.1);
    options.angle = at_rate(0.02);
    if (mesh.dimension == 3) options.axis = {1, 2, 2};
    const RigidMotion motion(mesh.dimension, options);
    for (auto& term : s.terms)
      term = std::make_unique<MovedInteraction>(std::move(term), motion, mesh, mesh.side_sets[mesh.side_set("bottom")],
                                                s.model->pattern());
    s.begin_anew();
    const std::vector<double> from = s.at(3), way = test::smooth_field(*s.model, 0.5);
    s.begin(from);
    for (const Rule& rule : {end_rule(), exact_rule()}) {
      const double h = 1e-7;
      const std::vector<double> to = s.at(3.4);
      std::vector<double> ahead = to, behind = to;
      for (std::size_t k = 0; k < to.size(); ++k) {
        ahead[k] += h * way[k];
        behind[k] -= h * way[k];
      }
      const auto f1 = s.force({from.data(), nullptr, ahead.data(), 0, 0.5}, rule);
      const auto f0 = s.force({from.data(), nullptr, behind.data(), 0, 0.5}, rule);
      const auto k_way = s.product({from.data(), nullptr, to.data(), 0, 0.5}, rule, way);
      for (std::size_t k = 0; k < k_way.size(); ++k) ASSERT_NEAR((f1[k] - f0[k]) / (2 * h), k_way[k], 3e-5);
    }
  });
}

// A surface that has slipped by one length has it at every node, also on the axis.
TEST(FrictionBoundsTest, NodalSlipIsAMeanOnTheAxis) {
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4}) {
    Friction own = friction(FrictionType::ConstantStress, false);
    own.sharpness = 0;
    Sliding s(2, element, own, Shape::Flat);
    LocalMesh mesh = s.model->mesh();
    const double left = -s.model->space().maximum(-*std::min_element(mesh.coordinates.begin(), mesh.coordinates.end()));
    for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) mesh.coordinates[k] -= std::min(left, 0.0);
    mesh.axisymmetric = true;
    s.terms = make_friction_terms(mesh, mesh.side_sets[mesh.side_set("bottom")], s.model->pattern(),
                                  FrictionLaw(own, gap_law(VanDerWaals(2.5, 25))), test::obstacle(Shape::Flat, 2), {});
    s.begin_anew();
    std::vector<double> from = test::at_rest(*s.model), to = from;
    for (std::size_t k = 0; k < to.size(); k += 2)
      if (!mesh.is_derivative(k / 2)) to[k] = 0.4;
    s.begin(from);
    s.accept(from, to);
    std::vector<double> slip(static_cast<std::size_t>(mesh.nodes()), 0.0), measure = slip;
    CountedSides counted;
    s.for_each([&](const Interaction& term, const auto& steps) {
      term.reports().add_nodal(SurfaceNumber::Slip, steps.at(to.data()), slip.data());
      term.reports().add_nodal_measure(counted, measure.data());
    });
    int nodes = 0;
    for (std::size_t node = 0; node < slip.size(); ++node)
      if (measure[node] > 0 && ++nodes > 0) {
        EXPECT_NEAR(slip[node] / measure[node], 0.4 - own.stress / own.stiffness, 1e-14);
      }
    EXPECT_GT(nodes, 1);
  }
}

}  // namespace
}  // namespace ixos

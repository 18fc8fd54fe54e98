// The sum of all forces of a damped body that sticks to a wall: its tangents are its derivatives, its forces the
// gradients of its potential, with what terms keep of a force and without.
#include "balance/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/semi_discrete_bodies.hpp"
#include "support/comparison.hpp"
#include "support/derivative.hpp"
#include "support/scene_text.hpp"
#include "support/tangents.hpp"

namespace ixos {
namespace {

using Values = std::vector<double>;

struct BodyOnWall {
  explicit BodyOnWall(int dimension)
      : simulation(test::held_block(dimension, test::number("Viscosity", 0.4))), model(simulation->model()) {}

  Values field(double amplitude, double phase) const {
    const Vector owned = test::wave(model, amplitude, phase);
    Values local(static_cast<std::size_t>(model.space().local()));
    model.space().import(owned, local.data());
    return local;
  }
  /// Returns K x, the rows of owned nodes.
  Values product(const BalancePoint& at, const TangentWeights& weights, const KeptForces* kept, const Values& x) const {
    Values values = test::no_values(model);
    Balance(model).tangent(at, weights, Tangent::Exact, kept, values.data());
    return test::matrix_product(model, values.data(), x);
  }
  Values sum(const BalancePoint& at) const {
    Balance balance(model);
    EXPECT_TRUE(balance.evaluate(at));
    Values result(static_cast<std::size_t>(model.space().owned()));
    balance.sum(at, nullptr, result.data());
    return result;
  }
  double total(const Values& x, const Values& y) const {
    double result = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i) result += x[i] * y[i];
    model.space().sum(&result, 1);
    return result;
  }
  /// Expects x, owned rows, to be the derivative of a sum by the length of the way.
  template <class Sum>
  void expect_derivative(const Values& x, const Sum& sum) const {
    const double scale = std::sqrt(total(x, x));
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(test::derivative([&](double s) { return sum(s)[i]; }, 1e-3), x[i], 1e-9 * scale) << i;
  }

  std::unique_ptr<Simulation> simulation;
  const Model& model;
};

/// A stage from one displacement to another.
BalancePoint stage(const Values& from, const Values& to, const Rule& elastic, const Rule& interaction) {
  BalancePoint at;
  at.elastic = at.interaction = {from.data(), nullptr, to.data()};
  at.elastic_rule = &elastic;
  at.interaction_rule = &interaction;
  return at;
}

TEST(BalanceTest, TheTangentIsTheDerivativeByTheEndOfAStage) {
  const BodyOnWall body(2);
  const Values from = body.field(0.02, 0), to = body.field(0.03, 1), a = body.field(0.3, 2), way = body.field(1, 3);
  const Rule end = end_rule(), gauss = gauss_rule(2), exact = exact_rule();
  for (const auto& [elastic, interaction] : {std::pair{&end, &end}, std::pair{&gauss, &gauss}, {&gauss, &exact}}) {
    const auto at = [&, e = elastic, i = interaction](const Values& u) {
      BalancePoint point = stage(from, u, *e, *i);
      point.acceleration = a.data();
      point.mass = 2.5;
      return point;
    };
    body.expect_derivative(body.product(at(to), {0, 0, 1}, nullptr, way),
                           [&](double s) { return body.sum(at(test::moved(to, s, way))); });
  }
}

TEST(BalanceTest, TheTangentsOfAStateAreTheDerivativesByItsThreeVectors) {
  const BodyOnWall body(3);
  const Values u = body.field(0.02, 0), v = body.field(0.1, 1), a = body.field(0.3, 2), way = body.field(1, 3);
  const Rule end = end_rule();
  const auto at = [&](const Values& to, const Values& velocity, const Values& acceleration) {
    BalancePoint point = stage(to, to, end, end);
    point.acceleration = acceleration.data();
    point.rates = Rates::State;
    point.velocity = velocity.data();
    return point;
  };
  body.expect_derivative(body.product(at(u, v, a), {0, 0, 1}, nullptr, way),
                         [&](double s) { return body.sum(at(test::moved(u, s, way), v, a)); });
  body.expect_derivative(body.product(at(u, v, a), {0, 1, 0}, nullptr, way),
                         [&](double s) { return body.sum(at(u, test::moved(v, s, way), a)); });
  body.expect_derivative(body.product(at(u, v, a), {1, 0, 0}, nullptr, way),
                         [&](double s) { return body.sum(at(u, v, test::moved(a, s, way))); });
}

TEST(BalanceTest, ForcesAreTheGradientOfThePotential) {
  const BodyOnWall body(2);
  const Values from = body.field(0.02, 0), to = body.field(0.03, 1), way = body.field(1, 3);
  for (const Rule& rule : {end_rule(), gauss_rule(3)}) {
    double potential_along_way = test::derivative(
        [&](double s) {
          const Values u = test::moved(to, s, way);
          return Balance(body.model).potential(stage(from, u, rule, rule)).value;
        },
        1e-3);
    body.model.space().sum(&potential_along_way, 1);
    const Values f = body.sum(stage(from, to, rule, rule));
    EXPECT_NEAR(potential_along_way, body.total(f, way), 1e-9 * std::sqrt(body.total(f, f) * body.total(way, way)));
  }
}

TEST(BalanceTest, WhatTermsKeepOfAForceGivesItsTangent) {
  const BodyOnWall body(3);
  const Values from = body.field(0.02, 0), to = body.field(0.03, 1), way = body.field(1, 3);
  const Rule rule = gauss_rule(2);
  const BalancePoint at = stage(from, to, rule, rule);
  Balance balance(body.model);
  KeptForces kept = balance.sums().create_kept();
  ASSERT_TRUE(balance.evaluate(at, &kept));
  const Values with = body.product(at, {1.5, 0, 1}, &kept, way), without = body.product(at, {1.5, 0, 1}, nullptr, way);
  EXPECT_LT(test::distance(with, without), 1e-13 * std::sqrt(body.total(without, without)));
}

TEST(BalanceTest, AFixedForceIsAddedAndABodyBelowItsWallIsInadmissible) {
  const BodyOnWall body(2);
  const Values u = body.field(0.02, 0), fixed = body.field(3, 1);
  const Rule end = end_rule();
  Balance balance(body.model);
  const BalancePoint at = stage(u, u, end, end);
  ASSERT_TRUE(balance.evaluate(at));
  const auto owned = static_cast<std::size_t>(body.model.space().owned());
  Values with(owned), without(owned);
  balance.sum(at, fixed.data(), with.data());
  balance.sum(at, nullptr, without.data());
  for (std::size_t i = 0; i < owned; ++i) EXPECT_NEAR(with[i] - without[i], fixed[i], 1e-14);
  Values below(u.size());
  for (std::size_t i = 1; i < below.size(); i += 2) below[i] = -0.7;
  double admissible = balance.evaluate(stage(below, below, end, end)) ? 1 : 0, ranks = 1;
  body.model.space().sum(&admissible, 1);
  body.model.space().sum(&ranks, 1);
  EXPECT_LT(admissible, ranks);
}

}  // namespace
}  // namespace ixos

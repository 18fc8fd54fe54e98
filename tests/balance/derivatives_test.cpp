// Derivatives of the balance by time, before an obstacle that moves and turns and with a load that changes, and by the
// numbers that terms name.
#include "balance/derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "model/conditions.hpp"
#include "model/surface_interaction.hpp"
#include "support/derivative.hpp"
#include "support/solids.hpp"
#include "support/time_functions.hpp"

namespace ixos {
namespace {

using Values = std::vector<double>;

struct Setting {
  double modulus = 1, law = 1;  ///< factors
  bool turns = true;
};

/// A box above a wall that moves, turns and sticks to it; a traction pulls its top.
std::unique_ptr<Model> box_on_moving_wall(int dimension, const Setting& setting) {
  auto model = test::box_with_contact(dimension, ContactElement::Q1C2);
  if (setting.modulus != 1) {
    Material material = model->materials().front();
    material.law = neo_hooke(lame_constants(setting.modulus, 0.3));
    model = std::make_unique<Model>(LocalMesh(model->mesh()), model->space().comm(), std::vector<Material>{material},
                                    Inertia::None);
  }
  const auto d = static_cast<std::size_t>(dimension);
  RigidMotionOptions options;
  options.translation = {test::polynomial(0.05, -0.02), test::polynomial(-0.02, 0.01), test::polynomial(-0.03, 0.01)};
  options.translation.resize(d);
  options.point = {0.2, -0.4, 0.1};
  options.point.resize(d);
  if (setting.turns) options.angle = test::polynomial(0.04, 0.02);
  if (setting.turns && dimension == 3) options.axis = {1, 2, 2};
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = make_obstacle("Half-Space", d, {});
  wall.motion = RigidMotion(dimension, options);
  const double factor = setting.law;
  if (factor != 1) wall.factor = [factor](const std::array<double, 3>&) { return factor; };
  add_interaction(*model, wall);
  Values pull(d, 0.0);
  pull.back() = 0.3;
  add_traction(*model, "top", pull, test::polynomial(0.7, 0.4));
  return model;
}

struct Way {
  Values from, to;
  BalancePoint at(double start, const Rule& rule) const {
    BalancePoint point;
    point.elastic = point.interaction = {from.data(), nullptr, to.data(), start, 0.5};
    point.elastic_rule = point.interaction_rule = &rule;
    return point;
  }
};

Way way_of(const Model& model) { return {test::smooth_field(model, 0.02), test::smooth_field(model, -0.015)}; }

/// Forces less loads, in owned rows.
Values sum(const Model& model, const BalancePoint& at) {
  Balance balance(model);
  EXPECT_TRUE(balance.evaluate(at));
  Values load(static_cast<std::size_t>(model.space().local()), 0.0),
      result(static_cast<std::size_t>(model.space().owned()));
  model.loads().add_force(at.elastic.start + at.elastic.length, -1, load.data());
  balance.sum(at, load.data(), result.data());
  return result;
}

double largest(const Values& x) {
  double result = 0;
  for (double value : x) result = std::max(result, std::abs(value));
  return result;
}

TEST(BalanceDerivativesTest, ByTimeIsTheChangeWhileObstaclesAndLoadsMove) {
  for (const int dimension : {2, 3})
    for (const bool turns : {false, true}) {
      const auto model = box_on_moving_wall(dimension, {1, 1, turns});
      const Way way = way_of(*model);
      for (const Rule& rule : {end_rule(), gauss_rule(3)}) {
        Values rate(static_cast<std::size_t>(model->space().local()));
        const BalanceDerivatives derivatives(*model);
        ASSERT_TRUE(derivatives.has_time_derivative(way.at(1, rule)));
        derivatives.by_time(way.at(1, rule), rate.data());
        const double scale = largest(rate);
        for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); ++i)
          EXPECT_NEAR(test::derivative([&](double s) { return sum(*model, way.at(1 + s, rule))[i]; }, 1e-3), rate[i],
                      1e-9 * scale)
              << dimension << "D, turns " << turns << ", " << i;
      }
    }
}

TEST(BalanceDerivativesTest, AMeanBeforeAMovingObstacleHasNoneByTime) {
  const auto model = box_on_moving_wall(2, {});
  const Way way = way_of(*model);
  const Rule exact = exact_rule();
  BalancePoint at = way.at(1, exact);
  const Rule gauss = gauss_rule(2);
  at.elastic_rule = &gauss;
  const BalanceDerivatives derivatives(*model);
  EXPECT_FALSE(derivatives.has_time_derivative(at));
  Values rate(static_cast<std::size_t>(model->space().local()));
  EXPECT_THROW(derivatives.by_time(at, rate.data()), std::logic_error);
}

TEST(BalanceDerivativesTest, ByAParameterIsTheDifferenceOfTwoModels) {
  for (const int dimension : {2, 3}) {
    const auto model = box_on_moving_wall(dimension, {});
    const Way way = way_of(*model);
    const Rule rule = gauss_rule(2);
    const BalanceDerivatives derivatives(*model);
    const std::vector<TermParameter> all = derivatives.parameters();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].term + ", " + all[0].name, "body, Modulus Factor");
    EXPECT_EQ(all[1].term + ", " + all[1].name, "interaction, Law Factor");
    for (const TermParameter& parameter : all) {
      const auto at = [&](double factor) {
        Setting setting;
        (parameter.name == "Law Factor" ? setting.law : setting.modulus) = factor;
        const auto other = box_on_moving_wall(dimension, setting);
        return sum(*other, way.at(1, rule));
      };
      const Values more = at(1.25), less = at(0.75);
      Values df(static_cast<std::size_t>(model->space().local()));
      ASSERT_TRUE(derivatives.by_parameter(way.at(1, rule), parameter, df.data()));
      for (std::size_t i = 0; i < more.size(); ++i)
        EXPECT_NEAR((more[i] - less[i]) / 0.5, df[i], 1e-12 * largest(df)) << parameter.name << ", " << i;
    }
  }
}

TEST(BalanceDerivativesTest, ATermRefusesANumberThatItDoesNotHave) {
  const auto model = box_on_moving_wall(2, {});
  const Way way = way_of(*model);
  const Rule rule = end_rule();
  Values df(static_cast<std::size_t>(model->space().local()));
  const BalanceDerivatives derivatives(*model);
  EXPECT_THROW(derivatives.by_parameter(way.at(1, rule), {"body", "Law Factor"}, df.data()), std::logic_error);
  EXPECT_THROW(derivatives.by_parameter(way.at(1, rule), {"none", "Modulus Factor"}, df.data()), std::logic_error);
}

TEST(BalanceDerivativesTest, ALoadWithoutARateHasNoDerivativeByTime) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C1);
  add_traction(*model, "top", {0, 0.3}, function_of_time([](double t) { return TimeValue{t * t, 0, 0}; }));
  const Way way = way_of(*model);
  const Rule rule = end_rule();
  EXPECT_FALSE(BalanceDerivatives(*model).has_time_derivative(way.at(1, rule)));
  const auto constant_load = test::box_with_contact(2, ContactElement::Q1C1);
  add_traction(*constant_load, "top", {0, 0.3}, constant(1));
  EXPECT_TRUE(BalanceDerivatives(*constant_load).has_time_derivative(way.at(1, rule)));
}

}  // namespace
}  // namespace ixos

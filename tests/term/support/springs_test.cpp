#include "term/support/springs.hpp"

#include <gtest/gtest.h>

#include "mesh/generators/shapes.hpp"
#include "model/model.hpp"
#include "support/by_hand.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// On one rank: nodes 0 and 2 of a square, whose ends move by w = (3 t, t^2) and (-t, 0).
struct SpringsSerialTest : ::testing::Test {
  std::unique_ptr<Model> model =
      test::model_of(box(BoxShape{}), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
  std::size_t local = test::at_rest(*model).size();

  static DrivenEnds ends() {
    const auto to = std::make_shared<Constraints>();
    to->add(0, 3.0, function_of_time([](double t) { return TimeValue{t, 1, 0}; }));
    to->add(1, 1.0, function_of_time([](double t) { return TimeValue{t * t, 2 * t, 2}; }));
    to->add(4, -1.0, function_of_time([](double t) { return TimeValue{t, 1, 0}; }));
    return {{0, 1, 4}, {2, 5, 7}, to};
  }
  std::vector<double> at(double x, double y, double z) const {
    std::vector<double> u(local, 0.5);
    u[0] = x;
    u[1] = y;
    u[4] = z;
    return u;
  }
};

TEST_F(SpringsSerialTest, ForceIsThatAtTheRulesMeanPlace) {
  const Springs springs(ends(), model->pattern(), local);
  const std::vector<double> from = at(1, 2, 3), to = at(3, -2, 7);
  const auto force = [&](const Rule& rule) {
    std::vector<double> f(local, 0.0);
    EXPECT_TRUE(springs.add_force({from.data(), nullptr, to.data()}, rule, f.data()));
    return std::vector<double>{f[0], f[1], f[4], f[3]};
  };
  EXPECT_EQ(force(end_rule()), (std::vector<double>{6, -10, 49, 0}));
  const std::vector<double> middle{4, 0, 35, 0};
  EXPECT_EQ(force(discrete_gradient_rule()), middle);
  EXPECT_EQ(force(point_rule({0.5}, {1.0})), middle);
  const std::vector<double> gauss = force(gauss_rule(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(gauss[i], middle[i], 1e-14);
}

TEST_F(SpringsSerialTest, TangentIsTheDerivative) {
  const Springs springs(ends(), model->pattern(), local);
  const Rule rule = point_rule({0.5}, {1.0});
  const std::vector<double> u = at(1, 1, 1);
  std::vector<double> values(static_cast<std::size_t>(model->pattern().pairs()) * 4, 0.0);
  springs.add_tangent({u.data(), nullptr, u.data()}, rule, Tangent::Exact, values.data());
  const auto action = springs.create_action();
  action->linearize({u.data(), nullptr, u.data()}, rule, Tangent::Exact, {});
  std::vector<double> product(local, 0.0), diagonal(local, 0.0);
  action->add_product(u.data(), product.data());
  action->add_diagonal(diagonal.data());
  model->pattern().for_each_row(values.data(), [&](int row, const auto& entries) {
    const double k = row == 0 ? 2 : row == 1 ? 5 : row == 4 ? 7 : 0;
    entries([&](int column, double value) { EXPECT_EQ(value, column == row ? k / 2 : 0); });
    EXPECT_EQ(product[static_cast<std::size_t>(row)], k / 2);
    EXPECT_EQ(diagonal[static_cast<std::size_t>(row)], k / 2);
  });
}

TEST_F(SpringsSerialTest, EnergyIsThatOfTheStretch) {
  Springs springs(ends(), model->pattern(), local);
  const std::vector<double> u = at(1, 2, 3), after = at(2, 2, 2);
  const double first = springs.energy({u.data()}) + springs.stretch_energy(2, u.data());
  EXPECT_NEAR(first, (2 * 25 + 5 * 4 + 7 * 25) / 2.0, 1e-13);  // w = (6, 4, -2)
  const StepWork work = test::ByHand<Springs>(springs).step(u.data(), after.data(), 2, 1);
  EXPECT_EQ(work.dissipated, 0);
  EXPECT_NEAR(work.driven, springs.stretch_energy(3, after.data()) - springs.stretch_energy(2, u.data()), 1e-13);
}

TEST_F(SpringsSerialTest, DashpotsDissipateByTheirRelativeVelocity) {
  Dashpots dashpots(ends(), model->pattern(), local);
  const std::vector<double> u(local, 0.0), v = at(4, 0, 1), w = at(2, 6, -1);
  std::vector<double> f(local, 0.0);
  dashpots.add_force_at(-1, u.data(), v.data(), f.data());
  EXPECT_EQ(f[0], -8);
  EXPECT_EQ(f[4], -7);
  // Two states, each half of the step: w' = (3, 2 t, -1) at t = 0 and 2.
  const WorkSum stages{WorkSum::Form::Stages, {0.5, 0.5}};
  const Row row{};
  StageStart start;
  start.known = {{u.data(), v.data()}};
  start.velocity = start.damping = &row;
  start.length = start.dt = 2;
  test::ByHand<Dashpots> steps(dashpots);
  steps.begin_stage(start);
  const StepWork work =
      steps.accept({{{u.data(), v.data(), nullptr, 0}, {u.data(), w.data(), nullptr, 2}}, &stages, 2});
  EXPECT_NEAR(work.dissipated, 2 * 1 + 5 * 0 + 7 * 4 + 2 * 1 + 5 * 4 + 7 * 0, 1e-13);
  const double own = 2 * 16 + 5 * 0 + 7 * 1 + 2 * 4 + 5 * 36 + 7 * 1;
  EXPECT_NEAR(work.driven, work.dissipated - own, 1e-12);
}

}  // namespace
}  // namespace ixos

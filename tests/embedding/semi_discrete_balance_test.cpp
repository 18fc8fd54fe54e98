// The parts of the balance, against sums and differences that are known.
#include "embedding/semi_discrete_balance.hpp"

#include <gtest/gtest.h>

#include "solve/semi_discrete_bodies.hpp"
#include "support/reports.hpp"

namespace ixos {
namespace {

/// The sum over all nodes along each axis.
std::vector<double> total(const Model& model, const std::vector<double>& force) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  std::vector<double> sums(d, 0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i) sums[i % d] += force[i];
  model.space().sum(sums.data(), static_cast<int>(d));
  return sums;
}

class SemiDiscreteBalanceTest : public testing::TestWithParam<int> {};

TEST_P(SemiDiscreteBalanceTest, PartsHaveTheTotalsOfARigidMotion) {
  const auto s = test::held_block(GetParam());
  const Model& model = s->model();
  const double mass = 0.7 * 8;
  const Vector u(model.space().owned_map()), v = test::uniform(model, 0.5, 1), a = test::uniform(model, 2, 0);
  SemiDiscreteBalance balance(model);
  balance.set({&u, &v, &a, 3.0});
  ASSERT_TRUE(balance.admissible());
  EXPECT_NEAR(total(model, balance.force(NodalForce::Inertia))[0], 2 * mass, 1e-12);
  EXPECT_NEAR(total(model, balance.force(NodalForce::Inertia))[1], 0, 1e-12);
  // A rigid motion: damping by mass only.
  EXPECT_NEAR(total(model, balance.force(NodalForce::Damping))[1], 0.3 * 0.5 * mass, 1e-12);
  EXPECT_NEAR(total(model, balance.force(NodalForce::External))[0], 0.01 * 4 * 2, 1e-14);
  EXPECT_NEAR(total(model, balance.force(NodalForce::Elastic))[0], 0, 1e-13);
  const std::vector<double> by_wall = test::ReportAt(model, balance.displacement().data()).interaction_report().force;
  const std::vector<double> interaction = total(model, balance.force(NodalForce::Interaction));
  for (std::size_t i = 0; i < by_wall.size(); ++i) EXPECT_NEAR(interaction[i], -by_wall[i], 1e-13);
  EXPECT_GT(std::abs(by_wall.back()), 1e-3);
}

TEST_P(SemiDiscreteBalanceTest, TheResidualIsTheSumWithMotionsInConstrainedRows) {
  const auto s = test::held_block(GetParam());
  const Model& model = s->model();
  const Vector u = test::wave(model, 0.02, 0), v = test::wave(model, 0.1, 1), a = test::wave(model, 0.3, 2);
  SemiDiscreteBalance balance(model);
  balance.set({&u, &v, &a, 2.0});
  std::vector<double> expected(static_cast<std::size_t>(model.space().local()), 0.0);
  for (const auto part : {NodalForce::Inertia, NodalForce::Damping, NodalForce::Elastic, NodalForce::Interaction}) {
    const std::vector<double>& force = balance.force(part);
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += force[i];
  }
  const std::vector<double>& load = balance.force(NodalForce::External);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] -= load[i];
  Vector f(model.space().owned_map());
  balance.residual(f);
  const auto view = f.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t i = 0; i < view.extent(0); ++i) {
    EXPECT_NEAR(balance.sum()[i], expected[i], 1e-15);
    const double moved = balance.displacement()[i] - (i % d == 0 ? 0.2 : 0.0);
    EXPECT_NEAR(view(i, 0), model.constraints().holds(static_cast<int>(i)) ? moved : expected[i], 1e-15);
  }
}

TEST_P(SemiDiscreteBalanceTest, RatesThatAreNotGivenAreZero) {
  const auto s = test::held_block(GetParam());
  const Model& model = s->model();
  const Vector u = test::wave(model, 0.02, 0), zero(model.space().owned_map());
  SemiDiscreteBalance without(model), with(model);
  without.set({&u, nullptr, nullptr, 1.0});
  with.set({&u, &zero, &zero, 1.0});
  EXPECT_EQ(without.sum(), with.sum());
  EXPECT_EQ(without.velocity(), with.velocity());
}

TEST_P(SemiDiscreteBalanceTest, JudgesEachStateOnAllRanksAlike) {
  const auto s = test::held_block(GetParam());
  const Model& model = s->model();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const Vector rest(model.space().owned_map()), below = test::uniform(model, -0.7, d - 1);
  // One element turned inside out, on one rank.
  Vector inverted(model.space().owned_map());
  if (model.space().comm()->getRank() == 0) inverted.getLocalViewHost(Tpetra::Access::ReadWrite)(0, 0) = 5;
  SemiDiscreteBalance balance(model);
  for (int repeat = 0; repeat < 2; ++repeat)
    for (const auto& [u, admissible] : {std::pair{&rest, true}, {&below, false}, {&rest, true}, {&inverted, false}}) {
      balance.set({u, nullptr, nullptr, 0.0});
      EXPECT_EQ(balance.admissible(), admissible);
      balance.set({u, nullptr, nullptr, 1.0});
      EXPECT_EQ(balance.admissible(), admissible);  // a verdict on the same displacement
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SemiDiscreteBalanceTest, testing::Values(2, 3));

}  // namespace
}  // namespace ixos

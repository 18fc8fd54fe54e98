// The stable step of explicit schemes, against eigenvalues and against what longer steps do.
#include "time/stable_step.hpp"

#include <gtest/gtest.h>

#include <Teuchos_LAPACK.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <cmath>

#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::self;
using test::word;

/// A block that spins and stretches near a wall.
std::string near_wall(double gap, const std::string& damping = "") {
  std::string body = test::block_2d(0.5);
  body.insert(body.find(number("Density", 1)), damping);
  return body + list("Interactions",
                     list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -gap}) + number("Gamma W", 0.02)));
}

/// The highest frequency of M^-1 K at u, from all eigenvalues.
double highest_frequency(const Simulation& s, const std::vector<double>& u) {
  const Model& model = s.model();
  const int n = model.space().owned();
  const auto matrix = model.pattern().create_matrix(model.space());
  double* values = matrix->getLocalMatrixHost().values.data();
  const Segment here{nullptr, nullptr, u.data()};
  TermSums(model).add_tangent(Part::Elastic, here, end_rule(), Tangent::Exact, values);
  TermSums(model).add_tangent(Part::Interaction, here, end_rule(), Tangent::Exact, values);
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> dense(size * size), unit(size), column(size), real(size), imaginary(size), work(8 * size);
  Vector x(model.space().owned_map()), y(model.space().owned_map());
  for (std::size_t j = 0; j < size; ++j) {
    x.putScalar(0);
    x.replaceLocalValue(static_cast<LocalId>(j), 1.0);
    matrix->apply(x, y);
    const auto view = y.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < size; ++i) unit[i] = view(i, 0);
    model.mass()->divide(unit.data(), column.data());
    std::copy(column.begin(), column.end(), dense.begin() + static_cast<std::ptrdiff_t>(j * size));
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().GEEV('N', 'N', n, dense.data(), n, real.data(), imaginary.data(), nullptr, 1, nullptr,
                                      1, work.data(), static_cast<int>(work.size()), &info);
  EXPECT_EQ(info, 0);
  return std::sqrt(*std::max_element(real.begin(), real.end()));
}

TEST(StableStepSerialTest, BoundsTheHighestFrequency) {
  // Far from the wall, near it, and in its repulsive part.
  for (double gap : {3.0, 0.3, 0.22}) {
    Simulation s(test::scene(near_wall(gap) + test::time_integrator("Central Difference", 0.01, 1)), self());
    const State& state = s.integrator().state();
    const double bound = StableStep(s.model(), 1.0)(state, 1e9);
    std::vector<double> there = state.u;
    for (std::size_t i = 0; i < there.size(); ++i) there[i] += bound * (state.v[i] + bound / 2 * state.a[i]);
    const double exact = 2 / std::max(highest_frequency(s, state.u), highest_frequency(s, there));
    EXPECT_LT(bound, exact) << gap;
    EXPECT_GT(bound, 0.3 * exact) << gap;
    EXPECT_EQ(s.integrator().stable_step(1e-6), 1e-6);
  }
}

TEST(StableStepSerialTest, LooksWhereTheStepLeads) {
  // A body that flies at the wall so fast that the bound at its start would lead through it.
  Simulation s(test::scene(near_wall(0.35) + test::time_integrator("Central Difference", 0.01, 1)), self());
  State state = s.integrator().state();
  for (std::size_t i = 1; i < state.v.size(); i += 2) state.v[i] = -3;
  const double bound = StableStep(s.model(), 0.9)(state, 1e9);
  for (std::size_t i = 0; i < state.u.size(); ++i) state.u[i] += bound * (state.v[i] + bound / 2 * state.a[i]);
  EXPECT_GT(StateReport(s.model(), state).interaction_report().least_gap, 0.1);
  std::vector<double> sums(state.u.size(), 0.0);
  const Segment end{nullptr, nullptr, state.u.data()};
  TermSums(s.model()).add_row_sums(Part::Elastic, end, sums.data());
  ASSERT_TRUE(TermSums(s.model()).add_row_sums(Part::Interaction, end, sums.data()));
  EXPECT_LT(bound, 2 / std::sqrt(s.model().mass()->largest_quotient(sums.data())));
}

/// Returns the energies of an oscillator before and after each of 400 steps of this share of the true limit 2/omega.
std::vector<double> energies(double share) {
  Simulation s(test::scene(test::oscillator() + test::time_integrator("Central Difference", 0.01, 1)), self());
  const double dt = share * 2 / std::sqrt(2.0);  // half of the mass is lumped at the top, the stiffness is 1
  std::vector<double> result{test::total_energy(s)};
  for (int n = 0; n < 400; ++n) {
    EXPECT_TRUE(s.integrator().step(dt).converged) << share;
    result.push_back(test::total_energy(s));
  }
  return result;
}

// Velocity Verlet conserves v^2/2 + (1 - share^2) omega^2 u^2/2, a norm up to the limit. Beyond it one mode grows by
// exp(2 arcosh(share)) a step.
TEST(StableStepSerialTest, JustBelowTheLimitIsStableAndJustAboveIsNot) {
  for (double share : {0.1, 0.99}) {
    const auto below = energies(share);
    EXPECT_LT(*std::max_element(below.begin(), below.end()), below[0] / (1 - share * share) * (1 + 1e-9)) << share;
  }
  const auto above = energies(1.01);
  EXPECT_NEAR(std::log(above[400] / above[200]), 200 * 4 * std::acosh(1.01), 1e-6);
}

TEST(StableStepSerialTest, DampingShortensIt) {
  Simulation light(test::scene(near_wall(3) + test::time_integrator("Central Difference", 0.01, 1)), self());
  Simulation heavy(
      test::scene(near_wall(3, number("Mass Damping", 40)) + test::time_integrator("Central Difference", 0.01, 1)),
      self());
  const double w = 2 / light.integrator().stable_step(1e9), c = 40 / 0.4;
  EXPECT_NEAR(heavy.integrator().stable_step(1e9), 2 / (std::sqrt(w * w + c * c) + c), 1e-5);
  double energy = test::total_energy(heavy);
  for (int n = 0; n < 200; ++n) {
    ASSERT_TRUE(heavy.integrator().step(heavy.integrator().stable_step(1e9)).converged);
    EXPECT_LT(test::total_energy(heavy), energy * 1.001);
    energy = std::max(test::total_energy(heavy), 1e-3);
  }
}

}  // namespace
}  // namespace ixos

// Maxwell branches in motion: closed forms of a vibration and of relaxation, the balance of energy, rejected steps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "histories/time_function.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using Branches = std::vector<MaxwellBranch>;

std::unique_ptr<Model> viscoelastic(const Mesh& mesh, Material material, Inertia inertia, const Branches& branches,
                                    HistoryUpdate update = HistoryUpdate::BackwardEuler) {
  material.branches = branches;
  material.history_update = update;
  return test::model_of(mesh, material, inertia);
}

Mesh block(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 1};
  shape.divisions = {3, 2, 1};
  return box(shape);
}

/// A square of one cell whose top moves up and down as a whole above a base that is held: w^2 = 3 (U + branches).
std::unique_ptr<Model> oscillator(const Branches& branches, HistoryUpdate update) {
  auto model = viscoelastic(box({}), test::elastic(linear_elastic, 0), Inertia::Consistent, branches, update);
  prescribe(*model, "bottom", "all");
  prescribe(*model, "top", "x");
  return model;
}

/// Integrates U'' = -3 [U + 4/3 mu (U - q)], q' = (U - q)/tau, by Runge and Kutta's method from U = q = 0 at a speed.
/// The branch sees the deviator of a uniaxial strain, hence 4/3.
class Oscillator {
 public:
  Oscillator(const MaxwellBranch& branch, double speed) : branch_(branch), state_{0, speed, 0} {}
  double advance(double time) {
    const int steps = 1000;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
      const State k1 = rate(state_), k2 = rate(moved(k1, h / 2)), k3 = rate(moved(k2, h / 2)), k4 = rate(moved(k3, h));
      for (std::size_t j = 0; j < 3; ++j) state_[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    }
    return state_[0];
  }

 private:
  using State = std::array<double, 3>;
  State rate(const State& s) const {
    return {s[1], -3 * (s[0] + 4.0 / 3 * branch_.modulus * (s[0] - s[2])), (s[0] - s[2]) / branch_.time};
  }
  State moved(const State& rate, double h) const {
    State result = state_;
    for (std::size_t j = 0; j < 3; ++j) result[j] += h * rate[j];
    return result;
  }
  MaxwellBranch branch_;
  State state_;
};

/// Returns the largest error of the top's displacement up to t = 5 over the speed at which it starts.
double oscillation_error(const Table& table, HistoryUpdate update, double dt) {
  const MaxwellBranch branch{0.3, 0.4};
  const double speed = 1e-4;
  const auto model = oscillator({branch}, update);
  std::vector<double> v = test::at_rest(*model);
  for (std::size_t i = 1; i < v.size(); i += 2) v[i] = speed * model->mesh().coordinates[i];
  Integrator integrator = test::direct(*model, table, 1e-13);
  integrator.initialize(test::at_rest(*model), v, 0);
  Oscillator expected(branch, speed);
  double worst = 0;
  for (int step = 0; step < std::lround(5 / dt); ++step) {
    EXPECT_TRUE(integrator.step(dt).converged) << table.name;
    const std::vector<double>& u = integrator.state().u;
    double top = 0;
    for (std::size_t i = 1; i < u.size(); i += 2) top = std::abs(u[i]) > std::abs(top) ? u[i] : top;
    const double highest = model->space().maximum(top), lowest = -model->space().maximum(-top);
    top = highest > -lowest ? highest : lowest;
    worst = std::max(worst, std::abs(top - expected.advance(dt)) / speed);
  }
  return worst;
}

TEST(ViscoelasticityTest, AVibrationDecaysAsThatOfAStandardSolid) {
  const Table tables[] = {newmark(0.25, 0.5),
                          bathe_composite(0, 0.5),
                          generalized_alpha(0.8),
                          midpoint(),
                          gautam_sauer_composite(0.25, 0.5, 2, Path::Linear),
                          average_vector_field(2, 1)};
  for (const Table& table : tables) {
    const double error = oscillation_error(table, HistoryUpdate::BackwardEuler, 0.02);
    const double finer = oscillation_error(table, HistoryUpdate::BackwardEuler, 0.01);
    EXPECT_LT(finer, 2e-2) << table.name;
    EXPECT_GT(error, 1.6 * finer) << table.name << ": the history is of first order";
  }
  for (const Table& table : {average_vector_field(2, 1), midpoint()}) {
    const double error = oscillation_error(table, HistoryUpdate::SecondOrder, 0.04);
    const double finer = oscillation_error(table, HistoryUpdate::SecondOrder, 0.02);
    EXPECT_LT(finer, 1e-3) << table.name;
    EXPECT_GT(error, 3.2 * finer) << table.name << ": the second order";
  }
}

// A square is sheared by g in the first step and held. The energy of a branch falls by (1 + dt/tau)^-2 a step, which is
// dissipated.
TEST(ViscoelasticityTest, StressRelaxesWithoutInertia) {
  const double g = 1e-4, dt = 0.02;
  const Branches branches{{0.5, 0.1}, {0.25, 1}};
  const auto model = viscoelastic(box({}), test::elastic(neo_hooke, 0.3), Inertia::None, branches);
  prescribe(*model, "bottom", "all");
  prescribe(*model, "top", "y");
  prescribe(*model, "top", "x", value_ramp(g, 0, dt, RampShape::Linear));
  Integrator integrator = test::direct(*model, static_equilibrium(), 1e-13);
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
  const double mu = 1 / 2.6;
  for (int step = 1; step <= 50; ++step) {
    ASSERT_TRUE(integrator.step(dt).converged);
    double energy = mu, stress = mu;
    for (const MaxwellBranch& branch : branches) {
      const double left = std::pow(1 + dt / branch.time, -step);
      energy += branch.modulus * left * left;
      stress += branch.modulus * left;
    }
    EXPECT_NEAR(StateReport(*model, integrator.state()).energy(Part::Elastic), energy * g * g / 2, 1e-6 * g * g);
    double force = 0;
    for (int dof : model->constraints().dofs())
      if (dof % 2 == 0 && dof < model->space().owned() &&
          model->mesh().coordinates[static_cast<std::size_t>(dof) + 1] > 0.5)
        force += integrator.state().reaction[static_cast<std::size_t>(dof)];
    model->space().sum(&force, 1);
    EXPECT_NEAR(force, stress * g, 1e-6 * g) << step;
  }
  // D = [E_n(u) - psi(u, q)] - [E_n(u_n) - psi(u_n, q_n)], E_n of lag l: mu l^2/2 r; psi after the step: mu (r l)^2/2.
  double lost = 0;
  for (const MaxwellBranch& branch : branches) {
    const double r = 1 / (1 + dt / branch.time);
    lost += branch.modulus * g * g / 2 * (r - std::pow(r, 2 * 50));
  }
  EXPECT_NEAR(integrator.dissipated_energy(), lost, 1e-6 * lost);
}

// Nothing moves but the histories, so the local error is theirs: that of half of Ci over a square of side 1.
TEST(ViscoelasticityTest, AdaptiveStepsAreJudgedByTheHistory) {
  const double g = 1e-4, dt = 0.02, mu = 1 / 2.6;
  const MaxwellBranch branch{0.5, 0.1};
  const double x = dt / branch.time;
  const auto model = viscoelastic(box({}), test::elastic(neo_hooke, 0.3), Inertia::Consistent, {branch});
  prescribe(*model, "bottom", "all");
  prescribe(*model, "top", "y");
  prescribe(*model, "top", "x", value_ramp(g, -2, 1, RampShape::Linear));
  Integrator integrator = test::direct(*model, newmark(0.25, 0.5), 1e-13);
  std::vector<double> u = test::at_rest(*model);
  for (std::size_t i = 0; i < u.size(); i += 2) u[i] = g * model->mesh().coordinates[i + 1];
  integrator.initialize(u, test::at_rest(*model), 0);
  for (int step = 0; step < 3; ++step) {
    ASSERT_TRUE(integrator.attempt(dt).converged);
    const double lag = g * std::pow(1 + x, -step);
    const double expected = branch.modulus / (mu + branch.modulus) * lag * (1 / (1 + x) - std::exp(-x)) / std::sqrt(2);
    EXPECT_NEAR(integrator.error(), expected, 1e-5 * expected) << step;
    integrator.accept();
  }
}

/// A velocity that turns and stretches a block.
std::vector<double> motion(const Model& model) {
  std::vector<double> v = test::at_rest(model);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t i = 0; i < v.size(); i += d) {
    const double x = model.mesh().coordinates[i], y = model.mesh().coordinates[i + 1];
    v[i] = -0.5 * y + 0.3 * x;
    v[i + 1] = 0.5 * x - 0.2 * y + 0.1 * x * y;
  }
  return v;
}

double stored(const Model& model, const State& state) {
  return StateReport(model, state).momenta().kinetic_energy + StateReport(model, state).energy(Part::Elastic);
}

/// Returns the largest error of the balance over the energy, and checks that each step dissipates.
double imbalance(const Table& table, int dimension, const Branches& branches, double dt, int steps, double least = 0) {
  const auto model = viscoelastic(block(dimension), test::elastic(neo_hooke, 0.3), Inertia::Consistent, branches);
  EXPECT_EQ(model->dissipation_names(), std::vector<std::string>{"viscoelasticity of body"});
  Integrator integrator = test::direct(*model, table, 1e-13);
  integrator.initialize(test::at_rest(*model), motion(*model), 0);
  const double before = stored(*model, integrator.state());
  double worst = 0, last = 0;
  for (int step = 0; step < steps; ++step) {
    const StepResult result = integrator.step(dt);
    EXPECT_TRUE(result.converged) << table.name << ": " << result.reason;
    if (!result.converged) return 1;
    const double lost = integrator.dissipated_energy();
    EXPECT_GE(lost - last, least) << table.name;
    last = lost;
    worst = std::max(worst, std::abs(stored(*model, integrator.state()) + lost - before));
  }
  EXPECT_GT(last, 0.01 * before) << table.name;
  return worst / before;
}

TEST(ViscoelasticityTest, TheBalanceClosesWithTheMeanForce) {
  for (int dimension : {2, 3})
    for (double slowness : {0.01, 1.0, 100.0}) {
      const int steps = dimension == 2 && slowness == 1 ? 1000 : 200;
      EXPECT_LT(
          imbalance(average_vector_field(4, 1), dimension, {{0.5, 0.3 * slowness}, {0.2, 2 * slowness}}, 0.05, steps),
          1e-11);
    }
}

// Their D is a report of first order, which is not negative either.
TEST(ViscoelasticityTest, TheBalanceOfOtherSchemesClosesWithTheirOrder) {
  for (const Table& table : {newmark(0.25, 0.5), bathe_composite(0, 0.5), generalized_alpha(1), midpoint()}) {
    const Branches branches{{0.5, 0.3}, {0.2, 2}};
    const double error = imbalance(table, 2, branches, 0.05, 100), finer = imbalance(table, 2, branches, 0.025, 200);
    EXPECT_LT(error, 1e-2) << table.name;
    EXPECT_GT(error, 1.6 * finer) << table.name;
  }
}

// All cells of the block have the volume 1.
TEST(ViscoelasticityTest, TheFieldOfEnergySumsToTheStoredEnergy) {
  for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation})
    for (int dimension : {2, 3}) {
      Material material = test::elastic(neo_hooke, 0.3);
      material.formulation = formulation;
      const auto model = viscoelastic(block(dimension), material, Inertia::Consistent, {{0.5, 0.3}, {0.2, 2}});
      Integrator integrator = test::direct(*model, average_vector_field(3, 1));
      integrator.initialize(test::at_rest(*model), motion(*model), 0);
      for (int step = 0; step < 10; ++step) ASSERT_TRUE(integrator.step(0.1).converged);
      const StateReport report(*model, integrator.state());
      const CellFields fields = report.cell_fields()[0];
      const LocalBlock& cells = model->mesh().blocks[0];
      double sums[] = {0, 0};
      for (std::size_t cell = 0; cell < fields.energy_density.size(); ++cell) {
        if (cells.owned[cell] == 0) continue;
        sums[0] += fields.energy_density[cell];
        sums[1] += fields.dissipated[cell];
      }
      model->space().sum(sums, 2);
      EXPECT_NEAR(sums[0], report.energy(Part::Elastic), 1e-12 * sums[0]);
      EXPECT_NEAR(sums[1], integrator.dissipated_energy(), 1e-12 * sums[1]);
    }
}

TEST(ViscoelasticityTest, RejectedStepsLeaveNoTrace) {
  for (const Table& table : {newmark(0.25, 0.5), bathe_composite(0, 0.5), average_vector_field(3, 1)}) {
    const Branches branches{{0.5, 0.3}};
    const auto calm = viscoelastic(block(3), test::elastic(neo_hooke, 0.3), Inertia::Consistent, branches);
    const auto driven = viscoelastic(block(3), test::elastic(neo_hooke, 0.3), Inertia::Consistent, branches);
    Integrator one = test::direct(*calm, table), other = test::direct(*driven, table);
    one.initialize(test::at_rest(*calm), motion(*calm), 0);
    other.initialize(test::at_rest(*driven), motion(*driven), 0);
    Snapshot snapshot([&](Record& record) { other.transfer(record); });
    for (int step = 0; step < 5; ++step) {
      snapshot.save();
      EXPECT_TRUE(other.step(0.1).converged && other.step(0.03).converged);
      snapshot.restore();
      other.attempt(0.2);  // which nobody accepts
      snapshot.restore();
      EXPECT_TRUE(one.step(0.05).converged && other.step(0.05).converged);
      EXPECT_EQ(one.state().u, other.state().u) << table.name;
      EXPECT_EQ(one.dissipated_energy(), other.dissipated_energy()) << table.name;
    }
  }
}

TEST(ViscoelasticityTest, WhatDoesNotGoWithBranchesIsRefused) {
  const Branches branches{{0.5, 0.3}};
  const Material neo = test::elastic(neo_hooke, 0.3);
  const auto refusal = [&](const Table& table, HistoryUpdate update) {
    return test::refusal([&] {
      const auto model = viscoelastic(block(2), neo, table.mass, branches, update);
      test::direct(*model, table);
    });
  };
  EXPECT_EQ(refusal(central_difference(0.9), HistoryUpdate::BackwardEuler),
            "the Maxwell branches of block \"body\": the scheme \"Central Difference\" is explicit: its forces know no "
            "history within a step; use another scheme, such as \"Average Vector Field\"");
  EXPECT_EQ(refusal(energy_momentum(), HistoryUpdate::BackwardEuler),
            "the Maxwell branches of block \"body\": the scheme \"Energy-Momentum\" needs a discrete gradient, which "
            "branches do not have; use another scheme, such as \"Average Vector Field\"");
  EXPECT_EQ(
      refusal(newmark(0.25, 0.5), HistoryUpdate::SecondOrder),
      "the Maxwell branches of block \"body\": the scheme \"Newmark\" takes the elastic force at the end of a "
      "stage, which the history update \"Second Order\" does not fit; use another scheme, such as \"Average Vector "
      "Field\"");
  Material enhanced = neo;
  enhanced.formulation = Formulation::Enhanced;
  EXPECT_EQ(test::refusal([&] { viscoelastic(block(2), enhanced, Inertia::None, branches); }),
            "the material of block \"body\" is not allowed: Maxwell Branches are not there for Enhanced elements, "
            "which solve for their modes with the elastic "
            "law alone; use Standard or Mean Dilatation elements");
  Table ahead = newmark(0.25, 0.5);
  for (const auto& [points, weights] :
       {std::pair<std::vector<double>, std::vector<double>>{{0.2, 1}, {1.5, -0.5}}, {{0.2, 1}, {-0.5, 1.5}}}) {
    ahead.stages[0].elastic = point_rule(points, weights);
    test::expect_contains(refusal(ahead, HistoryUpdate::BackwardEuler),
                          fmt::format("takes the elastic force of stage 1 at a mean time of {} times the stage",
                                      weights[0] > 0 ? -0.2 : 1.4));
  }
  EXPECT_EQ(
      test::refusal([&] {
        viscoelastic(block(2), neo, Inertia::None, {{0.5, 0}});
      }),
      "the material of block \"body\" is not allowed: Maxwell Branches have a branch of modulus 0.5 and relaxation "
      "time 0; both must be greater than 0 and finite");
}

}  // namespace
}  // namespace ixos

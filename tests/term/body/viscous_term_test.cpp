// Viscosity of a block: against Rayleigh's stiffness damping at small strains, differences, and rigid motions.
#include "term/body/viscous_term.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "model/term_sums.hpp"
#include "model/traits.hpp"
#include "support/by_hand.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

constexpr double alpha = 0.2, nu = 0.3, dt = 0.1;

std::unique_ptr<Model> block(std::size_t dimension, double viscosity, double stiffness_damping = 0) {
  BoxShape shape;
  shape.lengths = {3, 2, dimension == 3 ? 1.0 : 0.0};
  shape.divisions = {3, 2, dimension == 3 ? 2 : 0};
  Material material = test::elastic(linear_elastic, nu);
  material.viscosity = viscosity;
  material.stiffness_damping = stiffness_damping;
  return test::model_of(box(shape), material, Inertia::Consistent);
}

/// A smooth field of the node's coordinates, equal on all ranks.
std::vector<double> field(const Model& model, double size, double phase) {
  std::vector<double> values = test::at_rest(model);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double angle = phase + 2.1 * static_cast<double>(i % d);
    for (std::size_t j = 0; j < d; ++j)
      angle += (0.7 + 0.4 * static_cast<double>(j)) * model.mesh().coordinates[i / d * d + j];
    values[i] = size * std::sin(angle);
  }
  return values;
}

std::vector<double> forces_at(const Model& model, const std::vector<double>& u, const std::vector<double>& v) {
  std::vector<double> f = test::at_rest(model);
  TermSums(model).add_rate_force_at(1.0, u.data(), v.data(), f.data());
  f.resize(static_cast<std::size_t>(model.space().owned()));
  return f;
}

TEST(ViscousTermTest, AtRestItIsStiffnessDamping) {
  for (std::size_t dimension : {2U, 3U}) {
    const auto viscous = block(dimension, alpha), damped = block(dimension, 0, alpha);
    const std::vector<double> rest = test::at_rest(*viscous), v = field(*viscous, 1, 0.3);
    const std::vector<double> found = forces_at(*viscous, rest, v), expected = forces_at(*damped, rest, v);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-13);
    std::vector<double> sums = rest, bound = rest;
    TermSums(*damped).add_rate_row_sums(rest.data(), bound.data());
    TermSums(*viscous).add_rate_row_sums(rest.data(), sums.data());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_GE(sums[i], bound[i] - 1e-13) << "of cells, then assembled";
  }
}

// u = (R - I) X and v = W R X: no force. Stiffness damping pulls at the rotated body.
TEST(ViscousTermTest, ARigidRotationHasNoForce) {
  const auto viscous = block(2, alpha), damped = block(2, 0, alpha);
  std::vector<double> u = test::at_rest(*viscous), v = u;
  const double angle = 1.2, spin = 3;
  for (std::size_t i = 0; i < u.size(); i += 2) {
    const double x = viscous->mesh().coordinates[i], y = viscous->mesh().coordinates[i + 1];
    const double to_x = std::cos(angle) * x - std::sin(angle) * y, to_y = std::sin(angle) * x + std::cos(angle) * y;
    u[i] = to_x - x;
    u[i + 1] = to_y - y;
    v[i] = -spin * to_y;
    v[i + 1] = spin * to_x;
  }
  for (double force : forces_at(*viscous, u, v)) EXPECT_NEAR(force, 0, 1e-13);
  double largest = 0;
  for (double force : forces_at(*damped, u, v)) largest = std::max(largest, std::abs(force));
  EXPECT_GT(viscous->space().maximum(largest), 0.1);
}

/// Returns K x of the matrix that `fill` fills.
template <class Fill>
std::vector<double> product(const Model& model, const std::vector<double>& x, const Fill& fill) {
  const auto matrix = model.pattern().create_matrix(model.space());
  double* values = matrix->getLocalMatrixHost().values.data();
  fill(values);
  return test::matrix_product(model, values, x);
}

/// Expects `found` to be the central difference of forces(+1) and forces(-1).
template <class Forces>
void expect_difference(const std::vector<double>& found, const Forces& forces) {
  const double step = 1e-5;
  const std::vector<double> high = forces(step), low = forces(-step);
  double largest = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], (high[i] - low[i]) / (2 * step), 1e-8);
    largest = std::max(largest, std::abs(found[i]));
  }
  EXPECT_GT(largest, 1e-3);
}

TEST(ViscousTermTest, TangentsAreDerivatives) {
  for (std::size_t dimension : {2U, 3U}) {
    const auto model = block(dimension, alpha);
    const std::vector<double> u = field(*model, 0.1, 0), v = field(*model, 1, 1), du = field(*model, 1, 2);
    expect_difference(
        product(*model, du, [&](double* k) { TermSums(*model).add_rate_tangent_at(1, 0, u.data(), v.data(), k); }),
        [&](double step) { return forces_at(*model, u, test::moved(v, step, du)); });
    expect_difference(
        product(*model, du, [&](double* k) { TermSums(*model).add_rate_tangent_at(0, 1, u.data(), v.data(), k); }),
        [&](double step) { return forces_at(*model, test::moved(u, step, du), v); });
  }
}

/// A stage of a table, begun at a state in motion.
struct Begun {
  Begun(const Model& model, const Table& table)
      : steps(model), u(field(model, 0.1, 0)), v(field(model, 1, 1)), a(field(model, 2, 4)) {
    start.known = {{u.data(), v.data(), a.data()}};
    start.velocity = &table.stages[0].velocity;
    start.damping = &table.stages[0].damping;
    start.rate_form = table.stages[0].rate_form;
    start.start_weight = table.stages[0].rate_start;
    start.dt = start.length = dt;
    steps.begin_stage(start);
  }
  test::ByHand<const Model> steps;
  std::vector<double> u, v, a;
  StageStart start;
};

std::vector<double> forces(const Model& model, const test::ByHand<const Model>& steps, const std::vector<double>& u) {
  std::vector<double> f = test::at_rest(model);
  TermSums(model).add_rate_force(steps.at(u.data()), f.data());
  f.resize(static_cast<std::size_t>(model.space().owned()));
  return f;
}

TEST(ViscousTermTest, AStagesTangentAndPotentialFitItsForce) {
  for (const Table& table : {newmark(0.25, 0.5), generalized_alpha(0.5), bathe_composite(0, 0.5)}) {
    SCOPED_TRACE(table.name);
    const auto model = block(2, alpha);
    const Begun begun(*model, table);
    const std::vector<double> u = field(*model, 0.15, 0.2), du = field(*model, 1, 2),
                              f = forces(*model, begun.steps, u);
    expect_difference(
        product(*model, du, [&](double* k) { TermSums(*model).add_rate_tangent(begun.steps.at(u.data()), k); }),
        [&](double step) { return forces(*model, begun.steps, test::moved(u, step, du)); });
    EXPECT_TRUE(rates_are_gradients(*model, table.stages[0].rate_form));
    const std::vector<double> high = test::moved(u, 1e-5, du), low = test::moved(u, -1e-5, du);
    double sums[3] = {0, TermSums(*model).rate_potential(begun.steps.at(high.data())),
                      TermSums(*model).rate_potential(begun.steps.at(low.data()))};
    for (std::size_t i = 0; i < f.size(); ++i) sums[0] += f[i] * du[i];
    model->space().sum(sums, 3);
    EXPECT_NEAR((sums[1] - sums[2]) / 2e-5, sums[0], 1e-8);
  }
}

// At the step's start the velocity rows give v_n again, whatever the state: the scheme's force there is f(u_n, v_n).
// For the trapezoid and a = 0 that is the row at u = u_n + dt v_n if strains are small.
TEST(ViscousTermTest, AnEvenSmallMotionHasTheForceOfItsVelocity) {
  const auto model = block(2, alpha);
  const Table table = newmark(0.25, 0.5);
  std::vector<double> u = field(*model, 1e-7, 0), v = field(*model, 1e-6, 1), a = test::at_rest(*model);
  StageStart start;
  start.known = {{u.data(), v.data(), a.data()}};
  start.velocity = &table.stages[0].velocity;
  start.damping = &table.stages[0].damping;
  start.dt = start.length = dt;
  test::ByHand<const Model> steps(*model);
  steps.begin_stage(start);
  const std::vector<double> end = test::moved(u, dt, v), found = forces(*model, steps, end),
                            expected = forces_at(*model, end, v);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(ViscousTermTest, WorkIsBookedAtThePointsAndInTheSum) {
  for (const Table& table :
       {newmark(0.25, 0.5), bathe_composite(0, 0.5), generalized_alpha(0.5), average_vector_field(2, 2), midpoint()}) {
    SCOPED_TRACE(table.name);
    const auto model = block(2, alpha);
    ASSERT_EQ(model->dissipation_names(), std::vector<std::string>{"viscosity of body"});
    Begun begun(*model, table);
    const std::vector<double> u = field(*model, 0.12, 0.1), v = field(*model, 1, 1.1);
    AcceptedStep step;
    step.states = {begun.start.known[0], {u.data(), v.data(), begun.a.data()}};
    if (table.stages.size() == 2) step.states.insert(step.states.begin() + 1, begun.start.known[0]);
    step.work = &table.work;
    step.dt = dt;
    const double work = begun.steps.accept(step).dissipated[0];
    begun.steps.in_step = true;  // its stage is looked at below
    EXPECT_GT(work, 1e-4);
    double stored = 0, volume = 0;
    const std::vector<CellFields> fields = StateReport(*model, begun.steps.at(u.data())).cell_fields();
    for (std::size_t cell = 0; cell < fields[0].dissipated.size(); ++cell) {
      if (model->mesh().blocks[0].owned[cell] == 0) continue;
      stored += fields[0].dissipated[cell];  // all cells are unit squares
      volume += 1;
    }
    double sums[] = {stored, volume};
    model->space().sum(sums, 2);
    EXPECT_EQ(sums[1], 6);
    EXPECT_NEAR(sums[0], work, 1e-13);
    test::ByHand<const Model> anew(*model);
    anew.initialize(u.data());
    const std::vector<CellFields> cleared = StateReport(*model, anew.at(u.data())).cell_fields();
    for (double density : cleared[0].dissipated) EXPECT_EQ(density, 0);
    // Against the forces: du . f for a momentum form, the mean of the ends for the trapezoid.
    if (table.work.form == WorkSum::Form::Stages) {
      double expected = 0;
      for (std::size_t i = 0; i < step.states.size(); ++i) {
        const KnownState& state = step.states[i];
        const std::vector<double> at(state.u, state.u + u.size()), rate(state.v, state.v + u.size());
        const std::vector<double> force = forces_at(*model, at, rate);
        for (std::size_t k = 0; k < force.size(); ++k) expected += dt * table.work.weights[i] * rate[k] * force[k];
      }
      model->space().sum(&expected, 1);
      EXPECT_NEAR(work, expected, 1e-13);
      continue;
    }
    const bool mean = table.work.form == WorkSum::Form::EndMean;
    const std::vector<double> end = mean ? forces_at(*model, u, v) : forces(*model, begun.steps, u),
                              first = forces_at(*model, begun.u, begun.v);
    double expected = 0;
    for (std::size_t i = 0; i < end.size(); ++i)
      expected += (u[i] - begun.u[i]) * (mean ? (first[i] + end[i]) / 2 : end[i]);
    model->space().sum(&expected, 1);
    EXPECT_NEAR(work, expected, 1e-13);
  }
}

}  // namespace
}  // namespace ixos

// Work over a step, of states that are written down: against sums over the whole mesh and against closed forms.
#include "time/work.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using Form = WorkSum::Form;

constexpr double mass = 0.7 * 6;
constexpr double dt = 0.1;

/// A block of 3 by 2.
std::unique_ptr<Model> block() {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {4, 3, 0};
  Material material = test::elastic(linear_elastic, 0.2);
  material.density = 0.7;
  return test::model_of(box(shape), material, Inertia::Consistent);
}

Table summing(Form form, const std::vector<double>& weights = {}) {
  Table table;
  table.work = {form, weights};
  return table;
}

/// Arbitrary numbers for each degree of freedom of the whole mesh: u, v, load or reaction of a state.
enum Quantity { U, V, Load, Reaction };
double number(std::size_t state, Quantity quantity, int dof) {
  return std::sin(1.0 + 0.7 * dof + 3.1 * static_cast<double>(state) + 11.3 * quantity);
}

/// Three states with those numbers.
std::vector<State> arbitrary_states(const Model& model) {
  std::vector<State> states(3);
  const auto owned = static_cast<std::size_t>(model.space().owned());
  for (std::size_t k = 0; k < 3; ++k) {
    for (int node : model.mesh().original_ids)
      for (int dof : {2 * node, 2 * node + 1}) {
        states[k].u.push_back(number(k, U, dof));
        states[k].v.push_back(number(k, V, dof));
        if (states[k].load.size() == owned) continue;
        states[k].load.push_back(number(k, Load, dof));
        states[k].reaction.push_back(number(k, Reaction, dof));
      }
  }
  return states;
}

/// Sums a function of the degree of freedom over the whole mesh.
template <class Term>
double total(const Model& model, const Term& term) {
  double sum = 0;
  for (int dof = 0; dof < static_cast<int>(model.space().global()); ++dof) sum += term(dof);
  return sum;
}

double force(std::size_t state, int dof) { return number(state, Load, dof) + number(state, Reaction, dof); }

TEST(WorkTest, ForcesAreSummedAsTheTableSays) {
  const auto model = block();
  const std::vector<State> states = arbitrary_states(*model);
  const auto increment = [](int dof) { return number(2, U, dof) - number(0, U, dof); };
  EXPECT_NEAR(work_of_external_forces(*model, summing(Form::Increment), states, dt),
              total(*model, [&](int dof) { return increment(dof) * force(2, dof); }), 1e-12);
  EXPECT_NEAR(work_of_external_forces(*model, summing(Form::EndMean), states, dt),
              total(*model, [&](int dof) { return increment(dof) * (force(0, dof) + force(2, dof)) / 2; }), 1e-12);
  const double weights[] = {0.2, 0.5, 0.3};
  const auto power = [&](int dof) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * number(k, V, dof) * force(k, dof);
    return sum;
  };
  EXPECT_NEAR(work_of_external_forces(*model, summing(Form::Stages, {0.2, 0.5, 0.3}), states, dt),
              dt * total(*model, power), 1e-12);
}

TEST(WorkTest, WithoutForcesThereIsNone) {
  const auto model = block();
  std::vector<State> states = arbitrary_states(*model);
  for (State& state : states) {
    state.load.clear();
    state.reaction.clear();
  }
  for (Form form : {Form::Increment, Form::EndMean, Form::Stages})
    EXPECT_EQ(work_of_external_forces(*model, summing(form, {0.2, 0.5, 0.3}), states, dt), 0);
}

/// Returns the state of a body that moves along x as one, and the forces M a that it needs.
State rigid(const Model& model, double u, double v, double a) {
  State state{test::at_rest(model), test::at_rest(model), test::at_rest(model), {}, {}};
  for (std::size_t i = 0; i < state.u.size(); i += 2) {
    state.u[i] = u;
    state.v[i] = v;
    state.a[i] = a;
  }
  state.reaction.resize(static_cast<std::size_t>(model.space().owned()));
  model.mass()->multiply(state.a.data(), state.reaction.data());
  return state;
}

constexpr double u_n = 0.1, v_n = 0.3, a_n = 1.5, u = 0.5, v = -0.2, a = 0.7;

// The motions of a driven body give its rates exactly; here the rates are arbitrary. The work of the reactions M a
// equals the change of the kinetic energy all the same.
TEST(WorkTest, DrivingARigidBodyChangesItsKineticEnergy) {
  const auto model = block();
  const std::vector<State> states{rigid(*model, u_n, v_n, a_n), rigid(*model, u, v, a)};
  const Table table = summing(Form::EndMean);
  EXPECT_NEAR(work_of_external_forces(*model, table, states, dt), mass * (u - u_n) * (a_n + a) / 2, 1e-12)
      << "a free body under the same forces";
  const auto motion = sine(0, 1, 1, 0);
  for (int node = 0; node < model->mesh().nodes(); ++node) model->constraints().add(2 * node, 1.0, motion);
  EXPECT_NEAR(work_of_external_forces(*model, table, states, dt), mass * (v * v - v_n * v_n) / 2, 1e-12);
}

}  // namespace
}  // namespace ixos

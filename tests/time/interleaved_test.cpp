// Two integrators that take turns on one model: histories belong to states, and no term remembers who asked last.
#include <gtest/gtest.h>

#include "scene/simulation.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;

/// A block with Maxwell branches and Kelvin-Voigt viscosity that slides on a wall with friction and tears off an
/// obstacle above, which moves.
std::string scene() {
  const std::string rubber =
      number("Density", 1) + number("Viscosity", 0.02) + number("Mass Damping", 0.01) +
      list("Maxwell Branches", numbers("Relaxation Times", {0.05, 2}) + numbers("Moduli", {0.4, 0.2}));
  const std::string wall =
      list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.26}) +
                       list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.5)));
  const std::string bond =
      list("Bond", word("Side Set", "top") + numbers("Point", {0, 1}) + numbers("Normal", {0, -1}) +
                       word("Law", "Bilinear Damage") +
                       list("Bilinear Damage",
                            number("Work of Adhesion", 0.02) + number("Strength", 0.05) + number("Stiffness", 0.5)) +
                       list("Motion", texts("Translation", "{-, Up}")));
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 2}))) +
         list("Materials", list("Rubber", rubber)) + list("Interactions", wall + bond) +
         list("Histories", test::expression("Up", "0.8*t", "0.8", "0")) +
         list("Initial Conditions", numbers("Velocity", {0.15, 0}));
}

/// A scheme with its own length of steps.
struct Mover {
  const char* scheme;
  double dt;
};
constexpr Mover movers[] = {{"Newmark", 0.05}, {"Average Vector Field", 0.04}, {"Bathe Composite", 0.06}};
constexpr int steps = 8;

struct Walkers {
  Walkers() : simulation(test::scene(scene() + test::time_integrator("Newmark", 0.05, 1)), test::world()) {
    for (const Mover& mover : movers) {
      const Scheme& chosen = ixos::scheme(mover.scheme);
      integrators.push_back(std::unique_ptr<Integrator>(
          new Integrator(test::direct(simulation.model(), chosen.table(chosen.parameters)))));
      const State& start = simulation.integrator().state();
      integrators.back()->initialize(start.u, start.v, 0);
    }
  }
  Simulation simulation;
  std::vector<std::unique_ptr<Integrator>> integrators;
};

void expect_same(const Integrator& found, const Integrator& expected, const std::string& where) {
  EXPECT_TRUE(found.state() == expected.state()) << where;
  EXPECT_EQ(found.dissipations(), expected.dissipations()) << where;
  EXPECT_EQ(found.external_work(), expected.external_work()) << where;
}

TEST(InterleavedTest, EachIntegratorGivesTheBitsThatItGivesAlone) {
  Walkers together;
  std::vector<std::unique_ptr<Walkers>> alone;
  for (std::size_t k = 0; k < std::size(movers); ++k) alone.push_back(std::make_unique<Walkers>());
  for (int step = 0; step < steps; ++step)
    for (std::size_t k = 0; k < std::size(movers); ++k) {
      const StepResult there = together.integrators[k]->step(movers[k].dt);
      ASSERT_TRUE(there.converged) << movers[k].scheme << there.reason;
      ASSERT_TRUE(alone[k]->integrators[k]->step(movers[k].dt).converged);
      expect_same(*together.integrators[k], *alone[k]->integrators[k], movers[k].scheme);
    }
  // All that a state can hide was at work.
  for (const auto& integrator : together.integrators) {
    const std::vector<std::string>& names = integrator->model().dissipation_names();
    for (std::size_t n = 0; n < names.size(); ++n) EXPECT_NE(integrator->dissipations()[n], 0) << names[n];
    EXPECT_GE(names.size(), 5u);
  }
}

// An attempt that waits for its judge survives the steps of another integrator.
TEST(InterleavedTest, AnAttemptWaitsWhileAnotherIntegratorSteps) {
  Walkers together, alone;
  for (int step = 0; step < 3; ++step) {
    for (Walkers* pair : {&together, &alone}) ASSERT_TRUE(pair->integrators[0]->attempt(movers[0].dt).converged);
    ASSERT_TRUE(together.integrators[1]->step(movers[1].dt).converged);
    for (Walkers* pair : {&together, &alone}) pair->integrators[0]->accept();
    expect_same(*together.integrators[0], *alone.integrators[0], "Newmark");
  }
}

TEST(InterleavedTest, ACopyOfAStateIsAnotherBeginning) {
  Walkers pair, other;
  Integrator& walker = *pair.integrators[0];
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(walker.step(0.05).converged);
  const State kept = walker.state();
  const State same = kept;
  EXPECT_TRUE(same == kept);
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(walker.step(0.05).converged);
  EXPECT_TRUE(walker.state() != kept);
  EXPECT_TRUE(same == kept) << "a state is no view of the present one";
  other.integrators[0]->resume(kept);
  walker.resume(same);
  for (int step = 0; step < 3; ++step)
    for (Integrator* one : {&walker, other.integrators[0].get()}) ASSERT_TRUE(one->step(0.05).converged);
  expect_same(walker, *other.integrators[0], "resumed");
}

}  // namespace
}  // namespace ixos

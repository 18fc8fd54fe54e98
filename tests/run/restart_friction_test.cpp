// Surfaces that slide and go on from a checkpoint.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "run/restart_fixture.hpp"
#include "study/common/history_table.hpp"
#include "support/silent_interaction.hpp"
#include "term/wall/friction_term.hpp"

namespace ixos::test {
namespace {

/// A block that slides on a wall and tilts; `friction`: the list's contents.
std::string sliding(const std::string& friction, const std::string& integrator, const std::string& output) {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 2}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions",
              list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.26}) + list("Friction", friction))) +
         list("Initial Conditions", numbers("Velocity", {0.15, 0})) + list("Output", output) +
         list("Time Integrator", integrator);
}

const std::string amontons = word("Type", "Extended Amontons") + number("Coefficient", 0.5);

// All schemes with one friction, all frictions with one scheme.
TEST_F(RestartTest, FrictionGoesOn) {
  const std::string smoothed = word("Type", "Smoothed") + number("Coefficient", 0.5) + number("Slip Speed", 0.01);
  const std::string frictions[] = {amontons, amontons + word("Threshold", "Current"), smoothed};
  for (const std::string& friction : frictions)
    for (const std::string& scheme :
         {word("Type", "Newmark"), word("Type", "Bathe Composite"),
          word("Type", "Generalized-Alpha") + list("Generalized-Alpha", number("Spectral Radius", 1)),
          word("Type", "Average Vector Field"), word("Type", "Central Difference")}) {
      if (friction != amontons && scheme != word("Type", "Average Vector Field")) continue;
      SCOPED_TRACE(friction + scheme);
      const RunResult whole =
          expect_goes_on(sliding(friction, scheme + steps(0.05, 2), checkpoints(15, 100)), {15, 30});
      EXPECT_EQ(whole.status, RunStatus::Completed);
    }
}

// The first rank alone resumes from a checkpoint of all ranks.
TEST_F(RestartTest, FrictionGoesOnOnAnotherNumberOfRanks) {
  const std::string scene =
      sliding(amontons, word("Type", "Average Vector Field") + steps(0.05, 2), checkpoints(15, 100));
  ASSERT_EQ(run_scene(scene, "whole").status, RunStatus::Completed);
  copy("whole", "alone");
  on_first([&] {
    Simulation simulation(test::scene(scene), self());
    RunOptions options;
    options.folder = folder("alone");
    options.restart = checkpoint("alone", 15);
    options.overwrite = true;
    EXPECT_EQ(run(simulation, options).status, RunStatus::Completed);
    const HistoryTable whole(folder("whole") + "/history.csv"), alone(folder("alone") + "/history.csv");
    for (const char* name : {"dissipated_friction_of_Wall", "friction_force_Wall_x", "contact_energy"}) {
      const std::vector<double> expected = whole.column(name), found = alone.column(name);
      ASSERT_EQ(expected.size(), found.size());
      for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-9) << name << ", row " << k;
    }
    EXPECT_GT(whole.column("dissipated_friction_of_Wall").back(), 1e-4);
  });
}

// The columns of friction, and the balance that they close.
TEST_F(RestartTest, FrictionHasColumns) {
  const std::string scheme = word("Type", "Average Vector Field") +
                             list("Average Vector Field", count("Elastic Points", 6) + count("Interaction Points", 0));
  ASSERT_EQ(run_scene(sliding(amontons, scheme + steps(0.05, 3), ""), "columns").status, RunStatus::Completed);
  world()->barrier();
  const HistoryTable history(folder("columns") + "/history.csv");
  const auto column = [&](const std::string& name) { return history.column(name); };
  const auto force = column("friction_force_Wall_x"), whole = column("contact_force_x"),
             lost = column("dissipated_friction_of_Wall"), all = column("dissipated_energy"),
             total = column("total_energy");
  EXPECT_EQ(force.front(), 0);
  EXPECT_LT(force[10], -0.01);
  EXPECT_GT(lost.back(), 1e-4);
  for (std::size_t k = 0; k < lost.size(); ++k) {
    EXPECT_EQ(lost[k], all[k]);
    EXPECT_NEAR(force[k], whole[k], 1e-15);  // the wall's normal is y
    EXPECT_NEAR(total[k] + lost[k], total[0], 1e-10);
  }
}

/// Friction whose work nobody books: with a share of the true threshold and stiffness it stands for a force that is
/// wrong by that share.
class StrayFriction final : public test::SilentInteraction {
 public:
  explicit StrayFriction(std::unique_ptr<Interaction> term) : term_(std::move(term)) {}
  void place(const Pattern& pattern) override { term_->place(pattern); }
  void initialize(const KnownState& start, TermHistories& histories) const override {
    term_->initialize(start, histories);
  }
  void begin_step(const StepStart& start, StepMemories& step) const override { term_->begin_step(start, step); }
  void begin_stage(const StageStart& start, StepMemories& step) const override { term_->begin_stage(start, step); }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    term_->accept(step, histories);
    return {};
  }
  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    return term_->add_force(segment, rule, f);
  }
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    term_->add_tangent(segment, rule, kind, values);
  }
  const Rule& followed(const Rule& rule) const override { return term_->followed(rule); }
  bool needs_positive_gaps() const override { return true; }

 protected:
  std::vector<Term*> inside() const override { return {term_.get()}; }

 private:
  std::unique_ptr<Interaction> term_;
};

// The account of friction does not follow from the balance: a force that is wrong by 1e-6 shows in the balance.
TEST_F(RestartTest, AFrictionForceThatIsWrongShowsInTheBalance) {
  const std::string scheme = word("Type", "Average Vector Field") +
                             list("Average Vector Field", count("Elastic Points", 6) + count("Interaction Points", 0));
  const std::string scene =
      sliding(amontons, scheme + steps(0.05, 3), "") + list("Nonlinear Solver", number("Tolerance", 1e-12));
  double errors[2], lost = 0;
  for (const bool falsified : {false, true}) {
    Simulation simulation(test::scene(scene), world());
    Model& model = simulation.model();
    if (falsified) {
      const SceneInteraction& wall = simulation.interactions().front();
      Friction friction = wall.friction;
      friction.coefficient *= 1e-6;
      friction.stiffness *= 1e-6;
      const auto obstacle = obstacles().make(wall.node, 2);
      for (auto& term : make_friction_terms(model.mesh(), model.mesh().side_sets[model.mesh().side_set("bottom")],
                                            model.pattern(), FrictionLaw(friction, wall.law), obstacle, {}))
        model.add_interaction(std::make_unique<StrayFriction>(std::move(term)), "Stray");
      std::vector<double> u = simulation.integrator().state().u, v = simulation.integrator().state().v;
      simulation.integrator().initialize(std::move(u), std::move(v), 0);
    }
    RunOptions options;
    options.folder = folder("falsified");
    options.overwrite = true;
    const RunResult result = run(simulation, options);
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    errors[falsified ? 1 : 0] = result.max_energy_error;
    lost = simulation.integrator().dissipated_energy();
  }
  EXPECT_GT(errors[1], 0.9e-6 * lost);
  EXPECT_LT(errors[1], 1.2e-6 * lost);
  EXPECT_LT(errors[0], 0.01 * errors[1]);
}

}  // namespace
}  // namespace ixos::test

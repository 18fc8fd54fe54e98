// The scenes of stages: what they change, and what is refused.
#include "scene/read/stages.hpp"

#include <gtest/gtest.h>

#include "scene/read/scene_units.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::refusal;
using test::texts;
using test::word;
using List = Teuchos::ParameterList;

std::string control(double step, double end) {
  return list("Time Integrator", list("Time Step Control", number("Time Step", step) + number("Final Time", end)));
}

std::string ramp(double value, double length) {
  return list("Histories",
              list("Lift", word("Type", "Ramp") + list("Ramp", number("Value", value) + number("Length", length))));
}

std::string held(const std::string& name, const std::string& set) {
  return list(name, word("Node Set", set) + word("Components", "y") + word("History", "Lift"));
}

/// A box that follows a ramp from 0 to 2 in 4 T0, for 6 T0, before these stages.
List scene(const std::string& stages) {
  return test::scene(list("Mesh", word("Type", "Box")) + list("Materials", list("Body", number("Density", 1))) +
                     ramp(2, 4) + list("Boundary Conditions", held("Foot", "bottom") + held("Head", "top")) +
                     list("Initial Conditions", numbers("Velocity", {0, 1})) + control(0.5, 6) +
                     list("Stages", stages));
}

/// The complete scene of the stage that begins at the last of these times.
List complete(const std::string& stages, const std::vector<double>& begins) {
  return complete_scene(Stages(scene(stages)).scene(begins));
}

const List& times(const List& complete) { return complete.sublist("Time Integrator").sublist("Time Step Control"); }

std::string refused(const std::string& stages) {
  return refusal([&] { Stages(scene(stages)).planned_ends(); });
}

TEST(StagesTest, ASceneWithoutStagesIsOneOfItself) {
  const Stages stages(scene(""));
  EXPECT_FALSE(stages.any());
  EXPECT_EQ(stages.count(), 1U);
  EXPECT_EQ(stages.planned_ends(), std::vector<double>{6});
  EXPECT_EQ(stages.path(0), "");
}

TEST(StagesTest, TimesCountFromTheBeginningOfTheStage) {
  const std::string stages = list("Press", "") + list("Wait", control(0.1, 3)) + list("Pull", control(0.1, 5));
  EXPECT_EQ(Stages(scene(stages)).planned_ends(), (std::vector<double>{6, 9, 14}));
  EXPECT_EQ(Stages(scene(stages)).planned_ends({4}), (std::vector<double>{4, 7, 12}));
  const List pull = complete(stages, {4, 6.5});
  EXPECT_EQ(times(pull).get<double>("Initial Time"), 6.5);
  EXPECT_EQ(times(pull).get<double>("Final Time"), 11.5);
  EXPECT_EQ(times(pull).get<double>("Time Step"), 0.1);
  // A stage that gives no length is as long as the one before.
  EXPECT_EQ(Stages(scene(list("Press", "") + list("Wait", "") + list("Pull", control(0.1, 5)) + list("Rest", "")))
                .planned_ends(),
            (std::vector<double>{6, 12, 17, 22}));
}

TEST(StagesTest, TheClockOfTheRunIsThatOfAllOtherTimes) {
  const std::string run = word("Clock", "Run");
  const std::string stages = list("Press", "") + list("Pull", run + control(0.1, 15) + ramp(5, 15));
  EXPECT_EQ(Stages(scene(stages)).planned_ends(), (std::vector<double>{6, 15}));
  const List lift = complete(stages, {6}).sublist("Histories").sublist("Lift");
  EXPECT_EQ(lift.get<double>("Time Shift"), 0);
  EXPECT_EQ(lift.get<double>("Value Shift"), 0);
}

TEST(StagesTest, AHistoryGoesOnFromItsValue) {
  const std::string stages =
      list("Press", "") + list("Pull", control(0.5, 6) + ramp(-3, 6)) + list("Back", control(0.5, 2) + ramp(1, 2));
  const auto value = [](const List& complete, double time) {
    return history_at(SceneNode(complete.sublist("Histories"), "Histories"), {}, "Lift", time);
  };
  // The first stage ends at 3 T0, in the middle of its ramp: whatever its value is there, the next goes on from it.
  const double at_3 = value(complete(stages, {}), 3);
  EXPECT_GT(at_3, 1);
  EXPECT_LT(at_3, 2);
  const List pull = complete(stages, {3}), back = complete(stages, {3, 9});
  EXPECT_DOUBLE_EQ(value(pull, 3), at_3);
  EXPECT_DOUBLE_EQ(value(pull, 9), at_3 - 3);
  EXPECT_DOUBLE_EQ(value(back, 9), at_3 - 3);
  EXPECT_DOUBLE_EQ(value(back, 11), at_3 - 2);
}

TEST(StagesTest, ListsAddUpAndLeaveOut) {
  const std::string limit = list("Probe", word("Name", "tip") + number("Limit", 1));
  const std::string with_stop =
      list("Time Integrator", word("Type", "Bathe Composite") + list("Stop", list("High", limit)));
  const std::string stages = list("Press", with_stop) +
                             list("Let Go", texts("Without", "{Boundary Conditions/Foot}") +
                                                list("Boundary Conditions", list("Head", word("Components", "xy")))) +
                             list("Kick", list("Initial Conditions", numbers("Velocity", {2, 0})));
  const List press = complete(stages, {}), go = complete(stages, {6}), kick = complete(stages, {6, 7});
  EXPECT_TRUE(press.sublist("Time Integrator").sublist("Stop").isSublist("High"));
  EXPECT_EQ(go.sublist("Time Integrator").sublist("Stop").numParams(), 0);
  EXPECT_EQ(go.sublist("Time Integrator").get<std::string>("Type"), "Bathe Composite");
  EXPECT_FALSE(go.sublist("Boundary Conditions").isSublist("Foot"));
  EXPECT_EQ(go.sublist("Boundary Conditions").sublist("Head").get<std::string>("Node Set"), "top");
  EXPECT_EQ(go.sublist("Boundary Conditions").sublist("Head").get<std::string>("Components"), "xy");
  const Stages all(scene(stages));
  EXPECT_FALSE(all.gives_velocities(1));
  EXPECT_TRUE(all.gives_velocities(2));
  EXPECT_FALSE(kick.sublist("Boundary Conditions").isSublist("Foot"));
  EXPECT_EQ(kick.sublist("Initial Conditions").get<Teuchos::Array<double>>("Velocity")[0], 2);
  // The scene of a later stage stands alone.
  EXPECT_EQ(press.sublist("Stages").numParams(), 3);
  EXPECT_EQ(go.sublist("Stages").numParams(), 0);
}

TEST(StagesTest, UnitsAreThoseOfTheScene) {
  const std::string ns = list("Time Integrator", list("Time Step Control", word("Final Time", "2 us")));
  EXPECT_EQ(Stages(scene(list("Press", "") + list("Pull", ns))).planned_ends(), (std::vector<double>{6, 2006}));
}

TEST(StagesTest, ARampMayOutlastAStageButNotTheLast) {
  const auto notes = [](double end) {
    const Simulation simulation(scene(list("Press", control(0.5, 2)) + list("Pull", control(0.5, end))), test::world());
    std::string all;
    for (const std::string& note : simulation.notes()) all += note + "\n";
    return all;
  };
  EXPECT_EQ(notes(6).find("ramp"), std::string::npos);
  test::expect_contains(notes(1), "Stages/Pull: Histories/Lift: the ramp ends at t = 4 T0, after the Final Time 3");
}

TEST(StagesTest, RefusalsNameTheStage) {
  EXPECT_EQ(refused(number("Press", 1)), "Stages/Press is a parameter, but a stage is a list");
  EXPECT_EQ(refused(list("Press", list("Mesh", ""))),
            "Stages/Press: Mesh is the same in all stages: give it in the scene");
  test::expect_contains(
      refused(list("Press", list("Boundary Condition", ""))),
      "Stages/Press: list \"Boundary Condition\" does not exist; did you mean \"Boundary Conditions\"?");
  EXPECT_EQ(refused(list("Press", texts("Without", "{Grips}"))),
            "Stages/Press: Without: the first stage has none before it");
  EXPECT_EQ(refused(list("Press", "") + list("Pull", texts("Without", "{Mesh/Box}"))),
            "Stages/Pull: Without: Mesh is the same in all stages");
  EXPECT_EQ(refused(list("Press", "") + list("Pull", texts("Without", "{Boundary Conditions/Feet}"))),
            "Stages/Pull: Without: the stage before has no \"Boundary Conditions/Feet\"; did you mean \"Boundary "
            "Conditions/Foot\"?");
  const std::string late = list("Time Integrator", list("Time Step Control", number("Initial Time", 7)));
  EXPECT_EQ(refused(list("Press", "") + list("Pull", late)),
            "Stages/Pull: Time Integrator/Time Step Control/Initial Time: a stage begins where the one before ends; "
            "remove it");
  test::expect_contains(refused(list("Press", word("Clock", "Wall"))), "Stages/Press: Clock: \"Wall\" does not exist");
}

}  // namespace
}  // namespace ixos

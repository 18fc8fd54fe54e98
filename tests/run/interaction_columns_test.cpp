// Columns of single interactions in history.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/gap_law.hpp"
#include "mesh/generators/shapes.hpp"
#include "run/run.hpp"
#include "study/common/history_table.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

/// A block of 3 by 2 L0 that translates before two walls: y = -0.5 below, x = 3.75 at its right.
std::string cornered(const std::string& output, const std::string& second = "Stop") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {3, 2}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions",
              list("Floor", word("Side Set", "bottom") + numbers("Point", {0, -0.5})) +
                  (second.empty() ? ""
                                  : list(second, word("Side Set", "right") + numbers("Point", {3.75, 0}) +
                                                     numbers("Normal", {-1, 0})))) +
         list("Output", output + list("Probes", list("Edge", numbers("Point", {0, 1})))) +
         test::time_integrator("Newmark", 0.01, 0.05);
}

const std::vector<std::string> of_floor{"contact_force_Floor_x", "contact_force_Floor_y", "contact_moment_Floor_z",
                                        "contact_measure_Floor", "min_gap_Floor"};

class InteractionColumnsTest : public testing::Test {
 protected:
  HistoryTable run_scene(const std::string& scene) {
    simulation_ = std::make_unique<Simulation>(test::scene(scene), test::world());
    RunOptions options;
    options.folder = testing::TempDir() + "interaction_columns";
    options.overwrite = true;
    run(*simulation_, options);
    test::world()->barrier();
    return HistoryTable(options.folder + "/history.csv");
  }
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(InteractionColumnsTest, SeveralInteractionsHaveColumnsAfterAllOthers) {
  const HistoryTable history = run_scene(cornered(""));
  std::vector<std::string> names = history.names(), last = of_floor;
  for (const char* name : {"contact_force_Stop_x", "contact_force_Stop_y", "contact_moment_Stop_z",
                           "contact_measure_Stop", "min_gap_Stop"})
    last.emplace_back(name);
  ASSERT_GT(names.size(), last.size());
  EXPECT_TRUE(std::equal(last.begin(), last.end(), names.end() - static_cast<std::ptrdiff_t>(last.size())));
  EXPECT_EQ(names[names.size() - last.size() - 1], "Edge_vy");
  // The first row: a block at rest, gaps 0.5 and 0.75.
  const GapLaw& law = *simulation_->interactions()[0].law;
  const double up = 3 * law.traction(0.5)[0], right = -2 * law.traction(0.75)[0];
  EXPECT_NEAR(history.column("contact_force_Floor_y")[0], up, 1e-13);
  EXPECT_NEAR(history.column("contact_force_Floor_x")[0], 0, 1e-15);
  EXPECT_NEAR(history.column("contact_moment_Floor_z")[0], 1.5 * up, 1e-13);
  EXPECT_NEAR(history.column("contact_force_Stop_x")[0], right, 1e-13);
  EXPECT_NEAR(history.column("contact_moment_Stop_z")[0], -1.0 * right, 1e-13);
  EXPECT_NEAR(history.column("min_gap_Stop")[0], 0.75, 1e-15);
  EXPECT_EQ(history.column("contact_measure_Stop")[0], 0);
  for (std::size_t k = 0; k < history.rows(); ++k) {
    for (const std::string axis : {"x", "y"})
      EXPECT_NEAR(history.column("contact_force_" + axis)[k],
                  history.column("contact_force_Floor_" + axis)[k] + history.column("contact_force_Stop_" + axis)[k],
                  1e-14);
    EXPECT_EQ(history.column("min_gap")[k],
              std::min(history.column("min_gap_Floor")[k], history.column("min_gap_Stop")[k]));
  }
}

TEST_F(InteractionColumnsTest, TheOptionAddsAndRemovesThem) {
  const HistoryTable usual = run_scene(cornered(""));
  const HistoryTable none = run_scene(cornered(word("Interaction Columns", "Off")));
  EXPECT_EQ(none.names().size() + 10, usual.names().size());
  for (const std::string& name : none.names())
    if (name != "wall_seconds") {
      EXPECT_EQ(none.column(name), usual.column(name)) << name;
    }
  EXPECT_FALSE(run_scene(cornered("", "")).has(of_floor[0]));
  const HistoryTable one = run_scene(cornered(word("Interaction Columns", "On"), ""));
  for (const std::string& name : of_floor) EXPECT_TRUE(one.has(name)) << name;
  EXPECT_EQ(one.column("contact_force_Floor_y"), one.column("contact_force_y"));
  EXPECT_EQ(one.column("min_gap_Floor"), one.column("min_gap"));
}

TEST_F(InteractionColumnsTest, AutomaticOnesBelongToTheGroupInteraction) {
  const std::string without = "<Parameter name=\"Interaction\" type=\"bool\" value=\"false\"/>";
  EXPECT_FALSE(run_scene(cornered(without)).has(of_floor[0]));
  const HistoryTable on = run_scene(cornered(without + word("Interaction Columns", "On")));
  EXPECT_TRUE(std::isnan(on.column("min_gap")[0]));
  EXPECT_NEAR(on.column("min_gap_Floor")[0], 0.5, 1e-15);
}

TEST_F(InteractionColumnsTest, NamesThatCannotHeadAColumnAreRefused) {
  const auto refusal = [](const std::string& output) {
    return test::refusal([&] { Simulation(test::scene(cornered(output, "Stop, hard")), test::world()); });
  };
  test::expect_contains(refusal(""), "Interactions/Stop, hard: \"contact_force_Stop, hard_x\" cannot name a column");
  EXPECT_EQ(refusal(word("Interaction Columns", "Off")), "");
}

TEST_F(InteractionColumnsTest, EachSourceOfDissipationHasAColumnOfItsOwn) {
  const std::string sources =
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {3, 2}))) +
      list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", 0.1))) +
      list("Interactions",
           list("damping", word("Side Set", "bottom") + numbers("Point", {0, -5}) + word("Law", "Bilinear Damage") +
                               list("Friction", word("Type", "Constant Stress") + number("Stress", 0.1))) +
               list("energy", word("Side Set", "top") + numbers("Point", {0, 7}) + numbers("Normal", {0, -1}) +
                                  word("Law", "Bilinear Damage")) +
               list("Upper wall", word("Side Set", "right") + numbers("Point", {8, 0}) + numbers("Normal", {-1, 0}) +
                                      list("Friction", word("Type", "Constant Stress") + number("Stress", 0)))) +
      test::time_integrator("Newmark", 0.01, 0.02);
  const HistoryTable history = run_scene(sources);
  EXPECT_EQ(simulation_->model().dissipation_names(),
            (std::vector<std::string>{"damping", "damage of damping", "friction of damping", "damage of energy",
                                      "friction of Upper wall"}));
  for (const char* column :
       {"dissipated_energy", "dissipated_damping", "dissipated_damage_of_damping", "dissipated_friction_of_damping",
        "dissipated_damage_of_energy", "dissipated_friction_of_Upper wall", "friction_force_Upper wall_y",
        "mean_slip_damping", "sliding_measure_Upper wall", "sticking_measure_Upper wall"})
    EXPECT_EQ(std::count(history.names().begin(), history.names().end(), column), 1) << column;
}

// A block of 2 by 1 L0 is dragged by 0.1 t^2: it sticks up to tau/eps = 4e-4, then slides as a whole.
TEST_F(InteractionColumnsTest, SlipAndWhatSlidesHaveColumns) {
  const double spring = 0.02 / 50;
  const auto held = [](const std::string& name, const std::string& axis, const std::string& more) {
    return list(name, word("Node Set", "all") + word("Components", axis) + more);
  };
  const HistoryTable history = run_scene(
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2})) +
                       list("Sets", list("all", word("Kind", "Nodes")))) +
      list("Materials", list("Rubber", number("Density", 1))) +
      list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.25}) +
                                            list("Friction", word("Type", "Constant Stress") + number("Stress", 0.02) +
                                                                 number("Stiffness", 50)))) +
      list("Histories",
           list("Drag", word("Type", "Ramp") +
                            list("Ramp", number("Value", 0.025) + number("Length", 0.5) + word("Shape", "Quintic")))) +
      list("Boundary Conditions", held("Drag", "x", word("History", "Drag")) + held("Guide", "y", "")) +
      test::time_integrator("Static", 0.05, 0.7));
  const auto time = history.column("time"), slip = history.column("mean_slip_Wall"),
             sliding = history.column("sliding_measure_Wall"), sticking = history.column("sticking_measure_Wall");
  ASSERT_EQ(time.size(), 15U);
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double part = std::min(time[k] / 0.5, 1.0);
    const double way = 0.025 * std::pow(part, 3) * (10 - 15 * part + 6 * part * part);
    const bool slides = way > spring && k <= 10;  // then it is held
    EXPECT_NEAR(slip[k], std::max(way - spring, 0.0), 1e-12) << time[k];
    EXPECT_NEAR(sliding[k], slides ? 2 : 0, 1e-12) << time[k];
    EXPECT_NEAR(sticking[k], slides ? 0 : 2, 1e-12) << time[k];
  }
}

// The mesh may come from a program, with any name of a block.
TEST_F(InteractionColumnsTest, ABlockThatCannotNameItsDissipationIsRefused) {
  BoxShape shape;
  Mesh mesh = box(shape);
  mesh.blocks[0].name = "body, soft";
  const auto refusal = [&](double viscosity) {
    return test::refusal([&] {
      Simulation(test::scene(list("Materials", list("Rubber", word("Block", "body, soft") + number("Density", 1) +
                                                                  number("Viscosity", viscosity))) +
                             test::time_integrator("Newmark", 0.01, 0.05)),
                 mesh, test::world());
    });
  };
  EXPECT_EQ(refusal(0), "");
  test::expect_contains(refusal(0.1), "Materials: \"dissipated_viscosity_of_body, soft\" cannot name a column");
}

}  // namespace
}  // namespace ixos

// Runs whose mesh follows the front.
#include "run/mesh_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "mesh/selection.hpp"
#include "run/peeled_strip.hpp"
#include "run/restart_fixture.hpp"
#include "study/common/history_table.hpp"
#include "support/refusal.hpp"

namespace ixos::test {
namespace {

class MeshFollowerTest : public RestartTest {
 protected:
  HistoryTable table(const std::string& name) const { return HistoryTable(folder(name) + "/history.csv"); }
};

TEST_F(MeshFollowerTest, TheBalanceOfAConservingSchemeStaysClosed) {
  const RunResult result = run_scene(strip("Average Vector Field", adapt(2), 0.05, 3), "run");
  ASSERT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_GT(result.mesh_changes.count, 5);
  EXPECT_GT(result.mesh_changes.repeated, 3);
  EXPECT_GT(result.mesh_changes.count, result.mesh_changes.repeated);  // cells were joined, too
  EXPECT_EQ(result.steps, 60);
  world()->barrier();
  const HistoryTable rows = table("run");
  const std::vector<double>&total = rows.column("total_energy"), &work = rows.column("external_work"),
        &adapted = rows.column("adapted_energy");
  for (std::size_t k = 0; k < rows.rows(); ++k)
    EXPECT_NEAR(total[k] - work[k] - adapted[k], total[0], 1e-11 * result.largest_energy) << k;
  EXPECT_NE(adapted.back(), 0);
  EXPECT_LT(std::abs(adapted.back()), 0.02 * result.largest_energy);
  EXPECT_LT(result.max_energy_error, 1e-11 * result.largest_energy);
  EXPECT_GT(work.back(), 0.1);
}

TEST_F(MeshFollowerTest, AllSchemesGoOnBitForBitOnThePresentMesh) {
  for (const char* scheme : {"Average Vector Field", "Newmark", "Bathe Composite", "Gautam-Sauer Composite",
                             "Energy-Momentum", "Generalized-Alpha", "Static"}) {
    SCOPED_TRACE(scheme);
    const std::string output = checkpoints(7, 100) + count("Fields Interval", 5);
    const RunResult whole = expect_goes_on(strip(scheme, adapt(2), 0.05, 1, output), {7, 14});
    EXPECT_GT(whole.mesh_changes.count, 1);
  }
}

TEST_F(MeshFollowerTest, EveryElementFollows) {
  for (const char* element : {"Q1C2", "Q1C4", "Q2C2", "Q2C4"}) {
    SCOPED_TRACE(element);
    const std::string order = std::string(element).rfind("Q2", 0) == 0 ? count("Cell Order", 2) : "";
    const RunResult result =
        run_scene(strip("Average Vector Field", adapt(2) + order, 0.05, 1.5, "", element), element);
    ASSERT_EQ(result.status, RunStatus::Completed) << result.reason;
    EXPECT_GT(result.mesh_changes.count, 1);
    EXPECT_LT(result.max_energy_error, 1e-11 * result.largest_energy);
  }
}

// The adaptive run has the force of the mesh that is fine everywhere, with a part of its unknowns.
TEST_F(MeshFollowerTest, TheForceIsThatOfTheFineMesh) {
  const std::string everywhere = list("Refine", list("All", count("Levels", 3) + numbers("Upper", {100, 100})));
  const RunResult fine = run_scene(strip("Newmark", everywhere, 0.05, 3), "fine"),
                  coarse = run_scene(strip("Newmark", "", 0.05, 3), "coarse"),
                  follows = run_scene(
                      strip("Newmark", adapt(3, number("Part", 0.125) + number("Strain", 0.02)), 0.05, 3), "follows");
  world()->barrier();
  expect_force_of_fine_mesh(table("fine"), table("coarse"), table("follows"), 25);
  EXPECT_LT(follows.mesh_changes.most_unknowns, 1200);  // of 13 * 8 + 1 by 9 nodes
}

TEST_F(MeshFollowerTest, WhatIsNotAskedForIsNotThere) {
  run_scene(strip("Newmark", "", 0.05, 0.2), "plain");
  run_scene(strip("Newmark", adapt(0), 0.05, 0.2), "off");
  world()->barrier();
  EXPECT_EQ(history_rows(folder("plain")), history_rows(folder("off")));
}

TEST_F(MeshFollowerTest, ABudgetKeepsCellsSplit) {
  const std::string none = list("Adapt", count("Levels", 2) + count("Interval", 4) + number("Budget", 0));
  const RunResult kept = run_scene(strip("Newmark", none, 0.05, 3), "kept"),
                  joined = run_scene(strip("Newmark", adapt(2), 0.05, 3), "joined");
  EXPECT_EQ(kept.mesh_changes.coarsening, 0);
  EXPECT_LE(kept.mesh_changes.count, joined.mesh_changes.count);
  ASSERT_EQ(kept.warnings.size(), 1U);
  EXPECT_EQ(kept.warnings[0].name, "mesh follows the front");
  expect_contains(kept.warnings[0].message, "cells stay split: to join them would change the energy by");
  EXPECT_GT(joined.mesh_changes.coarsening, 0);
  EXPECT_GT(kept.mesh_changes.unknowns, joined.mesh_changes.unknowns);
}

TEST_F(MeshFollowerTest, TheFirstMeshIsThatOfTheFirstState) {
  // The wall is tilted, so that the left half of the strip begins in the range of the law.
  std::string tilted = strip("Newmark", adapt(2), 0.05, 0.1);
  const std::string point = numbers("Point", {0, -0.6368});
  tilted.replace(tilted.find(point), point.size(), point + numbers("Normal", {-0.1, 1}));
  tilted.replace(tilted.find(numbers("Lengths", {12, 0.5})), numbers("Lengths", {12, 0.5}).size(),
                 numbers("Lengths", {12, 0.5}) + numbers("Lower", {-12, 0}));
  const std::string probe = numbers("Point", {6, 0});
  tilted.replace(tilted.find(probe), probe.size(), numbers("Point", {-6, 0}));
  const Simulation first(scene(tilted), world());
  const std::shared_ptr<Simulation> finer = on_first_mesh(first);
  ASSERT_TRUE(finer);
  EXPECT_GT(finer->model().mesh().global_cells, first.model().mesh().global_cells);
  EXPECT_FALSE(on_first_mesh(*finer));
  EXPECT_EQ(finer->integrator().time(), 0);
}

TEST_F(MeshFollowerTest, FramesAreASeriesOfFiles) {
  const std::string frames = count("Fields Interval", 3);
  const auto files_of = [&] {
    std::set<std::string> names;
    world()->barrier();
    for (const auto& entry : fs::directory_iterator(folder("frames"))) names.insert(entry.path().filename());
    world()->barrier();
    return names;
  };
  const auto is_of_series = [](const std::string& name) { return name.rfind("fields.e-s.", 0) == 0; };
  const RunResult result = run_scene(strip("Newmark", adapt(2), 0.05, 1.5, frames), "frames");
  EXPECT_GT(result.mesh_changes.count, 1);
  const std::set<std::string> names = files_of();
  const auto later = std::count_if(names.begin(), names.end(), is_of_series);
  EXPECT_GT(later, 0);
  EXPECT_LE(later, result.mesh_changes.count * world()->getSize());
  const std::string ranks = world()->getSize() == 1 ? "" : ".2.0";
  EXPECT_EQ(names.count("fields.e" + ranks), 1U);
  EXPECT_EQ(names.count("fields.e-s.0002" + ranks), 1U);
  EXPECT_EQ(names.count("effective-2.xml"), 0U) << "the scene is the same";
  // A run on one mesh leaves nothing of them.
  run_scene(strip("Newmark", "", 0.05, 0.3, frames), "frames");
  const std::set<std::string> then = files_of();
  EXPECT_EQ(then.count("fields.e" + ranks), 1U);
  EXPECT_EQ(std::count_if(then.begin(), then.end(), is_of_series), 0);
}

TEST_F(MeshFollowerTest, PlacesThatAreFineStaySoAndRestartsFindTheirMesh) {
  const std::string place = list("Refine", list("Left", count("Levels", 2) + numbers("Upper", {0.9, 9})));
  const RunResult whole =
      expect_goes_on(strip("Newmark", place + adapt(2), 0.05, 1.5, checkpoints(1, 100)), {1, 9, 13, 20});
  EXPECT_GT(whole.mesh_changes.count, 1);
}

TEST_F(MeshFollowerTest, ARunBeginsWithThePresentStateAndReplacesItsOwnResults) {
  const Teuchos::ParameterList scene = test::scene(strip("Newmark", adapt(2), 0.05, 1));
  RunOptions options;
  options.folder = folder("present");
  std::vector<double> ends;
  for (const int steps : {0, 4}) {
    Simulation simulation(scene, world());
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(simulation.integrator().step(0.05).converged);
    const RunResult result = run(simulation, options);
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    EXPECT_EQ(result.steps, 20 - steps);
    world()->barrier();
    ends.push_back(table("present").column("reaction_right_y").back());
  }
  EXPECT_NEAR(ends[1], ends[0], 0.02 * std::abs(ends[0]));
}

/// A block that is lifted off a wall by its top.
std::string lifted_block(const std::string& mesh, const std::vector<double>& point, const std::string& across,
                         const std::string& up, const std::string& integrator) {
  return list("Mesh", word("Type", "Box") + mesh + adapt(1, number("Part", 0.02))) +
         list("Materials", list("Rubber", number("Density", 0.1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", point) + number("Gamma L", 1) +
                                               number("Gamma W", 10))) +
         list("Histories",
              list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 0.6) + number("Length", 1)))) +
         list("Boundary Conditions",
              list("Pull", word("Node Set", "top") + word("Components", up) + word("History", "Up")) +
                  list("Clamp", word("Node Set", "top") + word("Components", across))) +
         list("Time Integrator", integrator);
}

TEST_F(MeshFollowerTest, BodiesInSpaceAndOfRevolutionFollow) {
  const std::string solid = list("Box", count("Dimension", 3) + counts("Divisions", {3, 2, 1}) +
                                            numbers("Lengths", {3, 2, 0.6})),
                    ring = word("Geometry", "Axisymmetric") +
                           list("Box", counts("Divisions", {4, 1}) + numbers("Lengths", {3, 0.6}));
  for (const bool in_space : {false, true})
    for (const auto& [scheme, step, error] :
         {std::tuple("Average Vector Field", 0.05, 1e-10), std::tuple("Central Difference", 0.005, 0.02)}) {
      SCOPED_TRACE(testing::Message() << scheme << (in_space ? ", in space" : ", of revolution"));
      const std::string integrator = word("Type", scheme) + steps(step, 1);
      const RunResult result = run_scene(in_space ? lifted_block(solid, {0, 0, -0.6368}, "xy", "z", integrator)
                                                  : lifted_block(ring, {0, -0.6368}, "x", "y", integrator),
                                         "lifted");
      EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
      EXPECT_GT(result.mesh_changes.count, 0);
      EXPECT_LT(result.max_energy_error, error * result.largest_energy);
    }
}

TEST_F(MeshFollowerTest, WhatPointsKeepGoesAlong) {
  for (const auto& [what, material, wall] :
       {std::tuple("branches", branches, std::string()),
        std::tuple("viscosity", number("Viscosity", 0.1), std::string()),
        std::tuple("friction", std::string(), friction), std::tuple("both", branches, friction)}) {
    SCOPED_TRACE(what);
    const std::string output = checkpoints(7, 100) + count("Fields Interval", 5);
    const RunResult whole =
        expect_goes_on(strip("Average Vector Field", adapt(2), 0.05, 1.5, output, "Q1C1", material, wall), {7, 14, 28});
    EXPECT_GT(whole.mesh_changes.count, 3);
    world()->barrier();
    const HistoryTable rows = table("whole");
    EXPECT_GT(rows.column("dissipated_energy").back(), 1e-6 * whole.largest_energy);
    expect_closed(rows, whole.largest_energy);
  }
}

/// The strip on bonds that break, with further parameters of the law.
std::string bonded_strip(const std::string& scheme, const std::string& wall, const std::string& law) {
  std::string scene = strip(scheme, adapt(2), 0.02, 3, checkpoints(30, 100));
  const std::string other = numbers("Point", {0, -0.6368}) + number("Gamma L", 1) + number("Gamma W", 10);
  scene.replace(scene.find(other), other.size(),
                wall + word("Law", "Bilinear Damage") +
                    list("Bilinear Damage",
                         number("Work of Adhesion", 0.02) + number("Strength", 0.05) + number("Stiffness", 0.5) + law));
  return scene;
}

TEST_F(MeshFollowerTest, DamageGoesAlong) {
  const RunResult whole = expect_goes_on(bonded_strip("Average Vector Field", "", ""), {30, 60, 90});
  EXPECT_GT(whole.mesh_changes.count, 3);
  world()->barrier();
  EXPECT_GT(table("whole").column("dissipated_energy").back(), 1e-3 * whole.largest_energy);
  // Bonds that wait for a touch, and a wall that the right half of the strip never touches.
  const std::string on_touch = R"(<Parameter name="Bond on Touch" type="bool" value="true"/>)";
  EXPECT_EQ(expect_goes_on(bonded_strip("Newmark", numbers("Point", {0, -0.001}), on_touch), {30, 60}).status,
            RunStatus::Completed);
}

// The points in time of the curved gap move the balance, with and without changes of the mesh.
TEST_F(MeshFollowerTest, FrictionOnACurvedObstacleGoesAlong) {
  const auto on_cylinder = [](const std::string& mesh) {
    std::string scene = strip("Average Vector Field", mesh, 0.05, 1, checkpoints(7, 100), "Q1C1", "",
                              friction + word("Obstacle", "Sphere") +
                                  list("Sphere", numbers("Center", {12, -20.6368}) + number("Radius", 20)));
    const std::string point = numbers("Point", {0, -0.6368});
    return scene.erase(scene.find(point), point.size());
  };
  const std::string fine = list("Refine", list("All", count("Levels", 2) + numbers("Upper", {100, 100})));
  const RunResult whole = expect_goes_on(on_cylinder(adapt(2)), {7, 14}), stays = run_scene(on_cylinder(fine), "stays");
  EXPECT_GT(whole.mesh_changes.count, 1);
  EXPECT_LT(whole.max_energy_error, 3 * stays.max_energy_error);
}

/// Two strips that stick to each other and are peeled apart at their right edges.
std::string two_strips(const std::string& scheme, const std::string& mesh, const std::string& pair, double end,
                       const std::string& output = "") {
  const auto part = [](const char* name, double lower) {
    return list(name, word("Type", "Box") + list("Box", numbers("Lower", {0, lower}) + numbers("Lengths", {12, 0.5}) +
                                                            counts("Divisions", {12, 1})));
  };
  const auto rubber = [](const char* block) { return list(block, word("Block", block) + number("Density", 0.01)); };
  const auto ramp = [](const char* name, double value) {
    return list(name, word("Type", "Ramp") + list("Ramp", number("Value", value) + number("Length", 4)));
  };
  const auto pull = [](const char* side, const char* history) {
    return list(side, word("Node Set", side) + word("Components", "y") + word("History", history)) +
           list(std::string(side) + " guide", word("Node Set", side) + word("Components", "x"));
  };
  return list("Mesh", word("Type", "Parts") + list("Parts", part("upper", 0.3184) + part("lower", -0.8184)) + mesh) +
         list("Materials", rubber("upper_body") + rubber("lower_body")) +
         list("Interactions", list("Bond", word("Side Set", "upper_bottom") + word("Primary Side Set", "lower_top") +
                                               number("Gamma L", 1) + number("Gamma W", 10) + pair)) +
         list("Histories", ramp("Up", 1) + ramp("Down", -1)) +
         list("Boundary Conditions", pull("upper_right", "Up") + pull("lower_right", "Down")) +
         list("Output", output + texts("Reactions", "{upper_right}")) +
         list("Time Integrator", word("Type", scheme) + steps(0.05, end));
}

TEST_F(MeshFollowerTest, BothSurfacesOfAPairFollow) {
  for (const char* passes : {"One", "Two"}) {
    SCOPED_TRACE(passes);
    const RunResult whole = expect_goes_on(
        two_strips("Average Vector Field", adapt(2), word("Passes", passes), 1.5, checkpoints(10, 100)), {10, 20});
    EXPECT_GT(whole.mesh_changes.count, 2);
    EXPECT_LT(whole.max_energy_error, 1e-5 * whole.largest_energy);  // closest points pass from side to side
    Simulation simulation(test::scene(two_strips("Newmark", adapt(2), word("Passes", passes), 1)), world());
    RunOptions options;
    options.folder = folder("last");
    options.overwrite = true;
    std::shared_ptr<Simulation> last;
    options.stage = [&](const std::shared_ptr<Simulation>& next) { last = next; };
    EXPECT_EQ(run(simulation, options).status, RunStatus::Completed);
    ASSERT_TRUE(last);
    const Mesh& mesh = last->split_mesh().mesh();
    const std::size_t upper = side_set_named(mesh, "upper_bottom").sides.size(),
                      lower = side_set_named(mesh, "lower_top").sides.size();
    EXPECT_GT(upper, 12U);
    EXPECT_GT(lower, 12U);
    if (passes == std::string("Two")) {
      EXPECT_EQ(upper, lower) << "the scene is symmetric";
    }
  }
}

TEST_F(MeshFollowerTest, FrictionOfAPairGoesAlong) {
  const std::string pair = word("Passes", "Two") + number("Cutoff", 2) +
                           list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.3));
  const RunResult whole = expect_goes_on(two_strips("Newmark", adapt(2), pair, 1.5, checkpoints(10, 100)), {10, 20});
  EXPECT_GT(whole.mesh_changes.count, 2);
}

/// Two balls that fly at each other off centre; `mesh`: more of the list Mesh.
std::string two_balls(const std::string& mesh, double end) {
  const auto ball = [](const char* name, const std::vector<double>& center) {
    return list(name, word("Type", "Ball") + list("Ball", number("Diameter", 6) + numbers("Center", center)));
  };
  const auto material = [](const char* block) { return list(block, word("Block", block) + number("Density", 5e-7)); };
  const auto flight = [](const char* name, const char* blocks, double speed) {
    return list(name, texts("Blocks", blocks) + numbers("Velocity", {speed, 0, 0}));
  };
  return list("Mesh",
              word("Type", "Parts") + list("Parts", ball("left", {0, 0, 0}) + ball("right", {6.3, 2, 1})) + mesh) +
         list("Materials", material("left_body") + material("right_body")) +
         list("Interactions",
              list("Contact", word("Side Set", "right_surface") + word("Primary Side Set", "left_surface") +
                                  number("Cutoff", 2) + count("Surface Points", 3) + word("Smoothing", "None") +
                                  number("Gamma L", 2.5) + number("Gamma W", 25))) +
         list("Initial Conditions", flight("Left", "{left_body}", 15) + flight("Right", "{right_body}", -15)) +
         list("Time Integrator", word("Type", "Energy-Momentum") + steps(0.002, end));
}

TEST_F(MeshFollowerTest, TwoBallsInSpaceKeepTheirMomenta) {
  const RunResult result = run_scene(two_balls(adapt(1, number("Part", 0.5)), 0.06), "balls");
  ASSERT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_GT(result.mesh_changes.count, 1);
  world()->barrier();
  const HistoryTable rows = table("balls");
  const double momentum = rows.column("kinetic_energy").front() / 7.5;  // of one ball
  EXPECT_LT(*std::min_element(rows.column("min_gap").begin(), rows.column("min_gap").end()), 0.5);
  for (const char* axis : {"x", "y", "z"}) {
    const std::vector<double>&linear = rows.column(std::string("linear_momentum_") + axis),
          &angular = rows.column(std::string("angular_momentum_") + axis);
    for (std::size_t k = 0; k < rows.rows(); ++k) {
      EXPECT_NEAR(linear[k], linear[0], 1e-11 * momentum);
      EXPECT_NEAR(angular[k], angular[0], 1e-10 * 3 * momentum);
    }
  }
  expect_closed(rows, result.largest_energy);
}

/// Three stages: the strip is pulled, waits, and is pulled on by another scheme, with another law.
std::string staged_strip(const std::string& mesh, const std::string& output) {
  const auto stage = [](const std::string& scheme, double step, double end) {
    return list("Time Integrator", word("Type", scheme) + steps(step, end));
  };
  const std::string on =
      list("Histories", list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 1) + number("Length", 2)))) +
      list("Interactions", list("Wall", word("Factor", "0.8")));
  return strip("Average Vector Field", mesh, 0.05, 1, output) +
         list("Stages", list("Pull", "") + list("Wait", stage("Newmark", 0.05, 0.4)) +
                            list("On", on + stage("Average Vector Field", 0.025, 1.6)));
}

// The mesh changes with the last step, too: a run that ends and is continued is the same as one run.
TEST_F(MeshFollowerTest, ARunGoesOnPastItsFinalTimeBitForBit) {
  const auto scene = [](double end) {
    return strip("Average Vector Field", adapt(2), 0.05, end, checkpoints(4, 100) + count("Fields Interval", 4));
  };
  run_scene(scene(3), "whole");
  for (const long step : {8, 12, 16, 20, 24, 28, 32, 36, 40}) {
    run_scene(scene(0.05 * static_cast<double>(step)), "parts");
    run_scene(scene(3), "parts", checkpoint("parts", step));
    expect_same("whole", "parts", true);
  }
}

// A restart divides the mesh as the run did that came from another stage, and another folder begins with fields.e.
TEST_F(MeshFollowerTest, StagesOfAnotherKindGoOnBitForBit) {
  std::string scene = staged_strip(adapt(2), checkpoints(6, 100) + count("Fields Interval", 5));
  const std::string last = word("Type", "Average Vector Field") + steps(0.025, 1.6);
  scene.replace(scene.rfind(last), last.size(), word("Type", "Central Difference") + steps(5e-4, 0.02));
  const RunResult whole = expect_goes_on(scene, {24, 30, 60});
  EXPECT_GT(whole.mesh_changes.count, 1);
  run_scene(scene, "elsewhere", checkpoint("whole", 30));
  world()->barrier();
  EXPECT_TRUE(fs::exists(folder("elsewhere") + "/fields.e" + (world()->getSize() == 1 ? "" : ".2.0")));
}

TEST_F(MeshFollowerTest, StagesGoOnWithTheMesh) {
  const RunResult whole =
      expect_goes_on(staged_strip(adapt(2), checkpoints(6, 100) + count("Fields Interval", 5)), {12, 18, 24, 30, 60});
  EXPECT_EQ(whole.stages.size(), 2U);
  EXPECT_GT(whole.mesh_changes.count, 4);
  world()->barrier();
  const HistoryTable rows = table("whole");
  // The last stage keeps its balance from its first row on.
  const std::vector<double>&total = rows.column("total_energy"), &work = rows.column("external_work"),
        &adapted = rows.column("adapted_energy"), &lost = rows.column("dissipated_energy");
  const std::size_t first = 29;
  for (std::size_t k = first; k < rows.rows(); ++k)
    EXPECT_NEAR(total[k] + lost[k] - work[k] - adapted[k], total[first] + lost[first] - work[first] - adapted[first],
                1e-11 * whole.largest_energy)
        << k;
}

TEST_F(MeshFollowerTest, ACheckpointOfAnotherKindIsRefused) {
  const std::string output = checkpoints(5, 100);
  run_scene(strip("Newmark", "", 0.05, 0.5, output), "stays");
  EXPECT_NE(refusal(strip("Newmark", adapt(2), 0.05, 0.5, output), "stays", checkpoint("stays", 5))
                .find("its run had a mesh that stays, but that of the scene follows the front: Mesh/Adapt"),
            std::string::npos);
}

}  // namespace
}  // namespace ixos::test

// Results that a run replaces, and results that it leaves alone.
#include "run/replaced_results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "run/restart_fixture.hpp"
#include "support/refusal.hpp"

namespace ixos::test {
namespace {

class ReplacedResultsTest : public RestartTest {
 protected:
  std::string note(const std::string& scene, bool overwrite = false) const {
    const Simulation simulation(test::scene(scene), world());
    return replaced_results(simulation, folder("out"), overwrite).note;
  }
  std::string refused(const std::string& scene) const {
    return test::refusal([&] { note(scene); });
  }
  static std::string changed(std::string scene, const std::string& from, const std::string& to) {
    return scene.replace(scene.find(from), from.size(), to);
  }
  void write(const std::string& name, const std::string& text) {
    on_first([&] {
      fs::create_directories(folder("out"));
      std::ofstream(folder("out") + "/" + name) << text;
    });
  }
};

TEST_F(ReplacedResultsTest, AFolderWithoutResultsIsFree) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1));
  EXPECT_EQ(note(scene), "") << "no folder";
  write("fields.explained.txt", "mine");
  write("history.csv.bak", "mine");
  write("checkpoint-a.h5", "mine");
  EXPECT_EQ(note(scene), "");
  run_scene(scene, "out");
  world()->barrier();
  for (const char* name : {"fields.explained.txt", "history.csv.bak", "checkpoint-a.h5"})
    EXPECT_EQ(contents(folder("out") + "/" + name), "mine") << name;
}

TEST_F(ReplacedResultsTest, TheSameSceneMayRunAgain) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1));
  run_scene(scene, "out");
  const std::string replaces = folder("out") + ": this run replaces the results of the same scene.";
  EXPECT_EQ(note(scene), replaces);
  EXPECT_EQ(note(drawn(word("Type", "Newmark") + steps(0.02, 0.5), count("Fields Interval", 1))), replaces);
  EXPECT_EQ(note(scene + list("Nonlinear Solver", number("Tolerance", 1e-9))), replaces);
  EXPECT_EQ(note(scene + list("Linear Solver", word("Linear Solver Type", "Direct"))), replaces);
  // A parameter that an earlier version lacked has its default.
  const std::string path = folder("out") + "/effective.xml";
  on_first([&] {
    std::string text = contents(path);
    const auto start = text.rfind('<', text.find("\"Stiffness Damping\""));
    std::ofstream(path) << text.erase(start, text.find("/>", start) + 2 - start);
  });
  EXPECT_EQ(note(scene), replaces);
}

TEST_F(ReplacedResultsTest, AnotherSceneIsRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1));
  run_scene(scene, "out");
  world()->barrier();
  const auto before = all_files("out");
  const std::string start = folder("out") + ": the folder holds results of another scene (";
  const std::string end = "); choose another --output, or replace them with --overwrite";
  EXPECT_EQ(refused(changed(scene, "{6, 3}", "{6, 4}")), start + "Mesh/Box/Divisions: {6, 3}, now {6, 4}" + end);
  EXPECT_EQ(refused(changed(scene, "{0.1, 0}", "{0.3, 0}")),
            start + "Initial Conditions/Velocity: {0.1, 0}, now {0.3, 0}" + end);
  EXPECT_EQ(refused(scene + list("Units", word("Length", "1 mm"))),
            start + "Units/Length: \"1 nm\", now \"1 mm\"" + end);
  const std::string two = changed(changed(scene, "{0.02, 0}", "{0.03, 0}"), "{0.1, 0}", "{0.3, 0}");
  expect_contains(refused(two), "; and 1 more); choose");
  EXPECT_EQ(note(changed(scene, "{6, 3}", "{6, 4}"), true),
            folder("out") + ": this run replaces results of another scene (Mesh/Box/Divisions: {6, 3}, now {6, 4}).");
  EXPECT_TRUE(all_files("out") == before) << "something was changed";
}

TEST_F(ReplacedResultsTest, AnotherMeshUnderTheSameNameIsRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1));
  run_scene(scene, "out");
  write("summary.json", R"({"elements": 17, "dofs": 56})");  // 18 cells in truth
  expect_contains(refused(scene), "the folder holds results of another scene (the mesh has changed); choose");
  // As many cells, but other places or other nodes of cells.
  write("summary.json", R"({"elements": 18, "dofs": 56, "mesh_fingerprint": "00000000000000000000000000000000"})");
  expect_contains(refused(scene), "the mesh has changed");
  write("summary.json", "{\"elem");  // the scene alone decides
  expect_contains(note(scene), "replaces the results of the same scene");
}

TEST_F(ReplacedResultsTest, CheckpointsOfAReplacedSceneGo) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1), checkpoints(2, 3));
  run_scene(scene, "out");
  world()->barrier();
  ASSERT_FALSE(checkpoint_steps(folder("out")).empty());
  world()->barrier();
  // Neither scene writes any.
  const std::string plain = drawn(word("Type", "Newmark") + steps(0.02, 0.1), list("Checkpoint", count("Keep", 0)));
  run_scene(plain, "out");  // the same scene but for its output: they stay
  world()->barrier();
  EXPECT_FALSE(checkpoint_steps(folder("out")).empty());
  world()->barrier();
  run_scene(changed(plain, "{6, 3}", "{6, 4}"), "out");
  world()->barrier();
  EXPECT_TRUE(checkpoint_steps(folder("out")).empty());
  world()->barrier();
}

TEST_F(ReplacedResultsTest, FilesOfOthersWithTheSameNamesAreRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.1));
  write("history.csv", "year,event\n");
  write("fields.e.2.0", "");
  expect_contains(refused(scene),
                  "the folder holds fields.e.2.0, history.csv, but no effective.xml that tells their scene; choose");
  write("effective.xml", "<html/>");
  expect_contains(refused(scene), "and the scene of effective.xml cannot be read (");
  EXPECT_EQ(contents(folder("out") + "/history.csv"), "year,event\n");
}

}  // namespace
}  // namespace ixos::test

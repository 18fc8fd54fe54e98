// What a restart refuses, with a clear word, and which checkpoints a folder keeps for it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "run/restart_fixture.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_changes.hpp"

namespace ixos::test {
namespace {

TEST_F(RestartTest, TheLastOnesAreKeptAndOtherRunsAreTidiedAway) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(10, 3));
  run_scene(scene, "whole");
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{30, 40, 50}));
  EXPECT_EQ(fs::read_symlink(folder("whole") + "/checkpoint.h5"), "checkpoint-50.h5");
  // Back to an earlier one: those after it are of a history that is no more.
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 0.7), checkpoints(5, 3)), "whole", checkpoint("whole", 30));
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{30, 35}));
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 1), checkpoints(10, 0)), "none");
  EXPECT_TRUE(checkpoint_steps(folder("none")).empty());
}

TEST_F(RestartTest, TheClockAsksForCheckpointsToo) {
  // Every step is longer than that.
  run_scene(drawn(word("Type", "Newmark") + steps(0.02, 0.2),
                  list("Checkpoint", number("Wall-Clock Interval", 1e-9) + count("Keep", 99))),
            "whole");
  world()->barrier();
  EXPECT_EQ(checkpoint_steps(folder("whole")), (std::vector<long>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_F(RestartTest, ChangesThatARestartCannotMakeAreRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.2));
  run_scene(scene, "whole");
  const std::string file = checkpoint("whole", 10);
  std::string other = scene;
  other.replace(other.find("{6, 3}"), 6, "{6, 4}");
  EXPECT_NE(refusal(other, "whole", file).find("Mesh/Box/Divisions: {6, 3}, now {6, 4}"), std::string::npos)
      << refusal(other, "whole", file);
  other = scene;
  other.replace(other.find("{2, 1}"), 6, "{2, 1.5}");
  EXPECT_NE(refusal(other, "whole", file).find("belongs to another mesh"), std::string::npos);
  other = scene;
  other.replace(other.find("{0.1, 0}"), 8, "{0.3, 0}");
  EXPECT_NE(refusal(other, "whole", file).find("Initial Conditions/Velocity: {0.1, 0}, now {0.3, 0}"),
            std::string::npos)
      << refusal(other, "whole", file);
  other = scene;
  other.replace(other.find("{left}"), 6, "{}");
  EXPECT_NE(refusal(other, "whole", file).find("other columns"), std::string::npos);
}

TEST_F(RestartTest, AHistoryOfAnotherRunIsNotGoneOnWith) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  run_scene(scene, "whole");
  on_first([&] { std::ofstream(folder("whole") + "/history.csv", std::ios::app) << "21,"; });
  run_scene(scene, "whole", checkpoint("whole", 10));  // what is beyond the checkpoint does not matter
  copy("whole", "short");
  on_first([&] { fs::resize_file(folder("short") + "/history.csv", 1000); });
  EXPECT_NE(refusal(scene, "short", checkpoint("short", 10)).find("cannot resume: its first"), std::string::npos);
  on_first([&] { fs::remove(folder("short") + "/history.csv"); });
  EXPECT_NE(refusal(scene, "short", checkpoint("short", 10)).find("cannot resume: the table is missing"),
            std::string::npos);
}

TEST_F(RestartTest, DamagedCheckpointsAreRefusedAndTheOneBeforeIsOffered) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.6), checkpoints(10, 9));
  run_scene(scene, "whole");
  const std::string last = checkpoint("whole", 30), before = checkpoint("whole", 20), first = checkpoint("whole", 10);
  on_first([&] {
    std::fstream file(last, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(3000);
    file.put('!');
  });
  EXPECT_NE(refusal(scene, "whole", last)
                .find("checkpoint-30.h5: is damaged: its checksum does not fit its contents; an "
                      "earlier checkpoint is sound: "),
            std::string::npos);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/checkpoint.h5").find(before), std::string::npos);
  on_first([&] { fs::resize_file(before, 100); });
  EXPECT_NE(refusal(scene, "whole", last).find(first), std::string::npos);
  on_first([&] {
    fs::remove(first);
    fs::remove(last);
  });
  EXPECT_NE(refusal(scene, "whole", last).find("no earlier checkpoint is sound"), std::string::npos)
      << refusal(scene, "whole", last);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/checkpoint.h5").find("checkpoint-30.h5: cannot be read"),
            std::string::npos);
  EXPECT_NE(refusal(scene, "whole", folder("whole") + "/history.csv").find("is not a checkpoint of Ixos"),
            std::string::npos);
}

TEST_F(RestartTest, ARefusalByOneFileLeavesAllAsTheyWere) {
  const std::string scene =
      drawn(word("Type", "Newmark") + steps(0.02, 0.6), count("Fields Interval", 5) + checkpoints(10, 9));
  run_scene(scene, "whole");
  copy("whole", "parts");
  // The last rank's frames are gone.
  const std::string last = world()->getSize() == 1
                               ? "fields.e"
                               : fmt::format("fields.e.{0}.{1}", world()->getSize(), world()->getSize() - 1);
  on_first([&] { fs::resize_file(folder("parts") + "/" + last, 2000); });
  EXPECT_NE(refusal(scene, "parts", checkpoint("parts", 10)).find(last), std::string::npos);
  on_first([&] {
    fs::copy_file(folder("whole") + "/" + last, folder("parts") + "/" + last, fs::copy_options::overwrite_existing);
  });
  expect_same("whole", "parts", true);
  // A later checkpoint still finds its rows and frames.
  run_scene(scene, "parts", checkpoint("parts", 20));
  expect_same("whole", "parts", true);
}

TEST_F(RestartTest, TheLinkFollowsWhereARunGoesBack) {
  const auto scene = [](double end) { return drawn(word("Type", "Newmark") + steps(0.02, end), checkpoints(10, 9)); };
  run_scene(scene(0.6), "whole");
  // Killed as soon as it has begun: nothing is written after the files were cut back.
  run_scene(scene(0.6), "whole", checkpoint("whole", 10), [] { return true; });
  world()->barrier();
  EXPECT_EQ(fs::read_symlink(folder("whole") + "/checkpoint.h5"), "checkpoint-10.h5");
  EXPECT_EQ(run_scene(scene(0.6), "whole", folder("whole") + "/checkpoint.h5").steps, 30);
  EXPECT_EQ(run_scene(scene(0.6), "whole", folder("whole")).steps, 30) << "a folder stands for its newest";
}

TEST_F(RestartTest, AFreshRunDoesNotPassForTheEarlierOne) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 2));
  run_scene(scene, "whole");
  int calls = 0;
  const auto kill = [&calls]() -> bool {
    if (++calls > 5) throw std::runtime_error("killed");
    return false;
  };
  EXPECT_THROW(run_scene(scene, "whole", "", kill), std::runtime_error);
  if (world()->getRank() == 0) {
    EXPECT_NE(told_.find("has checkpoints of an earlier run, up to step 20"), std::string::npos) << told_;
  }
  world()->barrier();
  EXPECT_FALSE(fs::exists(folder("whole") + "/checkpoint.h5"));
  EXPECT_NE(refusal(scene, "whole", checkpoint("whole", 20)).find("cannot resume: its first"), std::string::npos);
}

TEST_F(RestartTest, AMotionThatWouldJumpIsRefused) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  run_scene(scene, "whole");
  std::string other = scene;
  other.replace(other.find("value=\"-0.5\""), 12, "value=\"-0.6\"");
  const std::string message = refusal(other, "whole", checkpoint("whole", 10));
  EXPECT_NE(message.find("a prescribed displacement would jump by 0.03"), std::string::npos) << message;
  EXPECT_NE(message.find("checkpoint-10.h5: "), std::string::npos) << message;
}

TEST_F(RestartTest, LeftoversOfAKilledWriteAreTidiedAway) {
  const std::string scene = drawn(word("Type", "Newmark") + steps(0.02, 0.4), checkpoints(10, 9));
  on_first([&] {
    fs::create_directories(folder("whole"));
    std::ofstream(folder("whole") + "/checkpoint-7.h5.tmp") << "half";
  });
  run_scene(scene, "whole");
  world()->barrier();
  EXPECT_FALSE(fs::exists(folder("whole") + "/checkpoint-7.h5.tmp"));
}

TEST(SceneChangesTest, ChangesAreNamedAndJudged) {
  const auto scene = [](const std::string& text) { return test::scene(text); };
  const auto before = scene(list("A", number("x", 1) + word("w", "one")) + list("Output", count("Fields Interval", 3)) +
                            list("Interactions", list("Wall", word("Side Set", "s"))) +
                            list("Initial Conditions", numbers("Velocity", {1})));
  const auto now = scene(list("A", number("x", 1.5) + number("y", 2)) + list("Output", count("Fields Interval", 4)) +
                         list("Interactions", list("Wall", word("Side Set", "t"))) +
                         list("Initial Conditions", numbers("Velocity", {2})));
  const auto changes = scene_changes(before, now);
  ASSERT_EQ(changes.size(), 6U);
  EXPECT_EQ(changes[0].text(), "A/x: 1, now 1.5");
  EXPECT_EQ(changes[1].text(), "A/y: absent, now 2");
  EXPECT_EQ(changes[2].text(), "A/w: \"one\", now absent");
  EXPECT_EQ(changes[2].bearing, Bearing::Motion);
  EXPECT_EQ(changes[3].bearing, Bearing::None);
  EXPECT_EQ(changes[4].bearing, Bearing::Motion);
  EXPECT_EQ(changes[5].text(), "Initial Conditions/Velocity: {1}, now {2}");
  EXPECT_EQ(changes[5].bearing, Bearing::State);
  EXPECT_TRUE(scene_changes(before, before).empty());
}

TEST(SceneChangesTest, ParametersThatAnEarlierVersionLackedHaveTheirDefaults) {
  const Teuchos::ParameterList now = complete_scene(test::scene(drawn(word("Type", "Newmark") + steps(0.02, 0.2))));
  Teuchos::ParameterList earlier(now);
  Teuchos::ParameterList& wall = earlier.sublist("Interactions").sublist("Wall");
  wall.remove("Step Margin");
  EXPECT_EQ(scene_changes(earlier, now).size(), 1U);
  EXPECT_TRUE(scene_changes(with_defaults(earlier), now).empty());
  // A parameter that is no more stays a change.
  wall.set("Former", 1.0);
  EXPECT_FALSE(scene_changes(with_defaults(earlier), now).empty());
}

}  // namespace
}  // namespace ixos::test

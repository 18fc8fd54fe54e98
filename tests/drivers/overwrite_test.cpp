// Results folders that are not empty: another scene's results stay as they are.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

class OverwriteTest : public DriverTest {
 protected:
  Outcome run(const std::string& more, int ranks = 1) const {
    const std::string launcher = ranks == 1 ? "" : "mpiexec -np " + std::to_string(ranks) + " ";
    return shell(
        launcher + quoted_driver() + " " + ball + " --output out --set '" + step_control + "Final Time=0.01' " + more,
        folder_);
  }
  std::string history() const { return contents(folder_ + "/out/history.csv"); }
  const std::string step_control = "Time Integrator/Time Step Control/";
};

TEST_F(OverwriteTest, AnotherScenesResultsAreRefusedUnlessAsked) {
  ASSERT_EQ(run("--quiet").status, 0);
  const std::string before = history(), summary = contents(folder_ + "/out/summary.json");
  const std::string other = "--quiet --set 'Materials/Ball/Density=1e-6'";
  for (int ranks : {1, 2}) {
    const Outcome refused = run(other, ranks);
    EXPECT_EQ(refused.status, 2) << refused.output;
    const std::string message =
        "ixos: out: the folder holds results of another scene (Materials/Ball/Density: 5e-07, now 1e-06); choose "
        "another --output, or replace them with --overwrite\n";
    EXPECT_NE(refused.output.find(message), std::string::npos) << refused.output;
    EXPECT_EQ(refused.output.find(message), refused.output.rfind(message)) << "said by both ranks";
    EXPECT_EQ(history(), before);
    EXPECT_EQ(contents(folder_ + "/out/summary.json"), summary);
  }
  const Outcome replaced = run("--overwrite --set 'Materials/Ball/Density=1e-6'");
  EXPECT_EQ(replaced.status, 0) << replaced.output;
  EXPECT_NE(replaced.output.find("out: this run replaces results of another scene (Materials/Ball/Density"),
            std::string::npos)
      << replaced.output;
  EXPECT_NE(history(), before);
}

TEST_F(OverwriteTest, TheSameSceneRunsAgainAndSaysSo) {
  ASSERT_EQ(run("").output.find("replaces"), std::string::npos) << "a fresh folder";
  for (int ranks : {1, 2}) {
    const Outcome again = run("--set '" + step_control + "Final Time=0.02'", ranks);
    EXPECT_EQ(again.status, 0) << again.output;
    EXPECT_NE(again.output.find("out: this run replaces the results of the same scene.\n"), std::string::npos)
        << again.output;
  }
}

TEST_F(OverwriteTest, ARestartInItsOwnFolderReplacesNothing) {
  ASSERT_EQ(run("--quiet").status, 0);
  const Outcome rest = run("--set '" + step_control + "Final Time=0.02' --restart out");
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(rest.output.find("replaces"), std::string::npos) << rest.output;
  // From another folder's checkpoint the results are new ones.
  ASSERT_EQ(shell("cp -r out kept", folder_).status, 0);
  const Outcome other = run("--set 'Materials/Ball/Density=1e-6' --restart kept");
  EXPECT_EQ(other.status, 2) << other.output;
  EXPECT_NE(other.output.find("out: the folder holds results of another scene"), std::string::npos) << other.output;
}

TEST_F(OverwriteTest, AMeshIsWrittenToANewFileUnlessAsked) {
  std::ofstream(folder_ + "/mine.e") << "mine";
  for (int ranks : {1, 2}) {
    const Outcome refused = run("--write-mesh mine.e", ranks);
    EXPECT_EQ(refused.status, 2) << refused.output;
    EXPECT_NE(
        refused.output.find("ixos: --write-mesh: mine.e exists; choose another name, or replace it with --overwrite\n"),
        std::string::npos)
        << refused.output;
    EXPECT_EQ(contents(folder_ + "/mine.e"), "mine");
  }
  EXPECT_EQ(run("--write-mesh mine.e --overwrite").status, 0);
  EXPECT_NE(contents(folder_ + "/mine.e"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out"));
}

TEST_F(OverwriteTest, OverwriteAloneNeedsAScene) { EXPECT_EQ(ixos({"--overwrite"}, folder_).status, 2); }

}  // namespace
}  // namespace ixos::test

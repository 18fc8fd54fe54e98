// ixos --verify-restart.
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

const std::string final_time = "Time Integrator/Time Step Control/Final Time=";

class VerifyRestartTest : public DriverTest {
 protected:
  /// The ball with 20 steps.
  Outcome verify(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{ball,    "--verify-restart",        "--set", final_time + "0.02",
                                       "--set", "Output/Fields Interval=5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ixos(arguments, folder_);
  }
};

TEST_F(VerifyRestartTest, TheBallResumesBitForBit) {
  const Outcome outcome = verify({"--kill-steps", "12,3"});
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "Runs " + ball +
                                " without kills, then with kills. Results and messages go to ball.restarts\n"
                                "Undisturbed: 20 steps\n"
                                "From the beginning, killed after step 4: the same up to step 3\n"
                                "Resumed from step 3, killed after step 13: the same up to step 12\n"
                                "Resumed from step 12: the same up to the end\n"
                                "Restarts are verified.\n");
  const std::string summary = contents(folder_ + "/ball.restarts/killed/summary.json");
  EXPECT_NE(summary.find("\"restarts\": 2"), std::string::npos) << summary;
}

TEST_F(VerifyRestartTest, TwoRanksAreKilledAndResumed) {
  const Outcome outcome = verify({"--ranks", "2", "--kills", "1", "--output", "out", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "");
  const std::string summary = contents(folder_ + "/out/killed/summary.json");
  EXPECT_NE(summary.find("\"ranks\": 2"), std::string::npos) << summary;
}

TEST_F(VerifyRestartTest, ARunThatIsKilledLeavesItsRowsAndNoSummary) {
  const Outcome outcome =
      ixos({ball, "--output", "out", "--set", final_time + "0.02", "--kill-after-step", "7"}, folder_);
  EXPECT_EQ(outcome.status, 128 + 9) << outcome.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out/summary.json"));
}

TEST_F(VerifyRestartTest, BadInputIsRefusedBeforeAnythingIsWritten) {
  const std::vector<std::string> start{ball, "--verify-restart", "--output", "out"};
  const auto refused = [&](std::vector<std::string> more, const std::string& message) {
    more.insert(more.begin(), start.begin(), start.end());
    expect_refused(2, more, message);
  };
  refused({"--set", "Mehs/Type=Box"}, "ixos: --set Mehs/Type: there is no list \"Mehs\" here; did you mean \"Mesh\"?");
  refused({"--kills", "0"}, "--kills: Value 0 not in range");
  refused({"--kill-steps", "3,0"}, "--kill-steps: Value 0 not in range");
  refused({"--kills", "2", "--kill-steps", "3"}, "excludes");
  refused({"--check"}, "excludes");
  refused({"--restart", "x.h5"}, "excludes");
  expect_refused(2, {ball, "--kills", "2"}, "--kills requires --verify-restart");
  expect_refused(2, {"none.xml", "--verify-restart"}, "none.xml: ");
  expect_refused(2, {"--verify-restart"}, "a scene is needed: ixos SCENE.xml --verify-restart");
  const Outcome launched = shell("mpiexec -np 2 " + quoted_driver() + " " + ball + " --verify-restart", folder_);
  EXPECT_NE(launched.status, 0);
  const std::string message = "ixos: --verify-restart starts its runs itself: call it without mpirun, with --ranks N\n";
  EXPECT_NE(launched.output.find(message), std::string::npos) << launched.output;
  EXPECT_EQ(launched.output.find(message), launched.output.rfind(message)) << "said by both ranks";
}

TEST_F(VerifyRestartTest, AStepBeyondTheRunAndARunWithoutStepsAreRefused) {
  const Outcome beyond = verify({"--kill-steps", "20"});
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.output.find("--kill-steps: 20: the run has 20 steps; allowed are 1 to 19"), std::string::npos);
  const Outcome none = ixos({ball, "--verify-restart", "--set", final_time + "0.001", "--output", "short"}, folder_);
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.output.find("a run of 1 step(s) is too short to be killed and resumed"), std::string::npos)
      << none.output;
}

TEST_F(VerifyRestartTest, TheMessageOfARunThatFailsIsPassedOn) {
  for (const char* ranks : {"1", "2"}) {
    const Outcome outcome =
        verify({"--set", "Materials/Ball/Block=nowhere", "--quiet", "--output", "bad", "--ranks", ranks});
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_EQ(outcome.output.find("ixos: " + ball + ": Materials: block \"nowhere\" does not exist"), 0U)
        << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/bad"));
  }
}

}  // namespace
}  // namespace ixos::test

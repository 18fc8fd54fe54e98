// What the machine takes away: standard output, the terminal, memory. The exit status and the words are true.
#include <gtest/gtest.h>

#include <utility>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"
#include "support/sanitized.hpp"

namespace ixos::test {
namespace {

const std::string endless =
    " --set 'Time Integrator/Time Step Control/Final Time=1e6' --set Output/Checkpoint/Interval=20";

/// Starts a run that would not end, and waits until it has begun to compute; $pid is its process.
std::string begun(const std::string& prefix = "") {
  return prefix + quoted_driver() + " " + ball + " --quiet --output out" + endless +
         " & pid=$!; until [ -e out/checkpoint.h5 ] || ! kill -0 $pid; do sleep 0.01; done; ";
}

class FailuresTest : public DriverTest {};

TEST_F(FailuresTest, LostStandardOutputIsExitStatusFour) {
  const std::string short_run = ball + " --set 'Time Integrator/Time Step Control/Final Time=0.002' --output out";
  for (const std::string& arguments :
       {std::string("--version"), std::string("--help"), std::string("--list-schemes"), std::string("--parameters"),
        std::string("--template ball"), std::string(), ball + " --check", ball + " --explain", short_run}) {
    const Outcome outcome = shell(quoted_driver() + " " + arguments + " > /dev/full", folder_);
    EXPECT_EQ(outcome.status, 4) << arguments;
    EXPECT_NE(outcome.output.find("standard output: cannot be written: No space left on device"), std::string::npos)
        << arguments << ": " << outcome.output;
  }
  for (const char* arguments : {"--version", "--help", "--parameters"}) {
    const Outcome outcome = shell(std::string(IXOS_STUDY_DRIVER) + " " + arguments + " > /dev/full", folder_);
    EXPECT_EQ(outcome.status, 4) << arguments;
  }
  // The run itself was not disturbed.
  EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"completed\""), std::string::npos);
}

TEST_F(FailuresTest, AReaderThatLeavesIsExitStatusFourAndNoSignal) {
  const Outcome outcome = shell("{ " + quoted_driver() + " --parameters; echo \"status $?\" >&2; } | true", folder_);
  EXPECT_NE(outcome.output.find("status 4"), std::string::npos) << outcome.output;
}

TEST_F(FailuresTest, AnAnswerOfOneRankIsTheAnswerOfAll) {
  const Outcome outcome = shell("mpirun -np 2 " + quoted_driver() + " --template nonsense", folder_);
  EXPECT_NE(outcome.output.find("ixos: --template: "), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.status, 2) << outcome.output;
}

TEST_F(FailuresTest, SignalsAreExitStatusFiveWithACheckpoint) {
  for (const char* signal : {"TERM", "INT", "HUP"}) {
    std::filesystem::remove_all(folder_ + "/out");
    const Outcome outcome = shell("set -m; " + begun() + "kill -" + signal + " $pid; wait $pid", folder_);
    EXPECT_EQ(outcome.status, 5) << signal << outcome.output;
    EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"interrupted\""), std::string::npos) << signal;
    EXPECT_EQ(ixos({ball, "--set", "Time Integrator/Time Step Control/Final Time=1e6", "--set",
                    "Output/Checkpoint/Interval=20", "--check", "--restart", "out", "--output", "out"},
                   folder_)
                  .status,
              0);
  }
}

TEST_F(FailuresTest, NohupOutlivesItsTerminal) {
  const Outcome outcome = shell(begun("nohup ") + "kill -HUP $pid; kill -TERM $pid; wait $pid", folder_);
  EXPECT_EQ(outcome.status, 5) << outcome.output;
}

TEST_F(FailuresTest, WantOfMemoryIsExitStatusThreeWithWhatWasAskedFor) {
  if (sanitized()) GTEST_SKIP() << "AddressSanitizer needs more address space than the limit leaves";
  const std::string start = "ulimit -v 1000000; " + quoted_driver() + " " + ball +
                            " --set Mesh/Type=Box --set 'Mesh/Box/Divisions={7000, 7000}' ";
  for (const auto& [option, message] :
       {std::pair("--check", "ixos: out of memory: "),
        std::pair("--verify-restart", "ixos: a run ended with exit status 3: out of memory: ")}) {
    const Outcome outcome = shell(start + option, folder_);
    EXPECT_EQ(outcome.status, 3) << outcome.output;
    EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find(" were asked for"), std::string::npos) << outcome.output;
  }
}

}  // namespace
}  // namespace ixos::test

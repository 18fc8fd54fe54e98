// The check of restarts, with a script in place of the program: one that resumes well, and ones that do not.
#include "study/restart/restart_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

/// Runs 10 steps whose energy is the square of the step. The "scene" says what goes wrong.
const char* const program = R"x(#!/bin/bash
scene=$1 from=0 kill=0
while [ $# -gt 0 ]; do
  case $1 in
    --output) out=$2 ;;
    --restart) from=${2##*checkpoint-}; from=${from%.h5}; [ -e "$2" ] || exit 2 ;;
    --kill-after-step) kill=$2 ;;
    --set) case $2 in Output/Checkpoint/Interval=*) interval=${2##*=} ;; esac ;;
  esac
  shift
done
echo "$scene from $from" >> "${out%/*}/calls"
mkdir -p "$out"
[ $from != 0 ] || echo step,total_energy,wall_seconds > "$out/history.csv"
head -n $((from + 1)) "$out/history.csv" > "$out/kept" && mv "$out/kept" "$out/history.csv"
[ $scene != unlucky ] || { echo "the disk is full"; exit 4; }
[ $scene != unstarted ] || { printf -- '---\nno slots\nAsk for fewer\n---\n'; exit 127; }
[ $scene != starved$from ] || { printf 'ixos: warning: odd\nixos: out of memory\n'; exit 3; }
[ $scene != killed ] || { printf 'x: 4 cells\nixos: warning: odd\n'; kill -KILL $$; }
[ $scene != refused ] || { rm -r "$out" "${out%/*}/calls"; printf -- '---\nno OpenFabrics\n---\nNotes\nixos: warning: odd\nixos: x.xml: bad:\n  all\n----\nended'; exit 2; }
for step in $(seq $((from + 1)) 10); do
  energy=$((step * step))
  [ $scene != forgets ] || [ $from = 0 ] || [ $step -lt 6 ] || energy=0
  [ $scene != varies ] || [ $kill = 0 ] || energy=0
  echo "$step,$energy,$RANDOM" >> "$out/history.csv"
  [ $step != $kill ] || kill -KILL $$
  [ $step != "$interval" ] || touch "$out/checkpoint-$step.h5"
done
[ $scene != rounds ] || [ $from = 0 ] || steps=9
[ $scene != diverges ] || status=diverged
echo "{\"status\": \"${status:-completed}\", \"steps\": ${steps:-10}, \"restarts\": $from}" > "$out/summary.json"
[ $scene != diverges ] || exit 3
)x";

class RestartCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ + "/program") << program;
    std::filesystem::permissions(folder_ + "/program", std::filesystem::perms::owner_all);
    check_.driver = {folder_ + "/program"};
    check_.folder = folder_ + "/results";
    check_.log = [this](const std::string& line) { told_ += line + '\n'; };
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  RestartCheckResult run(const std::string& scene) {
    check_.scene = scene;
    return check_restarts(check_);
  }

  std::string folder_ = testing::TempDir() + "restart_check";
  RestartCheck check_;
  std::string told_;
};

TEST_F(RestartCheckTest, ASceneThatResumesWellIsVerifiedInOneChainOfKills) {
  const RestartCheckResult result = run("good");
  EXPECT_EQ(result.status, RestartCheckStatus::Same) << result.message;
  // Ten steps and three kills, spread evenly: 10/4, 20/4, 30/4.
  EXPECT_EQ(test::contents(check_.folder + "/calls"),
            "good from 0\ngood from 0\ngood from 2\ngood from 5\ngood from 7\n");
  EXPECT_EQ(told_, "Runs good without kills, then with kills. Results and messages go to " + check_.folder +
                       "\nUndisturbed: 10 steps\n"
                       "From the beginning, killed after step 3: the same up to step 2\n"
                       "Resumed from step 2, killed after step 6: the same up to step 5\n"
                       "Resumed from step 5, killed after step 8: the same up to step 7\n"
                       "Resumed from step 7: the same up to the end\n");
}

TEST_F(RestartCheckTest, StepsMayBeChosenDownToTheFirstAndTheLastButOne) {
  check_.steps = {1, 2, 9};
  EXPECT_EQ(run("good").status, RestartCheckStatus::Same) << told_;
  check_.steps = {1, 10};
  try {
    run("good");
    ADD_FAILURE() << "there is nothing left to resume after the last step";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--kill-steps: 10: the run has 10 steps; allowed are 1 to 9");
  }
}

TEST_F(RestartCheckTest, MoreKillsThanStepsAreOneForEachStep) {
  check_.kills = 999'999'999;
  EXPECT_EQ(run("good").status, RestartCheckStatus::Same);
  EXPECT_NE(told_.find("Resumed from step 8, killed after step 10"), std::string::npos) << told_;
}

TEST_F(RestartCheckTest, ARunThatDivergesIsVerifiedUpToThere) {
  EXPECT_EQ(run("diverges").status, RestartCheckStatus::Same);
  EXPECT_NE(told_.find("\nUndisturbed: 10 steps, then the solution cannot be continued\n"), std::string::npos) << told_;
}

TEST_F(RestartCheckTest, TheFirstDifferenceEndsTheCheck) {
  const RestartCheckResult result = run("forgets");
  EXPECT_EQ(result.status, RestartCheckStatus::Different);
  EXPECT_EQ(result.message, "history.csv: step 6, column total_energy: 36 and 0");
  EXPECT_NE(told_.find("Resumed from step 5: DIFFERENT: history.csv: step 6"), std::string::npos) << told_;
  EXPECT_EQ(told_.find("the end"), std::string::npos) << told_;
}

TEST_F(RestartCheckTest, ADifferenceBeforeTheFirstKillIsNoneOfARestart) {
  const RestartCheckResult result = run("varies");
  EXPECT_EQ(result.status, RestartCheckStatus::Unrepeatable);
  EXPECT_EQ(result.message, "history.csv: step 1, column total_energy: 1 and 0");
}

TEST_F(RestartCheckTest, ADifferenceInTheSummaryIsFoundAtTheEnd) {
  const RestartCheckResult result = run("rounds");
  EXPECT_EQ(result.status, RestartCheckStatus::Different);
  EXPECT_EQ(result.message, "summary.json: steps: 10 and 9");
}

TEST_F(RestartCheckTest, ARunThatFailsGivesItsStatusAndItsWords) {
  const RestartCheckResult result = run("unlucky");
  EXPECT_EQ(result.status, RestartCheckStatus::RunFailed);
  EXPECT_EQ(result.exit_status, 4);
  const std::string log = check_.folder + "/undisturbed.log";
  EXPECT_EQ(result.message, "a run ended with exit status 4: the disk is full (all messages are in " + log + ")");
}

TEST_F(RestartCheckTest, AStatusThatIsNoneOfIxosBecomesThatOfCommunication) {
  const RestartCheckResult result = run("unstarted");
  EXPECT_EQ(result.status, RestartCheckStatus::RunFailed);
  EXPECT_EQ(result.exit_status, 4);
  EXPECT_EQ(result.message.find("a run ended with exit status 127: no slots (all"), 0U) << result.message;
}

TEST_F(RestartCheckTest, AWarningIsNoCauseOfAnEnd) {
  const RestartCheckResult result = run("killed");
  EXPECT_EQ(result.status, RestartCheckStatus::RunFailed);
  EXPECT_EQ(result.exit_status, 4);
  EXPECT_EQ(result.message.find("a run ended with exit status 137: x: 4 cells (all"), 0U) << result.message;
}

TEST_F(RestartCheckTest, MemoryThatRunsOutIsNoDivergence) {
  for (const char* from : {"0", "2", "7"}) {  // the undisturbed run, a part that would be killed, and the last part
    std::filesystem::remove_all(check_.folder);
    const RestartCheckResult result = run(std::string("starved") + from);
    EXPECT_EQ(result.status, RestartCheckStatus::RunFailed);
    EXPECT_EQ(result.exit_status, 3);
    EXPECT_EQ(result.message.find("a run ended with exit status 3: out of memory (all"), 0U) << result.message;
  }
}

TEST_F(RestartCheckTest, ARefusedSceneGivesTheMessageOfIxosAndLeavesNothing) {
  const RestartCheckResult result = run("refused");
  EXPECT_EQ(result.status, RestartCheckStatus::Refused);
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_EQ(result.message, "x.xml: bad:\n  all") << "neither warning nor words of the launcher, before and after it";
  EXPECT_FALSE(std::filesystem::exists(check_.folder));
}

TEST_F(RestartCheckTest, AnInterruptionEndsIt) {
  check_.interrupted = [] { return true; };
  EXPECT_EQ(run("good").status, RestartCheckStatus::Interrupted);
}

}  // namespace
}  // namespace ixos

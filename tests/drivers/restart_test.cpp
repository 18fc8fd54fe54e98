// Restarts from the command line: signals, other numbers of ranks, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

const std::string control = "Time Integrator/Time Step Control/";

class RestartDriverTest : public DriverTest {
 protected:
  /// The ball to time 2, on some ranks; `more` are words for the shell.
  std::string command(const std::string& more, int ranks = 1) const {
    const std::string launcher = ranks == 1 ? "" : "mpiexec -np " + std::to_string(ranks) + " ";
    return launcher + quoted_driver() + " " + ball + " --set '" + control +
           "Final Time=2' --set 'Output/Fields Interval=50' " + more;
  }
  Outcome run(const std::string& more, int ranks = 1) const { return shell(command(more, ranks), folder_); }
  /// Starts a run that would not end, waits for its first checkpoint, and executes `then`; $pid is the process.
  Outcome interrupt(const std::string& more, const std::string& then, int ranks = 1) const {
    return run("--set '" + control + "Final Time=1e6' --output parts " + more +
                   " & pid=$!; until [ -e parts/checkpoint.h5 ] || ! kill -0 $pid; do sleep 0.02; done; " + then +
                   "; wait $pid",
               ranks);
  }
  /// Returns the option that ends a run some steps after the newest checkpoint in "parts".
  std::string soon_after() const {
    const std::string newest = std::filesystem::read_symlink(path("parts/checkpoint.h5")).filename();
    const long step = std::stol(newest.substr(newest.find('-') + 1));
    return "--set '" + control + "Final Time=" + std::to_string(0.001 * static_cast<double>(step + 70)) + "' ";
  }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
};

TEST_F(RestartDriverTest, ASignalledRunGoesOnAsIfNothingHadHappened) {
  for (const std::string signal : {"TERM", "INT"}) {
    const Outcome told = interrupt("--set Output/Checkpoint/Interval=200", "kill -" + signal + " $pid");
    ASSERT_EQ(told.status, 5) << told.output;
    // The command that is printed is the whole one.
    const auto advice = told.output.find("to resume: ixos " + ball + " --set 'Time Integrator/Time Step");
    EXPECT_NE(advice, std::string::npos) << told.output;
    EXPECT_NE(told.output.find(" --set Output/Checkpoint/Interval=200 --output parts --restart parts/checkpoint-"),
              std::string::npos)
        << told.output;
    EXPECT_NE(contents(path("parts/summary.json")).find("\"status\": \"interrupted\""), std::string::npos);
    const std::string end = soon_after();
    const Outcome rest = run(end + "--output parts --restart parts/checkpoint.h5");
    EXPECT_EQ(rest.status, 0) << rest.output;
    EXPECT_NE(rest.output.find("Resumes from "), std::string::npos) << rest.output;
    ASSERT_EQ(run(end + "--output whole").status, 0);
    EXPECT_EQ(history_rows(path("parts")), history_rows(path("whole")));
    EXPECT_TRUE(contents(path("parts/fields.e")) == contents(path("whole/fields.e")));
    EXPECT_NE(contents(path("parts/summary.json")).find("\"restarts\": 1"), std::string::npos);
    std::filesystem::remove_all(path("parts"));
    std::filesystem::remove_all(path("whole"));
  }
}

TEST_F(RestartDriverTest, ASignalToOneRankEndsAllAndOneThatDiesTakesTheOthersAlong) {
  const std::string settings = "--quiet --set Output/Checkpoint/Interval=100";
  const auto second_rank = [](const std::string& signal) {
    return "for p in $(pgrep -P $pid); do tr '\\0' '\\n' < /proc/$p/environ | grep -qx OMPI_COMM_WORLD_RANK=1 && kill "
           "-" +
           signal + " $p; done";
  };
  const Outcome told = interrupt(settings, second_rank("TERM"), 2);
  EXPECT_EQ(told.status, 5) << told.output;
  EXPECT_NE(contents(path("parts/summary.json")).find("\"status\": \"interrupted\""), std::string::npos);
  std::filesystem::remove_all(path("parts"));
  const Outcome died = interrupt(settings, second_rank("KILL"), 2);
  EXPECT_NE(died.status, 0);
  const Outcome rest = run(soon_after() + "--output parts --quiet --restart parts/checkpoint.h5", 2);
  EXPECT_EQ(rest.status, 0) << rest.output;
}

TEST_F(RestartDriverTest, AnotherNumberOfRanksGoesOnToSolverTolerance) {
  const std::string early = "--set '" + control + "Final Time=0.5' --quiet --output ";
  ASSERT_EQ(run(early + "whole").status, 0);
  ASSERT_EQ(run(early + "two --set Output/Checkpoint/Interval=200 --set Output/Checkpoint/Keep=9", 2).status, 0);
  const Outcome one = run("--set '" + control + "Final Time=0.5' --output one --restart two/checkpoint-200.h5");
  ASSERT_EQ(one.status, 0) << one.output;
  EXPECT_NE(
      one.output.find("written on 2 rank(s), this run has 1.\nThe run resumes to solver tolerance, not bit for bit."),
      std::string::npos)
      << one.output;
  // Before the ball touches the wall: the last row's columns agree.
  std::istringstream mine(history_rows(path("one")).back()), theirs(history_rows(path("whole")).back());
  std::string a, b;
  int column = 0;
  for (; column < 16 && std::getline(mine, a, ',') && std::getline(theirs, b, ','); ++column)
    EXPECT_NEAR(std::stod(a), std::stod(b), 1e-7 * std::abs(std::stod(b)) + 1e-12) << "column " << column;
  ASSERT_EQ(column, 16) << "a row is too short";
  // Fields of two ranks are not gone on with by one.
  const Outcome same = run("--output two --restart two/checkpoint-200.h5");
  EXPECT_EQ(same.status, 2);
  EXPECT_NE(same.output.find("Choose another --output to start new files"), std::string::npos) << same.output;
}

TEST_F(RestartDriverTest, AnotherNumberOfRanksGoesOnWithOneHdf5File) {
  const std::string settings = "--quiet --set 'Output/Fields Format=HDF5' --output parts --set '" + control;
  ASSERT_EQ(run(settings + "Final Time=0.3'", 2).status, 0);
  const auto size = std::filesystem::file_size(path("parts/fields.e"));
  const Outcome rest = run(settings + "Final Time=0.5' --restart parts", 1);
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_GT(std::filesystem::file_size(path("parts/fields.e")), size);
  EXPECT_EQ(run(settings + "Final Time=0.6' --restart parts", 4).status, 0);
}

TEST_F(RestartDriverTest, BadRestartsAreRefusedWithoutATrace) {
  ASSERT_EQ(
      run("--output out --quiet --set '" + control + "Final Time=0.2' --set Output/Checkpoint/Interval=100").status, 0);
  const std::string before = contents(path("out/history.csv")), summary = contents(path("out/summary.json"));
  const auto refused = [&](const std::string& more, const std::string& message) {
    for (int ranks : {1, 2}) {
      const Outcome outcome = run("--output out " + more, ranks);
      EXPECT_EQ(outcome.status, 2) << outcome.output;
      EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
      EXPECT_EQ(outcome.output.find(message), outcome.output.rfind(message)) << "said by both ranks";
    }
    EXPECT_EQ(contents(path("out/history.csv")), before);
    EXPECT_EQ(contents(path("out/summary.json")), summary);
  };
  refused("--restart nowhere.h5", "nowhere.h5: cannot be read: No such file or directory");
  refused("--restart out/history.csv", "out/history.csv: is not a checkpoint of Ixos");
  refused("--restart ''", "a file is needed");
  std::filesystem::create_directories(path("none"));
  refused("--restart none", "none: the folder has no sound checkpoint");
  refused("--restart out/checkpoint.h5 --set 'Mesh/Disk/Diameter=11'", "belongs to another mesh than the scene's");
  refused("--restart out/checkpoint.h5 --set 'Mesh/Disk/Rings=3'", "Mesh/Disk/Rings: 2, now 3");
  refused("--restart out/checkpoint.h5 --set 'Initial Conditions/Velocity={1, 0}'",
          "Initial Conditions/Velocity: {}, now {1, 0}");
  std::filesystem::resize_file(path("out/checkpoint-200.h5"), 5000);
  refused("--restart out/checkpoint.h5", "an earlier checkpoint is sound: ");
  EXPECT_EQ(ixos({"--restart", "out/checkpoint.h5"}, folder_).status, 2) << "without a scene";
}

TEST_F(RestartDriverTest, CheckSaysWhetherARestartWouldGo) {
  ASSERT_EQ(run("--output out --quiet --set '" + control + "Final Time=0.1'").status, 0);
  const std::string before = contents(path("out/summary.json"));
  const Outcome outcome = run("--check --restart out/checkpoint.h5 --set 'Time Integrator/Type=Newmark'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("checkpoint-100.h5 is sound and fits the scene."), std::string::npos);
  EXPECT_NE(outcome.output.find("Changed: Time Integrator/Type: \"Average Vector Field\", now \"Newmark\"."),
            std::string::npos)
      << outcome.output;
  EXPECT_EQ(contents(path("out/summary.json")), before);
}

TEST_F(RestartDriverTest, EveryFailureIsExitStatusThreeWithACheckpointAndAReason) {
  const auto fails = [&](const std::string& more, const std::string& reason, const std::vector<int>& numbers = {1}) {
    for (const int ranks : numbers) {
      std::filesystem::remove_all(path("out"));
      const Outcome outcome = run("--quiet --output out " + more, ranks);
      EXPECT_EQ(outcome.status, 3) << more << ": " << outcome.output;
      const std::string summary = contents(path("out/summary.json"));
      EXPECT_NE(summary.find("\"status\": \"diverged\""), std::string::npos) << summary;
      EXPECT_NE(summary.find(reason), std::string::npos) << summary;
      EXPECT_TRUE(std::filesystem::exists(path("out/checkpoint.h5")));
      EXPECT_EQ(run("--check --output out --restart out/checkpoint.h5 " + more, ranks).status, 0);
    }
  };
  const std::string belos = "--set 'Linear Solver/Linear Solver Type=Belos' ";
  fails("--set 'Nonlinear Solver/Maximum Iterations=1'", "did not converge in 1 iterations");
  fails(belos +
            "--set 'Linear Solver/Preconditioner Type=None' --set "
            "'Linear Solver/Linear Solver Types/Belos/Solver Types/Pseudo Block CG/Maximum Iterations=1'",
        "Newton's iteration", {2});
  const std::string newmark = "--set 'Time Integrator/Type=Newmark' ";
  const std::string fast = "--set 'Initial Conditions/Velocity={0, -20000}' ";
  fails(newmark + fast, "Newton's iteration");
  fails("--set 'Time Integrator/Type=Central Difference' " + fast,
        "in an explicit step a gap closes, an element inverts");
  // With cuts allowed, each is tried.
  fails(newmark + fast + "--set '" + control + "Maximum Cuts=3'", "an element inverts", {1, 2});
  const std::string summary = contents(path("out/summary.json"));
  const auto rejected = summary.find("\"rejected_steps\": ") + 18;
  EXPECT_GT(std::stol(summary.substr(rejected)), 3) << summary;
}

TEST_F(RestartDriverTest, AnExpressionWithAPoleEndsTheRunWithReadableResults) {
  std::ofstream(path("pole.xml")) << R"xml(<ParameterList name="Pole">
    <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
    <ParameterList name="Materials"><ParameterList name="A"><Parameter name="Density" type="double" value="1"/></ParameterList></ParameterList>
    <ParameterList name="Histories"><ParameterList name="H"><Parameter name="Type" type="string" value="Expression"/>
      <ParameterList name="Expression"><Parameter name="Value" type="string" value="1e-9/(t-0.12345)^2"/></ParameterList></ParameterList></ParameterList>
    <ParameterList name="Boundary Conditions"><ParameterList name="L"><Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Side Set" type="string" value="right"/><Parameter name="Vector" type="Array(double)" value="{1, 0}"/>
      <Parameter name="History" type="string" value="H"/></ParameterList></ParameterList>
    <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
      <Parameter name="Final Time" type="double" value="1"/><Parameter name="Time Step" type="double" value="0.02469"/>
    </ParameterList></ParameterList></ParameterList>)xml";
  for (const char* scheme : {"Newmark", "Central Difference", "Average Vector Field"}) {
    const Outcome outcome =
        ixos({"pole.xml", "--output", "out", "--overwrite", "--set", std::string("Time Integrator/Type=") + scheme},
             folder_);
    EXPECT_EQ(outcome.status, 3) << scheme << outcome.output;
    EXPECT_NE(
        outcome.output.find("a prescribed motion, an obstacle's motion or a load is not a finite number between t = "
                            "0.09876 and 0.12345"),
        std::string::npos)
        << outcome.output;
    EXPECT_NE(contents(path("out/summary.json")).find("\"status\": \"diverged\""), std::string::npos) << scheme;
    EXPECT_EQ(history_rows(path("out")).size(), 1U + 5U) << scheme << ": the header, the start and four steps";
    const Outcome check = ixos({"pole.xml", "--set", std::string("Time Integrator/Type=") + scheme, "--output", "out",
                                "--check", "--restart", "out"},
                               folder_);
    EXPECT_EQ(check.status, 0) << scheme << check.output;
  }
}

}  // namespace
}  // namespace ixos::test

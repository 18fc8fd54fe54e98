// ixos SCENE --try: a few steps, which leave nothing behind.
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/driver_test.hpp"

namespace ixos::test {
namespace {

const std::string control = "Time Integrator/Time Step Control/";

class TrialTest : public DriverTest {
 protected:
  std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
};

TEST_F(TrialTest, SaysHowLongTheWholeRunWouldTakeAndLeavesNothing) {
  const Outcome told = ixos({ball, "--try"}, folder_);
  EXPECT_EQ(told.status, 0) << told.output;
  EXPECT_NE(told.output.find("20 steps to t = 0.02 T0 took "), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("At this rate the 10000 steps to t = 10 T0 take "), std::string::npos) << told.output;
  EXPECT_EQ(files(), 0U);
}

TEST_F(TrialTest, ARunOfAFewStepsIsTriedWhole) {
  const Outcome told = ixos({ball, "--try", "--set", control + "Final Time=0.003"}, folder_);
  EXPECT_EQ(told.status, 0) << told.output;
  EXPECT_NE(told.output.find("3 steps to t = 0.003 T0 took "), std::string::npos) << told.output;
  EXPECT_NE(told.output.find(": that is the whole run."), std::string::npos) << told.output;
}

TEST_F(TrialTest, TwoRanksAgreeOnTheEnd) {
  const Outcome told =
      shell("mpiexec -np 2 " + quoted_driver() + " " + ball + " --try --set '" + control + "Time Step=0.002'", folder_);
  EXPECT_EQ(told.status, 0) << told.output;
  EXPECT_NE(told.output.find("20 steps to t = 0.04 T0 took "), std::string::npos) << told.output;
  EXPECT_EQ(files(), 0U);
}

TEST_F(TrialTest, AFailedStepEndsItWithTheStatusOfTheRun) {
  const Outcome told = ixos({ball, "--try", "--set", "Nonlinear Solver/Maximum Iterations=1"}, folder_);
  EXPECT_EQ(told.status, 3) << told.output;
  EXPECT_NE(told.output.find("did not converge in 1 iterations"), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("shorter steps may help: --set '" + control + "Maximum Cuts=10'"), std::string::npos)
      << told.output;
  EXPECT_EQ(files(), 0U);
}

TEST_F(TrialTest, AFolderInItsPlaceIsLeftAlone) {
  const std::string mine = folder_ + "/ball.results.try";
  std::filesystem::create_directories(mine + "/mine");
  const Outcome told = ixos({ball, "--try"}, folder_);
  EXPECT_EQ(told.status, 2) << told.output;
  EXPECT_NE(told.output.find("--try: ball.results.try exists"), std::string::npos) << told.output;
  EXPECT_TRUE(std::filesystem::exists(mine + "/mine"));
}

TEST_F(TrialTest, GoesWithNoOtherTask) {
  for (const char* other : {"--check", "--explain", "--accuracy=1%", "--restart=x", "--write-mesh=x.e"})
    EXPECT_EQ(ixos({ball, "--try", other}, folder_).status, 2) << other;
}

}  // namespace
}  // namespace ixos::test

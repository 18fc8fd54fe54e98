// A program that runs beside this one. tests/drivers/study_test.cpp has its limits and failures.
#include "io/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

class ChildProcessTest : public testing::Test {
 protected:
  ChildProcess shell(const std::string& script) const { return {{"/bin/sh", "-c", script}, folder_.path() + "/log"}; }
  ChildOutcome outcome(ChildProcess& child) const {
    ChildOutcome found;
    while (!child.ended(found)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return found;
  }
  /// Waits until a condition holds, at most a minute.
  static bool comes(const std::function<bool()>& condition) {
    for (int i = 0; i < 12000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return condition();
  }
  test::TemporaryFolder folder_;
};

TEST_F(ChildProcessTest, TellsHowItEnded) {
  ChildProcess child = shell("echo first; echo second; exit 3");
  EXPECT_EQ(outcome(child).exit_status, 3);
  EXPECT_EQ(last_line(folder_.path() + "/log"), "second");
  EXPECT_EQ(child.processor_seconds(), 0);
}

TEST_F(ChildProcessTest, ProcessorTimeGrowsWithWorkOnly) {
  ChildProcess busy = shell("while :; do :; done");
  EXPECT_TRUE(comes([&] { return busy.processor_seconds() > 0.1; }));
  const double seen = busy.processor_seconds();
  EXPECT_LE(seen, busy.age() + 0.02) << "one processor";
  busy.send(SIGKILL);
  const ChildOutcome ended = outcome(busy);
  EXPECT_EQ(ended.exit_status, 128 + SIGKILL);
  EXPECT_GE(ended.cpu_seconds, seen - 0.02);

  ChildProcess idle = shell("exec sleep 60");
  EXPECT_TRUE(comes([&] { return idle.age() > 0.5; }));
  EXPECT_LT(idle.processor_seconds(), 0.3);
  idle.send(SIGKILL);
  outcome(idle);
}

}  // namespace
}  // namespace ixos

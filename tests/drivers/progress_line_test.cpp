#include "ixos/progress_line.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

Progress after_step(double seconds) { return {2.5, 10, 50, 150, seconds, 3 * seconds, 0.05, false, {}}; }

/// What a line shows of such progresses.
std::string shown(ProgressLine& line, const std::vector<Progress>& all) {
  testing::internal::CaptureStderr();
  for (const Progress& progress : all) line.show(progress);
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressLineTest, AStepAndAnIterateHaveTheirWords) {
  EXPECT_EQ(in_words(after_step(40)), "t = 2.5 of 10 T0, step 50, 3.00 Newton iterations a step, 2 min 00 s left");
  Progress within = after_step(40);
  within.within_step = true;
  within.newton = {7, 2.5e-3, 1e-9};
  EXPECT_EQ(in_words(within),
            "t = 2.5 of 10 T0, step 50; the next one, 0.05 T0: Newton iteration 7, residual 2.5e-03 of 1.0e-09, 2 min "
            "00 s left");
  EXPECT_EQ(in_words({0, 10, 0, 0, 1, 0, 0.05, false, {}}), "t = 0 of 10 T0, step 0");
}

TEST(ProgressLineTest, APipeGetsALineAMinute) {
  ProgressLine line(false);
  EXPECT_EQ(shown(line, {after_step(1), after_step(30), after_step(60.5)}), "");
  EXPECT_EQ(shown(line, {after_step(61.5), after_step(100)}), in_words(after_step(61.5)) + "\n");
  EXPECT_EQ(shown(line, {after_step(122)}), in_words(after_step(122)) + "\n");
  testing::internal::CaptureStderr();
  line.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressLineTest, ATerminalHasOneLineThatChanges) {
  ProgressLine line(true);
  EXPECT_EQ(shown(line, {after_step(1), after_step(1.1), after_step(1.25), after_step(1.3)}),
            "\r\033[K" + in_words(after_step(1.25)));
  testing::internal::CaptureStderr();
  line.clear();
  line.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "\r\033[K");
}

}  // namespace
}  // namespace ixos

#include "study/common/axes.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace ixos {
namespace {

Axis axis(const std::string& name, const std::vector<std::string>& labels) {
  Axis result{name, {}};
  for (const std::string& label : labels) result.values.push_back({label, {name + "=" + label}});
  return result;
}

TEST(AxesTest, TheLastAxisRunsFastest) {
  const std::vector<StudyRun> runs = combinations({axis("A", {"1", "2"}), axis("B", {"x y", "z"})}, {"C=0"});
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[1].name, "1_z");
  EXPECT_EQ(runs[2].name, "2_x-y");
  EXPECT_EQ(runs[2].labels, (std::vector<std::string>{"2", "x y"}));
  EXPECT_EQ(runs[2].settings, (Assignments{"C=0", "A=2", "B=x y"}));
}

TEST(AxesTest, RunsHaveFoldersOfTheirOwn) {
  const auto refusal = [](const std::vector<Axis>& axes, const std::vector<std::string>& reserved = {}) {
    return test::refusal([&] { combinations(axes, {}, reserved); });
  };
  test::expect_contains(refusal({axis("A", {"x y", "x/y"})}), "which another run has");
  test::expect_contains(refusal({axis("A", {"mine"})}, {"mine"}), "which is reserved");
  test::expect_contains(refusal({axis("A", {std::string(300, 'x')})}), "which is too long");
  EXPECT_EQ(refusal({axis("A", {"mine"})}), "");
}

TEST(AxesTest, TooManyRunsAreRefused) {
  std::vector<std::string> labels;
  for (int i = 0; i < 101; ++i) labels.push_back(std::to_string(i));
  test::expect_contains(test::refusal([&] {
                          combinations({axis("A", labels), axis("B", labels)}, {});
                        }),
                        "more than 10000 runs");
}

}  // namespace
}  // namespace ixos

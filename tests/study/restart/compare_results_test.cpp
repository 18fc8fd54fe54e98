// Differences between the results of two runs.
#include "study/restart/compare_results.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace ixos {
namespace {

const char* const history = "step,total_energy,wall_seconds\n0,0.5,0\n1,0.25,0.1\n2,-0,0.2\n";
const char* const summary = R"({"status": "completed", "steps": 2, "restarts": 0, "seconds": {"solve": 1}})";

class CompareResultsTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& run : {one_, other_}) {
      std::filesystem::create_directories(run);
      write(run + "/history.csv", history);
      write(run + "/summary.json", summary);
      write(run + "/fields.e", std::string(200'000, 'x'));
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  static void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
  std::string difference() const { return results_difference(one_, other_); }

  std::string folder_ = testing::TempDir() + "compare_results";
  std::string one_ = folder_ + "/one", other_ = folder_ + "/other";
};

TEST_F(CompareResultsTest, ClocksMemoryAndTheNumberOfRestartsMayDiffer) {
  EXPECT_EQ(difference(), "");
  write(other_ + "/history.csv", "step,total_energy,wall_seconds\n0,0.5,0\n1,0.25,9\n2,-0,10\n");
  write(other_ + "/summary.json",
        R"({"status": "completed", "steps": 2, "restarts": 3, "seconds": {"solve": 2}, "peak_memory_bytes": 1})");
  EXPECT_EQ(difference(), "");
}

TEST_F(CompareResultsTest, NamesTheFirstDifferenceOfAHistory) {
  const auto after = [&](const std::string& text, long last = 100) {
    write(other_ + "/history.csv", text);
    return history_difference(one_ + "/history.csv", other_ + "/history.csv", last);
  };
  const std::string start = "step,total_energy,wall_seconds\n0,0.5,0\n1,0.25,0.1\n";
  EXPECT_EQ(after(start + "2,0,0.2\n"), "step 2, column total_energy: -0 and 0") << "a sign bit is a bit";
  EXPECT_EQ(after(start + "2,0,0.2\n", 1), "") << "later rows do not count";
  EXPECT_EQ(after(start), "no row after the row of step 1");
  EXPECT_EQ(after(start, 1), "");
  EXPECT_EQ(after(start + "2,-0,0.2\n3,1,1\n"), "further rows after the row of step 2");
  EXPECT_EQ(after(start + "2,-0\n"), "step 2: other cells") << "a row that was cut off";
  EXPECT_EQ(after("step,energy,wall_seconds\n"), "the columns have other names");
  EXPECT_THROW(after("time\n"), FileError);
  EXPECT_THROW(after(""), FileError);
  EXPECT_THROW(history_difference(one_ + "/history.csv", other_ + "/none.csv"), FileError);
}

TEST_F(CompareResultsTest, NamesTheFirstDifferenceOfASummary) {
  const auto after = [&](const std::string& text) {
    write(other_ + "/summary.json", text);
    return difference();
  };
  EXPECT_EQ(after(R"({"status": "completed", "steps": 3})"), "summary.json: steps: 2 and 3");
  EXPECT_EQ(after(R"({"steps": 2})"), "summary.json: status is missing");
  EXPECT_EQ(after(R"({"status": "completed", "steps": 2, "warnings": [1]})"), "summary.json: warnings is new");
  EXPECT_EQ(after(R"({"status": "completed", "steps": 2, "dofs": 1})"), "summary.json: dofs is new");
  EXPECT_THROW(after("no object"), FileError);
}

TEST_F(CompareResultsTest, ComparesEveryByteOfTheFields) {
  std::string text(200'000, 'x');
  text[150'000] = 'y';
  write(other_ + "/fields.e", text);
  EXPECT_EQ(difference(), "fields.e: byte 150000 differs");
  write(other_ + "/fields.e", "x");
  EXPECT_EQ(difference(), "fields.e: 200000 bytes and 1 bytes");
  std::filesystem::rename(other_ + "/fields.e", other_ + "/fields.e.2.0");
  EXPECT_EQ(difference(), "fields.e: there are other files");
}

}  // namespace
}  // namespace ixos

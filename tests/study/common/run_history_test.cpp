// Rows of a run and their times.
#include "study/common/run_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_results.hpp"

namespace ixos {
namespace {

TEST(RunHistoryTest, TimesOfReactions) {
  const test::TemporaryFolder folder;
  const std::vector<test::WrittenColumn> columns{{"reaction_top_y", [](double t) { return t; }}};
  test::write_results(folder.path(), "Newmark", 0.5, 1, columns, 0.125);
  const RunHistory newmark(folder.path());
  EXPECT_EQ(newmark.times("reaction_top_y"), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(newmark.energy_error(), 0.125);
  test::write_results(folder.path(), "Average Vector Field", 0.5, 1, columns);
  const RunHistory means(folder.path());
  EXPECT_EQ(means.times("reaction_top_y"), (std::vector<double>{0, 0.25, 0.75})) << "means of the steps";
  EXPECT_EQ(means.times("time"), (std::vector<double>{0, 0.5, 1}));
}

TEST(RunHistoryTest, ResultsThatCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(RunHistory(folder.path()), FileError);
  test::write_results(folder.path(), "Newmark", 0.5, 1, {});
  std::ofstream(folder.path() + "/summary.json") << "{\"max_energy_error\": null}";
  EXPECT_TRUE(std::isnan(RunHistory(folder.path()).energy_error()));
  std::ofstream(folder.path() + "/summary.json") << "[";
  EXPECT_THROW(RunHistory(folder.path()).energy_error(), FileError);
  test::write_results(folder.path(), "Oldmark", 0.5, 1, {});
  EXPECT_THROW(RunHistory(folder.path()), InputError);
}

}  // namespace
}  // namespace ixos

#include "io/history_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace ixos {
namespace {

TEST(HistoryFileTest, NumbersReadBackExactlyAndEmptyCellsStayEmpty) {
  const std::string path = testing::TempDir() + "history.csv";
  const double values[] = {1.0 / 3, -1e-300, 6.02214076e23, 0.1 + 0.2};
  {
    HistoryFile file(path, {"a", "b", "c", "d", "e"});
    file.write({values[0], values[1], std::nan(""), values[2], values[3]});
  }
  std::ifstream stream(path);
  std::string header, row;
  std::getline(stream, header);
  std::getline(stream, row);
  EXPECT_EQ(header, "a,b,c,d,e");
  std::vector<std::string> cells;
  std::istringstream line(row);
  for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
  ASSERT_EQ(cells.size(), 5U);
  EXPECT_EQ(std::stod(cells[0]), values[0]);
  EXPECT_EQ(std::stod(cells[1]), values[1]);
  EXPECT_EQ(cells[2], "");
  EXPECT_EQ(std::stod(cells[3]), values[2]);
  EXPECT_EQ(std::stod(cells[4]), values[3]);
}

TEST(HistoryFileTest, OnlyATableThatHadThatLengthIsGoneOnWith) {
  const std::string path = testing::TempDir() + "verify.csv";
  const auto fits = [&](const std::string& contents, const TableLength& length) {
    std::ofstream(path) << contents;
    try {
      HistoryFile::verify(path, {"time", "gap"}, "released_energy", length);
    } catch (const InputError&) {
      return false;
    }
    return true;
  };
  EXPECT_TRUE(fits("time,gap\n0,1\n", {1, 13}));
  EXPECT_TRUE(fits("time,gap\n0,1\n1,2\n", {1, 13})) << "later rows are dropped";
  EXPECT_FALSE(fits("time,gap\n0,1", {1, 13})) << "a row that does not end";
  EXPECT_FALSE(fits("time,gap", {0, 9})) << "a header that does not end";
  EXPECT_FALSE(fits("time,gap\n0,12\n", {1, 13}));
  EXPECT_FALSE(fits("time\n", {0, 5}));
  EXPECT_TRUE(fits("time,released_energy,gap\n", {0, 25})) << "a column that may be there";
  EXPECT_FALSE(fits("time,gap,other\n", {0, 15}));
  std::filesystem::remove(path);
}

TEST(HistoryFileTest, AFileThatCannotBeMadeIsAFileError) {
  EXPECT_THROW(HistoryFile("/dev/null/history.csv", {"a"}), FileError);
}

TEST(HistoryFileTest, AFullDiskIsAFileError) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(
      {
        HistoryFile file("/dev/full", {"a"});
        file.write({1.0});
        file.flush();
      },
      FileError);
}

}  // namespace
}  // namespace ixos

/// Reading results in tests.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ixos::test {

/// What a file holds; nothing where it is not there.
inline std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The rows of a folder's history.csv, the header too, without their wall-clock seconds. Fails the test where there are
/// none.
inline std::vector<std::string> history_rows(const std::string& folder) {
  EXPECT_TRUE(std::ifstream(folder + "/history.csv").good()) << folder << " has no history.csv";
  std::istringstream file(contents(folder + "/history.csv"));
  std::vector<std::string> rows;
  std::ptrdiff_t clock = 0;
  for (std::string line, cell; std::getline(file, line);) {
    std::vector<std::string> cells;
    for (std::istringstream row(line); std::getline(row, cell, ',');) cells.push_back(cell);
    if (rows.empty()) clock = std::find(cells.begin(), cells.end(), "wall_seconds") - cells.begin();
    cells.erase(cells.begin() + clock);
    std::string& kept = rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) kept += (c > 0 ? "," : "") + cells[c];
  }
  return rows;
}

}  // namespace ixos::test

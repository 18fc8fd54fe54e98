/// Cells of tables with commas.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace ixos {

/// Returns the cell as a line of a table has it: in quotes if it has a comma, a quote or the end of a line.
inline std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

/// Returns a number as a cell, to its last digit; an empty one if it is not finite.
inline std::string csv_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

}  // namespace ixos

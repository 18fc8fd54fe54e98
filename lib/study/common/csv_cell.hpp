/// Cells of tables with commas.
#pragma once
#include <string>

namespace ixos {

/// Returns the cell as a line of a table has it: in quotes if it has a comma, a quote or the end of a line.
inline std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace ixos

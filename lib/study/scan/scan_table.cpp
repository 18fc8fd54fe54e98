#include "study/scan/scan_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/disk_file.hpp"
#include "study/common/csv_cell.hpp"

namespace ixos {
namespace {

using Cells = std::vector<std::string>;

std::string line_of(const Cells& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  return line + "\n";
}

std::string csv(const Scan& scan, const std::vector<ScanRow>& rows) {
  Cells head{"run"};
  for (const VariedParameter& varied : scan.varied) head.push_back(varied.name);
  for (const AskedQuantity& quantity : scan.quantities) head.push_back(quantity.text());
  for (const char* name : {"status", "reason", "wall_seconds", "steps", "newton_iterations", "peak_memory_bytes"})
    head.emplace_back(name);
  std::string text = line_of(head);
  for (const ScanRow& row : rows) {
    Cells cells{row.run.name};
    cells.insert(cells.end(), row.run.labels.begin(), row.run.labels.end());
    for (const double value : row.values) cells.push_back(csv_number(value));
    for (const std::string& word : {row.status, row.reason, csv_number(row.wall_seconds), std::to_string(row.steps),
                                    std::to_string(row.newton_iterations), csv_number(row.peak_memory_bytes)})
      cells.push_back(word);
    text += line_of(cells);
  }
  return text;
}

/// Returns whether the run reached its end and has all its values.
bool is_whole(const ScanRow& row) {
  return row.reached_its_end() &&
         std::none_of(row.values.begin(), row.values.end(), [](double v) { return std::isnan(v); });
}

}  // namespace

void write_scan(const Scan& scan, const std::vector<ScanRow>& rows, const ScanOptions& options) {
  nlohmann::ordered_json json;
  json["scene"] = scan.scene;
  json["command"] = options.command;
  json["version"] = options.version;
  json["common"] = scan.common;
  json["varied"] = nlohmann::ordered_json::array();
  for (const VariedParameter& varied : scan.varied) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const AxisValue& value : varied.values) values.push_back(value.label);
    json["varied"].push_back({{"name", varied.name},
                              {"parameter", varied.path},
                              {"unit", varied.unit},
                              {"logarithmic", varied.logarithmic},
                              {"values", values}});
  }
  json["quantities"] = nlohmann::ordered_json::array();
  json["unit_columns"] = nlohmann::ordered_json::array();  // by quantity the column that has its unit
  for (const AskedQuantity& quantity : scan.quantities) {
    json["quantities"].push_back(quantity.text());
    json["unit_columns"].push_back(quantity.column_of_unit());
  }
  write_whole_file(options.folder + "/scan.csv", csv(scan, rows));
  write_whole_file(options.folder + "/scan.json",
                   json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::string scan_text(const Scan& scan, const std::vector<ScanRow>& rows) {
  std::vector<Cells> table(1);
  for (const VariedParameter& varied : scan.varied) table[0].push_back(varied.name);
  for (const AskedQuantity& quantity : scan.quantities) table[0].push_back(quantity.text());
  for (const ScanRow& row : rows) {
    table.push_back(row.run.labels);
    for (const double value : row.values)
      table.back().push_back(std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string("-"));
  }
  std::string text;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t column = 0; column < table[i].size(); ++column) {
      std::size_t width = 0;
      for (const Cells& cells : table) width = std::max(width, cells[column].size());
      text += fmt::format("{}{:>{}}", column == 0 ? "" : "  ", table[i][column], width);
    }
    if (i > 0 && !is_whole(rows[i - 1])) text += fmt::format("  {}: {}", rows[i - 1].status, rows[i - 1].reason);
    text += "\n";
  }
  return text;
}

}  // namespace ixos

#include "study/common/history_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/history_file.hpp"
#include "study/common/tuning.hpp"

namespace ixos {

HistoryTable::HistoryTable(const std::string& path) : path_(path) {
  std::ifstream file = open_text(path);
  std::string line;
  if (!std::getline(file, line)) throw FileError(path + ": cannot be read, or is empty");
  names_ = csv_cells(line);
  for (const std::string& name : names_) columns_[name];
  if (columns_.size() != names_.size()) throw FileError(path + ": two columns have one name");
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> row = csv_cells(line);
    if (row.size() != names_.size())
      throw FileError(fmt::format("{}, line {}: {} cells, not {}", path, number, row.size(), names_.size()));
    for (std::size_t c = 0; c < row.size(); ++c) {
      char* end = nullptr;
      const double value =
          row[c].empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(row[c].c_str(), &end);
      if (!row[c].empty() && end != row[c].c_str() + row[c].size())
        throw FileError(fmt::format("{}, line {}: \"{}\" is not a number", path, number, row[c]));
      columns_[names_[c]].push_back(value);
    }
    ++rows_;
  }
  if (rows_ == 0) throw FileError(path + ": has no rows");
}

const std::vector<double>& HistoryTable::column(const std::string& name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) throw InputError(path_ + ": " + no_such("column", name, names_, "There are"));
  return found->second;
}

double interpolated(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  if (times.empty()) return nothing;
  const double slack = tuning::same_time * (times.back() - times.front());
  if (time < times.front() - slack || time > times.back() + slack) return nothing;
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return values.front();
  const auto i = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end() || times[i] == time) return values[i];
  const double weight = (time - times[i]) / (times[i + 1] - times[i]);
  return (1 - weight) * values[i] + weight * values[i + 1];
}

}  // namespace ixos

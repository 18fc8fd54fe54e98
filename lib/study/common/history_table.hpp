/// history.csv, read back.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace ixos {

/// Columns by name, an empty cell as NaN.
class HistoryTable {
 public:
  /// Throws FileError if the file cannot be read or is not a table of numbers, with the line.
  explicit HistoryTable(const std::string& path);

  std::size_t rows() const { return rows_; }
  bool has(const std::string& name) const { return columns_.count(name) > 0; }
  /// Returns a column. Throws InputError, with the nearest name, if no column has that name.
  const std::vector<double>& column(const std::string& name) const;
  /// Returns the names in the file's order.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

/// Returns the value at `time` of a function given at increasing times, by linear interpolation; NaN outside.
double interpolated(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace ixos

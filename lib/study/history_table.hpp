/// history.csv, read back.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace ixos {

/// Columns by name, an empty cell as NaN.
class HistoryTable {
 public:
  /// Throws FileError where the file cannot be read or is no table of numbers, with the line.
  explicit HistoryTable(const std::string& path);

  std::size_t rows() const { return rows_; }
  bool has(const std::string& name) const { return columns_.count(name) > 0; }
  /// Throws InputError, with the nearest name, where there is none.
  const std::vector<double>& column(const std::string& name) const;
  /// In the file's order.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

/// The value at `time` of a function given at increasing times, by straight lines; NaN outside.
double interpolated(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace ixos

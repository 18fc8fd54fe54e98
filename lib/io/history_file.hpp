/// Tables of numbers over time, as comma-separated values.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace ixos {

/// A CSV file with a header line. Numbers have 17 digits, so that they read back exactly; NaN makes an empty cell.
/// Rows reach the disk with the first row that comes a second or
/// more after the last flush, and when the file is closed. Writes on the rank
/// that opened it.
class HistoryFile {
 public:
  /// Throws FileError where the file cannot be made.
  HistoryFile(const std::string& path, const std::vector<std::string>& columns);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// One row, as many values as columns. Throws FileError where the disk refuses it.
  void write(const std::vector<double>& values);
  void flush();

 private:
  std::string path_;
  std::FILE* file_;
  double last_flush_ = 0;
  std::string buffer_;
};

}  // namespace ixos

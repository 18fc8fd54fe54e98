/// Tables of numbers over time, as comma-separated values.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/disk_file.hpp"

namespace ixos {

/// The length of a table: its rows after the header, and its bytes.
struct TableLength {
  std::uint64_t rows = 0;
  std::uint64_t bytes = 0;
};

/// A CSV file with a header line. Numbers have 17 digits, so that they read back exactly; NaN makes an empty cell.
/// Rows reach the file with the first row that comes a second or more after the last flush, and when it is closed.
/// Writes on the rank that opened it.
class HistoryFile {
 public:
  /// Throws FileError if the file cannot be made.
  HistoryFile(const std::string& path, const std::vector<std::string>& columns);
  /// Continues the file that verify() accepted; drops what it holds beyond `length`.
  HistoryFile(const std::string& path, const TableLength& length);
  /// Returns the header of the existing file: those columns, but for `optional`, which it may have or lack. Throws
  /// InputError if it has others, or never had that length.
  static std::string verify(const std::string& path, const std::vector<std::string>& columns,
                            const std::string& optional, const TableLength& length);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Writes one row, as many values as columns. Throws FileError if the disk refuses it.
  void write(const std::vector<double>& values);
  void flush();
  /// Flushes, and makes the disk keep the rows. Throws FileError.
  void sync();
  /// Syncs and closes the file; nothing can be written any more. Throws FileError.
  void close();
  const TableLength& length() const { return length_; }  ///< with what is not flushed yet

 private:
  DiskFile file_;
  double last_flush_;
  std::string buffer_;
  TableLength length_;
};

/// Returns the cells of a line of a table whose cells have no quotes and no commas.
std::vector<std::string> csv_cells(const std::string& line);

/// Returns whether columns are the same, but for one that either may have or lack.
bool are_alike(std::vector<std::string> columns, std::vector<std::string> others, const std::string& optional);

/// Throws InputError, with the list path, for a name that cannot head a column of comma-separated values.
void check_column_name(const std::string& path, const std::string& name);

}  // namespace ixos

#include "io/history_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "base/error.hpp"

namespace ixos {
namespace {

/// The file at `path`, its first bytes only.
std::string shortened(const std::string& path, std::uint64_t bytes) {
  std::error_code code;
  std::filesystem::resize_file(path, bytes, code);
  if (code) throw FileError(path + ": cannot be written: " + code.message());
  return path;
}

}  // namespace

std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> result;
  std::size_t start = 0;
  for (auto comma = line.find(','); comma != std::string::npos; comma = line.find(',', start)) {
    result.push_back(line.substr(start, comma - start));
    start = comma + 1;
  }
  result.push_back(line.substr(start));
  return result;
}

bool are_alike(std::vector<std::string> columns, std::vector<std::string> others, const std::string& optional) {
  for (std::vector<std::string>* names : {&columns, &others})
    names->erase(std::remove(names->begin(), names->end(), optional), names->end());
  return columns == others;
}

HistoryFile::HistoryFile(const std::string& path, const std::vector<std::string>& columns)
    : file_(path, DiskFile::Mode::Create), last_flush_(Teuchos::Time::wallTime()) {
  buffer_ = fmt::format("{}\n", fmt::join(columns, ","));
  length_.bytes = buffer_.size();
  flush();
}

HistoryFile::HistoryFile(const std::string& path, const TableLength& length)
    : file_(shortened(path, length.bytes), DiskFile::Mode::Change),
      last_flush_(Teuchos::Time::wallTime()),
      length_(length) {}

std::string HistoryFile::verify(const std::string& path, const std::vector<std::string>& columns,
                                const std::string& optional, const TableLength& length) {
  std::ifstream file = open_text(path);
  std::string line;
  if (!file.is_open() || !std::getline(file, line) || file.eof())  // a line that does not end is none
    throw InputError(path + ": cannot resume: the table is missing. Choose another --output to start a new one");
  std::string header = line;
  if (!are_alike(csv_cells(header), columns, optional))
    throw InputError(path +
                     ": cannot resume: the table has other columns than this run writes. Choose another --output");
  TableLength found{0, line.size() + 1};
  while (found.rows < length.rows && std::getline(file, line) && !file.eof()) {
    ++found.rows;
    found.bytes += line.size() + 1;
  }
  if (found.rows != length.rows || found.bytes != length.bytes)
    throw InputError(
        fmt::format("{}: cannot resume: its first {} rows have {} bytes, and had {} when the checkpoint was written. "
                    "Choose another --output to start a new table",
                    path, found.rows, found.bytes, length.bytes));
  return header;
}

HistoryFile::~HistoryFile() {
  if (buffer_.empty()) return;
  try {
    flush();
  } catch (const std::exception&) {  // whoever wants to know has closed it before
  }
}

void HistoryFile::write(const std::vector<double>& values) {
  const std::size_t before = buffer_.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) buffer_ += ',';
    const double value = values[i];
    if (std::isnan(value)) continue;
    if (value == std::floor(value) && std::abs(value) < 1e15)
      fmt::format_to(std::back_inserter(buffer_), "{}", static_cast<long long>(value));
    else
      fmt::format_to(std::back_inserter(buffer_), "{:.17g}", value);
  }
  buffer_ += '\n';
  ++length_.rows;
  length_.bytes += buffer_.size() - before;
  if (buffer_.size() > 1 << 20 || Teuchos::Time::wallTime() - last_flush_ > 1) flush();
}

void HistoryFile::flush() {
  last_flush_ = Teuchos::Time::wallTime();
  // After a failure the next attempt writes again from the same position. Once the disk has room, no row is torn or
  // lost.
  file_.write_at(length_.bytes - buffer_.size(), buffer_.data(), buffer_.size());
  buffer_.clear();
}

void HistoryFile::sync() {
  flush();
  file_.sync();
}

void HistoryFile::close() {
  sync();
  file_.close();
}

void check_column_name(const std::string& path, const std::string& name) {
  if (name.find_first_of(",\"\r\n") != std::string::npos)
    throw InputError(
        fmt::format("{}: \"{}\" cannot name a column: it contains a comma, a quote or a line break", path, name));
}

}  // namespace ixos

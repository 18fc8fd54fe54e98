#include "io/history_file.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <Teuchos_Time.hpp>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace ixos {
namespace {

[[noreturn]] void fail(const std::string& path) {
  throw FileError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
}

std::FILE* open(const std::string& path, const char* mode) {
  std::FILE* file = std::fopen(path.c_str(), mode);
  if (file == nullptr) fail(path);
  return file;
}

}  // namespace

HistoryFile::HistoryFile(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), file_(open(path, "w")), last_flush_(Teuchos::Time::wallTime()) {
  buffer_ = fmt::format("{}\n", fmt::join(columns, ","));
  length_.bytes = buffer_.size();
  flush();
}

HistoryFile::HistoryFile(const std::string& path, const std::vector<std::string>& columns, const TableLength& length)
    : path_(path), file_(nullptr), last_flush_(Teuchos::Time::wallTime()), length_(length) {
  verify(path, columns, length);
  std::error_code code;
  std::filesystem::resize_file(path, length.bytes, code);
  if (code) throw FileError(path + ": cannot be written: " + code.message());
  file_ = open(path, "a");
}

void HistoryFile::verify(const std::string& path, const std::vector<std::string>& columns, const TableLength& length) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line))
    throw InputError(path + ": the table to go on with is not there; another --output begins a new one");
  if (line != fmt::format("{}", fmt::join(columns, ",")))
    throw InputError(path + ": the table has other columns than this run would write; give another --output");
  TableLength found{0, line.size() + 1};
  while (found.rows < length.rows && std::getline(file, line) && !file.eof()) {
    ++found.rows;
    found.bytes += line.size() + 1;
  }
  if (found.rows != length.rows || found.bytes != length.bytes)
    throw InputError(
        fmt::format("{}: is not the table to go on with: its first {} rows have {} bytes, not {}; another --output "
                    "begins a new one",
                    path, found.rows, found.bytes, length.bytes));
}

HistoryFile::~HistoryFile() {
  std::fwrite(buffer_.data(), 1, buffer_.size(), file_);
  std::fclose(file_);
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
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_) == buffer_.size();
  buffer_.clear();
  last_flush_ = Teuchos::Time::wallTime();
  if (!written || std::fflush(file_) != 0) fail(path_);
}

void HistoryFile::sync() {
  flush();
  if (fsync(fileno(file_)) != 0) fail(path_);
}

}  // namespace ixos

#include "io/history_file.hpp"

#include <fmt/format.h>

#include <Teuchos_Time.hpp>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>

#include "base/error.hpp"

namespace ixos {

HistoryFile::HistoryFile(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), file_(std::fopen(path.c_str(), "w")), last_flush_(Teuchos::Time::wallTime()) {
  if (file_ == nullptr) throw FileError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  for (std::size_t i = 0; i < columns.size(); ++i) buffer_ += (i == 0 ? "" : ",") + columns[i];
  buffer_ += '\n';
  flush();
}

HistoryFile::~HistoryFile() {
  std::fwrite(buffer_.data(), 1, buffer_.size(), file_);
  std::fclose(file_);
}

void HistoryFile::write(const std::vector<double>& values) {
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
  if (buffer_.size() > 1 << 20 || Teuchos::Time::wallTime() - last_flush_ > 1) flush();
}

void HistoryFile::flush() {
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_) == buffer_.size();
  buffer_.clear();
  last_flush_ = Teuchos::Time::wallTime();
  if (!written || std::fflush(file_) != 0)
    throw FileError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

}  // namespace ixos

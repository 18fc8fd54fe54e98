#include "io/msh_source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

constexpr const char* blanks = " \t\r\n";

std::string contents(const std::string& path) {
  if (!is_file(path)) throw InputError(path + ": the mesh file cannot be read");
  return read_whole_file(path);
}

std::string shortened(std::string_view word) {
  constexpr std::size_t longest = 40;
  return std::string(word.substr(0, longest)) + (word.size() > longest ? "..." : "");
}

/// Returns the word without a plus sign before its first digit or its point, which std::from_chars does not know.
std::string_view without_plus(std::string_view word) {
  constexpr const char* begins = "0123456789.";
  if (word.size() > 1 && word[0] == '+' && std::strchr(begins, word[1]) != nullptr) word.remove_prefix(1);
  return word;
}

}  // namespace

MshSource::MshSource(const std::string& path) : MshSource(path, contents(path)) {}

MshSource::MshSource(std::string path, std::string bytes) : path_(std::move(path)), bytes_(std::move(bytes)) {
  const std::string mark = "\xef\xbb\xbf";
  if (bytes_.rfind(mark, 0) == 0) place_ = mark.size();
}

void MshSource::refuse_whole(const std::string& why) const { throw InputError(path_ + ": " + printable(why)); }

void MshSource::refuse_here(const std::string& why) const {
  if (binary_) refuse_whole(fmt::format("byte {}: {}", before_, why));
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(before_);
  refuse_whole(fmt::format("line {}: {}", 1 + std::count(bytes_.begin(), end, '\n'), why));
}

void MshSource::refuse_end() const { refuse_whole("ends inside $" + section_ + ": the file is truncated"); }

void MshSource::skip_blanks() { before_ = place_ = std::min(bytes_.find_first_not_of(blanks, place_), bytes_.size()); }

std::string MshSource::next_section() {
  skip_blanks();
  if (place_ == bytes_.size()) return "";
  const std::string name(line());
  if (name.size() < 2 || name[0] != '$') refuse("\"{}\" stands where a section has to begin", shortened(name));
  return section_ = name.substr(1);
}

void MshSource::end_section() {
  const std::string_view end = word("the end of the section");
  if (end.substr(0, 4) != "$End" || end.substr(4) != section_)
    refuse("\"{}\" stands where $End{} has to", shortened(end), section_);
}

void MshSource::skip_section() {
  const std::string end = "$End" + section_;
  for (std::size_t found = bytes_.find(end, place_); found != std::string::npos; found = bytes_.find(end, found + 1)) {
    place_ = found;
    if (line() == end) return;
  }
  refuse_end();
}

std::string_view MshSource::line() {
  before_ = place_;
  const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
  std::string_view text(bytes_.data() + place_, end - place_);
  place_ = std::min(end + 1, bytes_.size());
  text.remove_suffix(text.size() - std::min(text.find_last_not_of(blanks) + 1, text.size()));
  return text;
}

std::string_view MshSource::word(const char* what) {
  skip_blanks();
  if (place_ == bytes_.size())
    refuse_whole(fmt::format("ends inside ${}, before {}: the file is truncated", section_, what));
  const std::size_t end = std::min(bytes_.find_first_of(blanks, place_), bytes_.size());
  const std::string_view text(bytes_.data() + place_, end - place_);
  place_ = end;
  return text;
}

template <class T>
T MshSource::raw() {
  before_ = place_;
  if (bytes_.size() - place_ < sizeof(T)) refuse_end();
  T value;
  std::memcpy(&value, bytes_.data() + place_, sizeof(T));
  place_ += sizeof(T);
  return value;
}

template <class T>
T MshSource::parsed(const char* what, const char* kind) {
  const std::string_view whole = word(what), text = without_plus(whole);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse("{} is \"{}\"; {} is allowed", what, shortened(whole), kind);
  return value;
}

std::int64_t MshSource::integer(const char* what) {
  return binary_ ? raw<std::int32_t>() : parsed<std::int32_t>(what, "an integer of 32 bits");
}

std::uint64_t MshSource::size(const char* what) {
  return binary_ ? raw<std::uint64_t>() : parsed<std::uint64_t>(what, "an integer from 0");
}

double MshSource::number(const char* what) {
  const double value = binary_ ? raw<double>() : parsed<double>(what, "a number");
  if (!std::isfinite(value)) refuse("{} is {}; a finite number is allowed", what, value);
  return value;
}

std::size_t MshSource::count(const char* what, const Entry& entry) {
  const std::uint64_t value = size(what);
  // A number in ASCII has a digit and a blank.
  const std::size_t least = binary_ ? 4 * entry.integers + 8 * (entry.sizes + entry.numbers)
                                    : 2 * (entry.integers + entry.sizes + entry.numbers);
  if (value > (bytes_.size() - place_) / least)
    refuse("{} is {}, more than the rest of the file can hold", what, value);
  return value;
}

}  // namespace ixos

#include "study/restart/compare_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/history_file.hpp"
#include "study/common/history_table.hpp"

namespace ixos {
namespace {

using Json = nlohmann::ordered_json;

/// The rows of a table, cell by cell; the first row has the names.
class TextTable {
 public:
  explicit TextTable(const std::string& path) : path_(path), file_(open_text(path)) {
    if (!next()) throw FileError(path + ": cannot be read, or is empty");
    names_ = cells_;
    step_ = std::find(names_.begin(), names_.end(), "step") - names_.begin();
    if (step_ == static_cast<long>(names_.size())) throw FileError(path + ": has no column step");
  }
  /// Reads the next row. Returns false at the end of the file, and where a row is of a later step.
  bool next(long last_step) {
    return next() && static_cast<long>(cells_.size()) > step_ && std::atol(text(step_).c_str()) <= last_step;
  }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& cells() const { return cells_; }
  const std::string& step() const { return text(step_); }

 private:
  bool next() {
    std::string line;
    if (!std::getline(file_, line)) return false;
    cells_ = csv_cells(line);
    return true;
  }
  const std::string& text(long column) const { return cells_[static_cast<std::size_t>(column)]; }

  std::string path_;
  std::ifstream file_;
  std::vector<std::string> names_, cells_;
  long step_ = 0;
};

Json read_object(const std::string& path) {
  std::ifstream file = open_text(path);
  Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) throw FileError(path + ": cannot be read as JSON");
  return json;
}

/// Returns how the bytes of two files differ first; empty if they do not.
std::string byte_difference(const std::string& expected, const std::string& found) {
  const DiskFile mine(expected, DiskFile::Mode::Read), theirs(found, DiskFile::Mode::Read);
  if (mine.length() != theirs.length()) return fmt::format("{} bytes and {} bytes", mine.length(), theirs.length());
  std::array<char, 1 << 16> one{}, other{};
  for (std::uint64_t position = 0; position < mine.length();) {
    const std::size_t size = mine.read_at(position, one.data(), one.size());
    if (size == 0 || theirs.read_at(position, other.data(), size) != size) return "its length changes";
    const auto end = one.begin() + static_cast<long>(size);
    const auto place = std::mismatch(one.begin(), end, other.begin()).first;
    if (place != end) return fmt::format("byte {} differs", position + static_cast<std::uint64_t>(place - one.begin()));
    position += size;
  }
  return "";
}

std::vector<std::string> field_files(const std::string& folder) {
  std::vector<std::string> names = names_in(folder);
  const auto is_other = [](const std::string& name) { return name.rfind("fields.e", 0) != 0; };
  names.erase(std::remove_if(names.begin(), names.end(), is_other), names.end());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string history_difference(const std::string& expected, const std::string& found, long last_step) {
  TextTable mine(expected), theirs(found);
  if (mine.names() != theirs.names()) return "the columns have other names";
  std::string step = "none";
  while (true) {
    const bool more = mine.next(last_step), others = theirs.next(last_step);
    if (!more && !others) return "";
    if (more != others) return fmt::format("{} after the row of step {}", others ? "further rows" : "no row", step);
    step = mine.step();
    if (mine.cells().size() != theirs.cells().size()) return fmt::format("step {}: other cells", step);
    for (std::size_t c = 0; c < mine.cells().size(); ++c)
      if (mine.cells()[c] != theirs.cells()[c] && mine.names().at(c) != "wall_seconds")
        return fmt::format("step {}, column {}: {} and {}", step, mine.names()[c], mine.cells()[c], theirs.cells()[c]);
  }
}

std::string summary_difference(const std::string& expected, const std::string& found) {
  static const std::set<std::string> ignored{"restarts", "wall_seconds",      "setup_seconds", "seconds_per_increment",
                                             "seconds",  "peak_memory_bytes", "checkpoint"};
  const Json mine = read_object(expected), theirs = read_object(found);
  for (const auto& [key, value] : mine.items()) {
    if (ignored.count(key) > 0) continue;
    if (!theirs.contains(key)) return key + " is missing";
    if (value != theirs[key]) return fmt::format("{}: {} and {}", key, value.dump(), theirs[key].dump());
  }
  for (const auto& item : theirs.items())
    if (!mine.contains(item.key()) && ignored.count(item.key()) == 0) return item.key() + " is new";
  return "";
}

std::string results_difference(const std::string& expected, const std::string& found) {
  const auto told = [](const std::string& file, const std::string& difference) { return file + ": " + difference; };
  if (const std::string d = history_difference(expected + "/history.csv", found + "/history.csv"); !d.empty())
    return told("history.csv", d);
  if (const std::string d = summary_difference(expected + "/summary.json", found + "/summary.json"); !d.empty())
    return told("summary.json", d);
  const std::vector<std::string> names = field_files(expected);
  if (names != field_files(found)) return told("fields.e", "there are other files");
  for (const std::string& name : names)
    if (const std::string d = byte_difference(fmt::format("{}/{}", expected, name), fmt::format("{}/{}", found, name));
        !d.empty())
      return told(name, d);
  return "";
}

}  // namespace ixos

// Gwyddion Simple Field 1.0: a header of lines "Name = value", zeros up to a multiple of 4 bytes, floats in rows from
// the top, low byte first (gwyddion.net/documentation/user-guide-en/gsf.html).
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/text.hpp"
#include "io/height_grid.hpp"

namespace ixos {
namespace {

class SimpleField {
 public:
  SimpleField(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {
    const std::size_t zero = bytes.find('\0');
    if (zero == std::string::npos) refuse("the end of the header is missing");
    std::size_t place = bytes.find('\n');
    while (place < zero) {
      const std::size_t end = bytes.find('\n', place + 1);
      if (end == std::string::npos || end > zero) break;
      add(bytes.substr(place + 1, end - place - 1));
      place = end;
    }
    data_ = (zero / 4 + 1) * 4;
  }

  HeightGrid read() const {
    HeightGrid grid;
    grid.columns = size("XRes");
    grid.rows = size("YRes");
    if (data_ > bytes_.size() || grid.columns > (bytes_.size() - data_) / 4 / grid.rows ||
        (bytes_.size() - data_) / 4 != grid.rows * grid.columns)
      refuse(fmt::format("has no data of {} x {} heights", grid.columns, grid.rows));
    const double unit = metres_in(text("XYUnits"), path_ + ": XYUnits"),
                 height_unit = metres_in(text("ZUnits"), path_ + ": ZUnits");
    grid.in_metres = true;
    grid.column_spacing = length("XReal") * unit / static_cast<double>(grid.columns);
    grid.row_spacing = length("YReal") * unit / static_cast<double>(grid.rows);
    grid.heights.resize(grid.rows * grid.columns);
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const double height = number_at(row * grid.columns + column);
        check_height(height, path_, row + 1, column + 1);
        grid.heights[(grid.rows - 1 - row) * grid.columns + column] = height * height_unit;
      }
    return grid;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(path_ + ": " + why); }

  void add(const std::string& line) {
    const std::size_t sign = line.find('=');
    if (sign == std::string::npos) refuse("the line \"" + printable(line.substr(0, 40)) + "\" of the header has no =");
    fields_[trimmed(line.substr(0, sign))] = trimmed(line.substr(sign + 1));
  }
  std::string text(const std::string& name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? "" : found->second;
  }
  /// Returns the number of a line; `what` says what it must be.
  template <class T>
  T positive(const std::string& name, const char* what) const {
    const std::string word = text(name);
    T value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !(value > 0) ||
        !std::isfinite(static_cast<double>(value)))
      refuse(fmt::format("{} is \"{}\"; it must be a positive {}", name, printable(word.substr(0, 40)), what));
    return value;
  }
  std::size_t size(const std::string& name) const { return positive<std::size_t>(name, "number of heights"); }
  double length(const std::string& name) const { return positive<double>(name, "length"); }
  double number_at(std::size_t k) const {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes_[data_ + 4 * k + i]);
    float value = 0;
    std::memcpy(&value, &word, sizeof value);
    return value;
  }

  const std::string& path_;
  const std::string& bytes_;
  std::map<std::string, std::string> fields_;
  std::size_t data_ = 0;  ///< position of the first height
};

}  // namespace

HeightGrid read_simple_field(const std::string& path, const std::string& bytes) {
  return SimpleField(path, bytes).read();
}

}  // namespace ixos

#include "io/height_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "io/disk_file.hpp"
#include "units/unit.hpp"

namespace ixos {
namespace {

constexpr std::uint64_t largest_file = std::uint64_t{1} << 31U;  // bytes: a grid of 16000 x 16000 doubles

std::string contents(const std::string& path) {
  if (!is_file(path)) throw InputError(path + ": the file of heights cannot be read");
  if (const std::uint64_t bytes = DiskFile(path, DiskFile::Mode::Read).length(); bytes > largest_file)
    throw InputError(fmt::format("{}: has {} bytes; at most {} are read", path, bytes, largest_file));
  return read_whole_file(path);
}

bool begins_with(const std::string& bytes, std::string_view start) {
  return bytes.compare(0, start.size(), start) == 0;
}

/// Appends the numbers of a line. Returns how many there are.
std::size_t append_numbers(std::string_view line, const std::string& place, std::vector<double>& numbers) {
  constexpr std::string_view separators = " \t,;\r";
  std::size_t count = 0;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(separators), line.size()));
    if (line.empty()) return count;
    const std::string_view word = line.substr(0, line.find_first_of(separators));
    ++count;
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      throw InputError(fmt::format("{}, number {}: {} is no height: every height must be a finite number", place, count,
                                   in_quotes(printable(std::string(word)))));
    numbers.push_back(value);
    line.remove_prefix(word.size());
  }
}

}  // namespace

HeightGrid read_height_grid(const std::string& path) {
  const std::string bytes = contents(path);
  if (begins_with(bytes, "Gwyddion Simple Field 1.0")) return read_simple_field(path, bytes);
  if (begins_with(bytes, "CDF")) return read_netcdf_heights(path, bytes);
  if (begins_with(bytes, "\x89HDF"))
    throw InputError(path + ": is a file of netCDF-4, which Ixos does not read: convert it with nccopy -k classic");
  return read_height_text(path, bytes);
}

HeightGrid read_height_text(const std::string& path, const std::string& bytes) {
  HeightGrid grid;
  std::string_view rest = bytes;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!line.empty() && line.front() == '#') continue;
    const std::string place = fmt::format("{}: line {}", path, number);
    const std::size_t count = append_numbers(line, place, grid.heights);
    if (count == 0) continue;
    if (grid.rows == 0) grid.columns = count;
    if (count != grid.columns)
      throw InputError(fmt::format("{} has {} heights, but the first row has {}", place, count, grid.columns));
    ++grid.rows;
  }
  if (grid.rows == 0) throw InputError(path + ": has no heights");
  for (std::size_t row = 0; row < grid.rows / 2; ++row)  // the last line is the lowest row
    std::swap_ranges(grid.heights.begin() + static_cast<std::ptrdiff_t>(row * grid.columns),
                     grid.heights.begin() + static_cast<std::ptrdiff_t>((row + 1) * grid.columns),
                     grid.heights.begin() + static_cast<std::ptrdiff_t>((grid.rows - 1 - row) * grid.columns));
  return grid;
}

double metres_in(const std::string& unit, const std::string& place) {
  if (unit.empty()) throw InputError(place + " is missing: the unit must be a length, such as \"m\" or \"nm\"");
  std::string symbol = ascii_units(unit);
  for (const char* name : {"meters", "metres", "meter", "metre"})
    if (symbol == name) symbol = "m";
  try {
    const Unit found = parse_unit(symbol, si_unit);
    if (found.dimension == si_unit("m")->dimension) return found.factor.nearest();
  } catch (const InputError&) {  // the message below names the place
  }
  throw InputError(
      fmt::format("{} is {}: it must be a length, such as \"m\" or \"nm\"", place, in_quotes(printable(unit))));
}

void check_height(double height, const std::string& path, std::size_t row, std::size_t column) {
  if (!std::isfinite(height))
    throw InputError(fmt::format("{}: the height in row {}, column {} is missing: fill the gaps of the field first",
                                 path, row, column));
}

}  // namespace ixos

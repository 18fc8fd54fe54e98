#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "io/height_grid.hpp"
#include "io/netcdf_classic.hpp"

namespace ixos {
namespace {

using Variable = NetcdfClassic::Variable;

class Heights {
 public:
  Heights(const std::string& path, const std::string& bytes) : path_(path), file_(path, bytes) {}

  HeightGrid read() const {
    const Variable& field = the_field();
    HeightGrid grid;
    grid.in_metres = true;
    const auto& dimensions = file_.dimensions();
    grid.rows = dimensions[field.dimensions[0]].length;
    grid.columns = dimensions[field.dimensions[1]].length;
    if (grid.rows == 0 || grid.columns == 0) refuse(field, "has no heights, or a dimension that grows");
    const double unit = unit_of(field);
    const std::vector<double> raw = file_.values(field);
    const Spacing along_rows = spacing(field.dimensions[0]), along_columns = spacing(field.dimensions[1]);
    grid.row_spacing = along_rows.distance;
    grid.column_spacing = along_columns.distance;
    const double factor = number(field, "scale_factor", 1), offset = number(field, "add_offset", 0);
    const std::vector<double> fills = fill_values(field);
    grid.heights.resize(raw.size());
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const double value = raw[row * grid.columns + column];
        const bool missing = is_missing(value, fills);
        const double height = missing ? std::numeric_limits<double>::quiet_NaN() : (value * factor + offset) * unit;
        check_height(height, path_, row + 1, column + 1);
        const std::size_t i = along_rows.falls ? grid.rows - 1 - row : row;
        const std::size_t j = along_columns.falls ? grid.columns - 1 - column : column;
        grid.heights[i * grid.columns + j] = height;
      }
    return grid;
  }

 private:
  struct Spacing {
    double distance = 0;  ///< [m]
    bool falls = false;
  };

  [[noreturn]] void refuse(const Variable& variable, const std::string& why) const {
    throw InputError(fmt::format("{}: the variable \"{}\" {}", path_, printable(variable.name), why));
  }

  /// Returns the one variable of two dimensions.
  const Variable& the_field() const {
    const Variable* found = nullptr;
    for (const Variable& variable : file_.variables()) {
      if (variable.dimensions.size() != 2) continue;
      if (found != nullptr)
        throw InputError(fmt::format("{}: has two variables of two dimensions, \"{}\" and \"{}\"; leave one", path_,
                                     printable(found->name), printable(variable.name)));
      found = &variable;
    }
    if (found == nullptr) throw InputError(path_ + ": has no variable of two dimensions");
    return *found;
  }

  double unit_of(const Variable& variable) const {
    const NetcdfClassic::Attribute* units = variable.attribute("units");
    return metres_in(units == nullptr ? "" : units->text,
                     fmt::format("{}: the units of \"{}\"", path_, printable(variable.name)));
  }

  double number(const Variable& variable, const char* name, double fallback) const {
    const NetcdfClassic::Attribute* attribute = variable.attribute(name);
    if (attribute == nullptr) return fallback;
    if (attribute->numbers.size() != 1) refuse(variable, fmt::format("has a {} that is no number", name));
    return attribute->numbers.front();
  }

  /// Returns the values that stand for missing heights.
  static std::vector<double> fill_values(const Variable& variable) {
    std::vector<double> values;
    for (const char* name : {"_FillValue", "missing_value"})
      if (const auto* attribute = variable.attribute(name))
        values.insert(values.end(), attribute->numbers.begin(), attribute->numbers.end());
    return values;
  }
  /// The default fill value is that of netcdf.h, of floats and doubles.
  static bool is_missing(double value, const std::vector<double>& fills) {
    constexpr double fill = 9.9692099683868690e+36;
    return std::find(fills.begin(), fills.end(), value) != fills.end() ||
           (std::abs(value) >= fill * (1 - 1e-6) && std::abs(value) <= fill * (1 + 1e-6));
  }

  /// Reads the coordinates of a dimension: the variable of its name.
  Spacing spacing(std::size_t dimension) const {
    const NetcdfClassic::Dimension& own = file_.dimensions()[dimension];
    for (const Variable& variable : file_.variables()) {
      if (variable.name != own.name || variable.dimensions != std::vector<std::size_t>{dimension}) continue;
      const std::vector<double> x = file_.values(variable);
      if (x.size() < 2) return {};
      const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
      for (std::size_t k = 1; k < x.size(); ++k)
        if (!(std::abs(x[k] - x[k - 1] - mean) <= 1e-3 * std::abs(mean)))
          refuse(variable, fmt::format("is not in equal distances: {} follows {}", x[k], x[k - 1]));
      if (!(std::abs(mean) > 0) || !std::isfinite(mean)) refuse(variable, "has equal coordinates");
      return {std::abs(mean) * unit_of(variable), mean < 0};
    }
    throw InputError(
        fmt::format("{}: has no variable \"{}\" with the coordinates of that dimension", path_, printable(own.name)));
  }

  std::string path_;
  NetcdfClassic file_;
};

}  // namespace

HeightGrid read_netcdf_heights(const std::string& path, const std::string& bytes) {
  return Heights(path, bytes).read();
}

}  // namespace ixos

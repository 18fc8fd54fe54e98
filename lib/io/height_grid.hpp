/// Files of heights on a regular grid: scans of rough surfaces.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ixos {

/// Heights on a grid of rows and columns.
struct HeightGrid {
  std::size_t rows = 0, columns = 0;
  double row_spacing = 0;       ///< distance of two rows, along the second coordinate; 0 if the file does not state it
  double column_spacing = 0;    ///< distance of two columns, along the first coordinate; 0 likewise
  std::vector<double> heights;  ///< row by row, from the row with the least second coordinate
  bool in_metres = false;       ///< whether spacings and heights are in m; otherwise the file states no units
};

/// Reads a file. Its first bytes say its format:
/// - Gwyddion Simple Field (.gsf) with XReal, YReal, XYUnits and ZUnits;
/// - netCDF, classic, 64-bit offset or 64-bit data, with one variable of two dimensions. It and the variables of its
///   dimensions have the attribute "units". The coordinates must be in equal distances;
/// - a text with the numbers of a row in each line, from the row with the greatest second coordinate. A line that
///   begins with # is a comment. It has no units.
/// Throws InputError, with the path and the place, for a file that cannot be read or is damaged, for missing heights
/// (not a number, infinite, or the fill value), and for units that are missing or no lengths.
HeightGrid read_height_grid(const std::string& path);

/// Read the bytes of a file of one format; messages begin with `path`.
HeightGrid read_height_text(const std::string& path, const std::string& bytes);
HeightGrid read_simple_field(const std::string& path, const std::string& bytes);
HeightGrid read_netcdf_heights(const std::string& path, const std::string& bytes);

/// Returns metres in a unit of length, "um" or "metre". Throws InputError that begins with `place`.
double metres_in(const std::string& unit, const std::string& place);

/// Throws InputError, with the path, row and column as the file counts them from 1, if a height is no finite number.
void check_height(double height, const std::string& path, std::size_t row, std::size_t column);

}  // namespace ixos

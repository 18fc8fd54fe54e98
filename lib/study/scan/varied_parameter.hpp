/// A parameter that a scan varies.
#pragma once
#include <string>

#include "study/common/axes.hpp"

namespace ixos {

/// The values of one parameter, in their order. The name is the parameter's own, without the lists it is in.
struct VariedParameter : Axis {
  std::string path;          ///< "List/Sublist/Name"
  bool logarithmic = false;  ///< the values have equal ratios
  std::string unit;          ///< of plain numbers, "E0", which read_scan() fills in; empty if they have none

  /// Returns whether all values are plain numbers.
  bool has_plain_numbers() const;
};

/// Reads "List/Sublist/Name=from:to:number" for so many numbers at equal distances, with ":log" behind for equal
/// ratios, or "List/Sublist/Name={one, two, ...}" for any values. Throws InputError that quotes the text.
VariedParameter read_varied(const std::string& text);

}  // namespace ixos

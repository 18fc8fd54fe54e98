/// Numbers with units, as text.
#pragma once
#include <string>
#include <vector>

#include "units/unit.hpp"

namespace ixos {

/// A number with its unit, exact.
struct Quantity {
  bool negative = false;
  Unit magnitude;         ///< the number times its unit
  bool has_unit = false;  ///< false for a plain number
  std::string text;       ///< as the user wrote it, for messages
};

/// Returns whether the text begins with digits, perhaps after a sign and blanks.
bool begins_with_number(const std::string& text);

/// Reads "2 MPa", "-1e-3 m/s" or "5"; the locale plays no part. Throws InputError, which quotes the text, for one that
/// does not begin with a number, whose number has more than 19 significant digits, or whose unit is none.
Quantity parse_quantity(const std::string& text);

/// Reads "{1 nm, 2 um}" or "{1, 2} nm". Either no element has a unit or all but zeros have one. Throws InputError.
std::vector<Quantity> parse_quantities(const std::string& text);

/// Returns how many units a quantity is, as the nearest double (see Ratio::nearest). The dimensions must be equal.
/// Throws InputError, which quotes the text, beyond the range of numbers.
double in_unit(const Quantity& quantity, const Unit& unit);

}  // namespace ixos

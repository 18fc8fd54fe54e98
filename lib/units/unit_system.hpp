/// The units of a scene: L0, E0 and T0.
#pragma once
#include <string>

#include "units/quantity.hpp"

namespace ixos {

/// The scales that a scene's plain numbers refer to.
class UnitSystem {
 public:
  /// Scales as text, "1 nm", "2 GPa" and "1 ns". Throws InputError that begins with "Units/Length", "Units/Energy
  /// Density" or "Units/Time" for one that is not a positive quantity of that kind, or beyond the range of numbers.
  UnitSystem(const std::string& length, const std::string& energy_density, const std::string& time);

  /// Returns the unit that the expression names in brackets of the documentation: products of L0, E0, T0, of SI units,
  /// and "degrees"; "-" is a pure number.
  Unit unit(const std::string& expression) const;

  /// Returns one such unit in SI units: 2e9 for "E0". Throws InputError, which names the scales, beyond the range of
  /// numbers.
  double si(const std::string& expression) const;

  /// Returns a value in that unit as an SI quantity with a prefix: (10, "L0") as "10 nm". `in` is the SI unit to print;
  /// if empty, the usual one of the dimension.
  std::string text(double value, const std::string& expression, const std::string& in = "") const;

 private:
  Quantity length_, energy_density_, time_;
};

/// Returns a value of an SI unit with a prefix, four digits: (3.1e-2, "J/m^2") as "31 mJ/m^2". Units that begin with kg
/// or 1/, areas and volumes get no prefix.
std::string si_text(double value, const std::string& unit);

}  // namespace ixos

#include "units/unit_system.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Returns the scale that an entry of "Units" gives. Throws InputError without its path.
Quantity read_scale(const std::string& text, const Dimension& wanted) {
  const Quantity quantity = parse_quantity(text);
  const DimensionName needed = dimension_name(wanted);
  if (quantity.magnitude.dimension != wanted)
    throw InputError(fmt::format("{} is {}; {} is needed, as in \"{}\"", in_quotes(text),
                                 dimension_name(quantity.magnitude.dimension).name, needed.name, needed.example));
  if (quantity.negative || quantity.magnitude.factor.is_zero())
    throw InputError(fmt::format("{} must be greater than 0", in_quotes(text)));
  in_unit(quantity, {Ratio(), wanted});  // refuses what is beyond the range of numbers
  return quantity;
}

Quantity scale(const std::string& name, const std::string& text, const Dimension& wanted) {
  try {
    return read_scale(text, wanted);
  } catch (const InputError& error) {
    throw InputError("Units/" + name + ": " + error.what());
  }
}

}  // namespace

UnitSystem::UnitSystem(const std::string& length, const std::string& energy_density, const std::string& time)
    : length_(scale("Length", length, {{1}})),
      energy_density_(scale("Energy Density", energy_density, {{-1, 1, -2}})),
      time_(scale("Time", time, {{0, 0, 1}})) {}

Unit UnitSystem::unit(const std::string& expression) const {
  if (expression == "-") return {};
  return parse_unit(expression, [this](const std::string& symbol) -> std::optional<Unit> {
    if (symbol == "L0") return length_.magnitude;
    if (symbol == "E0") return energy_density_.magnitude;
    if (symbol == "T0") return time_.magnitude;
    return si_unit(symbol == "degrees" ? "deg" : symbol);
  });
}

double UnitSystem::si(const std::string& expression) const {
  try {
    return unit(expression).factor.nearest();
  } catch (const InputError& error) {
    throw InputError(fmt::format("Units: Length {}, Energy Density {} and Time {} make the unit {}: {}",
                                 in_quotes(length_.text), in_quotes(energy_density_.text), in_quotes(time_.text),
                                 expression, error.what()));
  }
}

std::string UnitSystem::text(double value, const std::string& expression, const std::string& in) const {
  return si_text(value * si(expression), in.empty() ? dimension_name(unit(expression).dimension).unit : in);
}

std::string si_text(double value, const std::string& unit) {
  if (unit.empty()) return fmt::format("{:.4g}", value);
  static const std::vector<std::pair<int, const char*>> prefixes{
      {12, "T"}, {9, "G"}, {6, "M"}, {3, "k"}, {0, ""}, {-3, "m"}, {-6, "u"}, {-9, "n"}, {-12, "p"}, {-15, "f"}};
  const bool plain = unit.rfind("kg", 0) == 0 || unit.rfind("1/", 0) == 0 || unit.rfind("m^", 0) == 0;
  if (!plain)
    for (const auto& [exponent, prefix] : prefixes) {
      const double shown = value * std::pow(10.0, -exponent);
      if (std::abs(shown) >= 0.99995 && std::abs(shown) < 9999.5)
        return fmt::format("{:.4g} {}{}", shown, prefix, unit);
    }
  return fmt::format("{:.4g} {}", value, unit);
}

}  // namespace ixos

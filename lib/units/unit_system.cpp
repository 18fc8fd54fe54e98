#include "units/unit_system.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Returns the scale that an entry of "Units" gives.
Unit scale(const std::string& name, const std::string& text, const Dimension& wanted) {
  Quantity quantity;
  try {
    quantity = parse_quantity(text);
  } catch (const InputError& error) {
    throw InputError("Units/" + name + ": " + error.what());
  }
  const DimensionName needed = dimension_name(wanted);
  if (quantity.magnitude.dimension != wanted)
    throw InputError(fmt::format("Units/{}: {} is {}; {} is needed, as in \"{}\"", name, in_quotes(text),
                                 dimension_name(quantity.magnitude.dimension).name, needed.name, needed.example));
  if (quantity.negative || quantity.magnitude.factor.is_zero())
    throw InputError(fmt::format("Units/{}: {} must be greater than 0", name, in_quotes(text)));
  return quantity.magnitude;
}

}  // namespace

UnitSystem::UnitSystem(const std::string& length, const std::string& energy_density, const std::string& time)
    : length_(scale("Length", length, {{1}})),
      energy_density_(scale("Energy Density", energy_density, {{-1, 1, -2}})),
      time_(scale("Time", time, {{0, 0, 1}})) {}

Unit UnitSystem::unit(const std::string& expression) const {
  if (expression == "-") return {};
  return parse_unit(expression, [this](const std::string& symbol) -> std::optional<Unit> {
    if (symbol == "L0") return length_;
    if (symbol == "E0") return energy_density_;
    if (symbol == "T0") return time_;
    return si_unit(symbol == "degrees" ? "deg" : symbol);
  });
}

std::string UnitSystem::text(double value, const std::string& expression, const std::string& in) const {
  const Unit own = unit(expression);
  const std::string usual = in.empty() ? dimension_name(own.dimension).unit : in;
  return si_text(value * own.factor.nearest(), usual);
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

#include "units/dimension.hpp"

#include <utility>
#include <vector>

namespace ixos {
namespace {

/// Returns the dimension length^l mass^m time^t.
Dimension mechanical(int l, int m, int t) { return {{l, m, t, 0, 0, 0, 0}}; }

const std::vector<std::pair<Dimension, DimensionName>>& names() {
  static const std::vector<std::pair<Dimension, DimensionName>> table{
      {mechanical(0, 0, 0), {"a pure number", "0.5", ""}},
      {mechanical(1, 0, 0), {"a length", "10 nm", "m"}},
      {mechanical(2, 0, 0), {"an area", "1 um^2", "m^2"}},
      {mechanical(3, 0, 0), {"a volume", "1 um^3", "m^3"}},
      {mechanical(0, 1, 0), {"a mass", "1 pg", "kg"}},
      {mechanical(0, 0, 1), {"a time", "1 ns", "s"}},
      {mechanical(0, 0, -1), {"a rate or frequency", "1 GHz", "1/s"}},
      {mechanical(1, 0, -1), {"a velocity", "1 m/s", "m/s"}},
      {mechanical(1, 0, -2), {"an acceleration", "9.81 m/s^2", "m/s^2"}},
      {mechanical(-3, 1, 0), {"a density", "1000 kg/m^3", "kg/m^3"}},
      {mechanical(-2, 1, 0), {"a mass per area", "1 kg/m^2", "kg/m^2"}},
      {mechanical(-1, 1, 0), {"a mass per length", "1 kg/m", "kg/m"}},
      {mechanical(1, 1, -1), {"a momentum", "1 kg m/s", "kg m/s"}},
      {mechanical(1, 1, -2), {"a force", "10 nN", "N"}},
      {mechanical(0, 1, -2), {"a force per length or energy per area", "30 mN/m\" or \"30 mJ/m^2", "N/m"}},
      {mechanical(-1, 1, -2), {"a stress or energy density", "2 MPa", "Pa"}},
      {mechanical(-2, 1, -2), {"a force per volume", "1e4 N/m^3", "N/m^3"}},
      {mechanical(2, 1, -2), {"an energy", "1e-19 J", "J"}},
      {mechanical(-1, 1, -1), {"a dynamic viscosity", "1 mPa s", "Pa s"}},
      {{{0, 0, 0, 0, 0, 0, 1}}, {"an angle", "45 deg", "rad"}},
      {{{0, 0, -1, 0, 0, 0, 1}}, {"an angular velocity", "1 rad/s", "rad/s"}}};
  return table;
}

}  // namespace

DimensionName dimension_name(const Dimension& dimension) {
  for (const auto& [known, name] : names())
    if (known == dimension) return name;
  static const std::array<const char*, 7> base{"m", "kg", "s", "A", "K", "mol", "rad"};
  std::string unit;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const int exponent = dimension.exponents[i];
    if (exponent == 0) continue;
    unit += (unit.empty() ? "" : " ") + std::string(base[i]);
    if (exponent != 1) unit += "^" + std::to_string(exponent);
  }
  return {"a quantity in " + unit, "", unit};
}

}  // namespace ixos

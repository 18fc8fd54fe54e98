/// Physical dimensions.
#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace ixos {

/// Exponents of the base quantities: length, mass, time, electric current, temperature, amount of substance, and the
/// plane angle. An angle counts as a base quantity here, so that 1 rad/s is no frequency in cycles per second.
struct Dimension {
  std::array<int, 7> exponents{};

  bool is_number() const { return *this == Dimension{}; }
  bool operator==(const Dimension& other) const { return exponents == other.exponents; }
  bool operator!=(const Dimension& other) const { return exponents != other.exponents; }
};

inline Dimension operator*(const Dimension& a, const Dimension& b) {
  Dimension product;
  for (std::size_t i = 0; i < a.exponents.size(); ++i) product.exponents[i] = a.exponents[i] + b.exponents[i];
  return product;
}

inline Dimension power(const Dimension& a, int exponent) {
  Dimension result;
  for (std::size_t i = 0; i < a.exponents.size(); ++i) result.exponents[i] = a.exponents[i] * exponent;
  return result;
}

/// The usual name of a dimension.
struct DimensionName {
  std::string name;     ///< with its article: "a density"; "a quantity in kg^2" if it has no name
  std::string example;  ///< "1000 kg/m^3"; empty if it has no name
  std::string unit;     ///< the SI unit in which Ixos prints it: "kg/m^3"
};
DimensionName dimension_name(const Dimension& dimension);

}  // namespace ixos

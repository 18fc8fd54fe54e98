/// Units of measurement and their expressions.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "units/dimension.hpp"
#include "units/ratio.hpp"

namespace ixos {

/// A unit: how many SI units (m, kg, s, A, K, mol, rad and their products) it is.
struct Unit {
  Ratio factor;
  Dimension dimension;

  Unit operator*(const Unit& other) const { return {factor * other.factor, dimension * other.dimension}; }
  Unit operator/(const Unit& other) const {
    return {factor / other.factor, dimension * ixos::power(other.dimension, -1)};
  }
  Unit power(int exponent) const { return {factor.power(exponent), ixos::power(dimension, exponent)}; }
};

/// Returns the unit of a symbol, or nothing if there is no such symbol.
using SymbolTable = std::function<std::optional<Unit>(const std::string&)>;

/// Reads "kg m/s^2", "J/(m s)", "1/s" or "N.m". A blank, * or . multiplies; exponents are integers. Throws InputError,
/// which quotes the unit, for a symbol that the table does not have, and for what could be read in two ways:
/// a product after a quotient ("J/m s") and exponents with a fraction ("MPa m^0.5").
Unit parse_unit(const std::string& text, const SymbolTable& table);

/// Returns the SI unit of that symbol: m, g, s, A, K, mol, rad, N, Pa, J, W, Hz, V, C, F, eV with a prefix (f, p, n, u,
/// m, c, d, h, k, M, G, T) or none, and deg, min, h, Angstrom. The characters µ and Å count as u and Angstrom.
std::optional<Unit> si_unit(const std::string& symbol);

/// Returns the text in double quotes for a message; a long one is cut.
std::string in_quotes(const std::string& text);

/// Returns the text with micro, angstrom, middle dots, raised digits and minus signs spelt in ASCII.
std::string ascii_units(std::string text);

}  // namespace ixos

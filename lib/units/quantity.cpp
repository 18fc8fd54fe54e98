#include "units/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/error.hpp"
#include "base/text.hpp"

namespace ixos {
namespace {

constexpr std::size_t most_digits = 19;  // below 2^64

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the place after the sign.
std::size_t after_sign(const std::string& text) { return !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0; }

/// Reads the digits from `at` on, an optional point among them; moves `at` behind them.
Ratio read_digits(const std::string& text, std::size_t& at) {
  std::string digits;
  int exponent = 0;
  for (bool fraction = false; at < text.size(); ++at) {
    const bool point = text[at] == '.' && !fraction;
    if (!point && !is_digit(text[at])) break;
    if (point)
      fraction = true;
    else if (digits.size() < 10 * most_digits)
      digits += text[at];
    else
      throw InputError("it has more than 19 significant digits");
    if (fraction && !point) --exponent;
  }
  const auto first = digits.find_first_not_of('0');
  if (first == std::string::npos) return Ratio(0);
  const auto last = digits.find_last_not_of('0');
  exponent += static_cast<int>(digits.size() - 1 - last);
  digits = digits.substr(first, last + 1 - first);
  if (digits.size() > most_digits) throw InputError("it has more than 19 significant digits");
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return Ratio(value, exponent);
}

/// Reads "e-3", if that stands at `at`; "eV" does not.
int read_exponent(const std::string& text, std::size_t& at) {
  if (at + 1 >= text.size() || (text[at] != 'e' && text[at] != 'E')) return 0;
  std::size_t start = at + 1;
  if (text[start] == '+') ++start;
  if (start >= text.size() || (text[start] != '-' && !is_digit(text[start]))) return 0;
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data() + start, text.data() + text.size(), exponent);
  if (error == std::errc::invalid_argument) return 0;
  if (error != std::errc() || std::abs(exponent) > 999) throw InputError("it is beyond the range of numbers");
  at = static_cast<std::size_t>(end - text.data());
  return exponent;
}

Quantity parse(const std::string& text) {
  if (!begins_with_number(text)) throw InputError("a number is missing; write it before the unit, as in 1 nm");
  Quantity quantity;
  quantity.text = text;
  std::size_t at = after_sign(text);
  quantity.negative = text[0] == '-';
  const Ratio digits = read_digits(text, at);
  quantity.magnitude.factor = digits * Ratio(1, read_exponent(text, at));
  const std::string unit = trimmed(text.substr(at));
  quantity.has_unit = !unit.empty();
  if (quantity.has_unit) quantity.magnitude = quantity.magnitude * parse_unit(ascii_units(unit), si_unit);
  return quantity;
}

/// Calls a function and quotes the text before the message of its InputError.
template <class Function>
auto quoting(const std::string& text, const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(in_quotes(text) + ": " + error.what());
  }
}

}  // namespace

bool begins_with_number(const std::string& text) {
  const std::string body = trimmed(text);
  const std::size_t at = after_sign(body);
  return at < body.size() &&
         (is_digit(body[at]) || (body[at] == '.' && at + 1 < body.size() && is_digit(body[at + 1])));
}

Quantity parse_quantity(const std::string& text) {
  const std::string body = trimmed(text);
  return quoting(body, [&] { return parse(body); });
}

std::vector<Quantity> parse_quantities(const std::string& text) {
  const std::string body = trimmed(text);
  const auto end = body.find('}');
  if (body.empty() || body[0] != '{' || end == std::string::npos)
    throw InputError(in_quotes(body) + " is no list of numbers, as in {1, 2} nm");
  const std::string inside = trimmed(body.substr(1, end - 1)), unit = trimmed(body.substr(end + 1));
  std::vector<Quantity> quantities;
  if (inside.empty()) return quantities;
  for (std::string& element : split(inside, ',')) {
    if (!unit.empty() && parse_quantity(element).has_unit)
      throw InputError(in_quotes(body) + ": give each element its unit, or one unit after the brace");
    if (!unit.empty()) element += ' ' + unit;
    quantities.push_back(parse_quantity(element));
  }
  const auto lacks = [](const Quantity& q) { return !q.has_unit && !q.magnitude.factor.is_zero(); };
  const auto has = [](const Quantity& q) { return q.has_unit; };
  if (std::any_of(quantities.begin(), quantities.end(), has) &&
      std::any_of(quantities.begin(), quantities.end(), lacks))
    throw InputError(in_quotes(body) + ": some elements have a unit and some have none");
  return quantities;
}

double in_unit(const Quantity& quantity, const Unit& unit) {
  const double value = quoting(quantity.text, [&] { return (quantity.magnitude.factor / unit.factor).nearest(); });
  return quantity.negative ? -value : value;
}

}  // namespace ixos

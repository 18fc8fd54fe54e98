#include "units/unit.hpp"

#include <cctype>
#include <cstddef>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

constexpr std::size_t longest_unit = 100;
constexpr int largest_exponent = 9;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 128 || c == '_';
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A recursive descent through one expression of ASCII characters.
class Parser {
 public:
  Parser(const std::string& text, const SymbolTable& table) : text_(text), table_(table) {}

  Unit parse() {
    if (text_.size() > longest_unit) refuse("it is longer than 100 characters");
    Unit unit = expression();
    if (at_ < text_.size()) refuse(std::string("a unit cannot continue with \"") + text_[at_] + '"');
    return unit;
  }

 private:
  Unit expression() {
    skip_blanks();
    bool divided = peek() == '/';
    Unit unit = divided ? Unit{} : term();
    while (true) {
      const bool blank = skip_blanks();
      if (peek() == '/') {
        ++at_;
        unit = unit / term();
        divided = true;
        continue;
      }
      const bool sign = peek() == '*' || peek() == '.';
      if (!sign && !(blank && begins_term())) return unit;
      if (divided) refuse("a product after a quotient is ambiguous; write a/(b c) or a c/b");
      if (sign) ++at_;
      unit = unit * term();
    }
  }

  Unit term() {
    skip_blanks();
    if (peek() == '(') {
      ++at_;
      Unit unit = expression();
      if (peek() != ')') refuse("a parenthesis is not closed");
      ++at_;
      if (peek() == '^') refuse("a parenthesis cannot have an exponent");
      return unit;
    }
    if (peek() == '1' && !(at_ + 1 < text_.size() && (is_digit(text_[at_ + 1]) || text_[at_ + 1] == '.'))) {
      ++at_;
      return {};
    }
    if (!is_letter(peek())) refuse("a unit is missing");
    std::string symbol;
    for (; is_letter(peek()) || is_digit(peek()); ++at_) symbol += peek();
    const std::optional<Unit> unit = table_(symbol);
    if (!unit) refuse_symbol(symbol);
    return peek() == '^' ? unit->power(exponent()) : *unit;
  }

  int exponent() {
    ++at_;
    const bool enclosed = peek() == '(';
    if (enclosed) ++at_;
    const bool negative = peek() == '-';
    if (negative || peek() == '+') ++at_;
    if (!is_digit(peek())) refuse("an exponent must be an integer");
    const int value = text_[at_++] - '0';
    if (is_digit(peek())) refuse("an exponent must be at most " + std::to_string(largest_exponent));
    if (enclosed ? peek() != ')' : peek() == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))
      refuse("an exponent must be an integer");
    if (enclosed) ++at_;
    return negative ? -value : value;
  }

  [[noreturn]] void refuse(const std::string& why) const { throw InputError("unit " + in_quotes(text_) + ": " + why); }

  [[noreturn]] void refuse_symbol(const std::string& symbol) const {
    std::string letters = symbol;
    while (!letters.empty() && is_digit(letters.back())) letters.pop_back();
    std::string nearest = letters + "^" + symbol.substr(letters.size());
    if (letters.size() == symbol.size() || !table_(letters)) {
      static const std::vector<std::string> usual{
          "m",   "cm",  "mm",  "um",  "nm",  "pm",  "Angstrom", "kg", "g",  "mg",  "ug", "ng", "pg",
          "s",   "ms",  "us",  "ns",  "ps",  "min", "h",        "N",  "mN", "uN",  "nN", "pN", "Pa",
          "kPa", "MPa", "GPa", "J",   "mJ",  "uJ",  "nJ",       "aJ", "eV", "keV", "W",  "mW", "Hz",
          "kHz", "MHz", "GHz", "deg", "rad", "V",   "mV",       "C",  "F",  "K",   "A",  "mol"};
      nearest = closest_name(symbol, usual);
    }
    throw InputError("unit \"" + symbol + "\" does not exist; did you mean \"" + nearest + "\"?");
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool begins_term() const { return is_letter(peek()) || peek() == '(' || is_digit(peek()); }
  bool skip_blanks() {
    const std::size_t start = at_;
    while (peek() == ' ' || peek() == '\t') ++at_;
    return at_ > start;
  }

  const std::string& text_;
  const SymbolTable& table_;
  std::size_t at_ = 0;
};

}  // namespace

std::string in_quotes(const std::string& text) {
  return '"' + (text.size() > longest_unit ? text.substr(0, longest_unit) + "..." : text) + '"';
}

Unit parse_unit(const std::string& text, const SymbolTable& table) { return Parser(text, table).parse(); }

}  // namespace ixos

// The table of units. The SI brochure (BIPM 2019) defines them; e is exact since then.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "units/unit.hpp"

namespace ixos {
namespace {

struct Entry {
  const char* symbol;
  Unit unit;
};

const std::vector<Entry>& with_prefix() {
  static const std::vector<Entry> table{{"m", {Ratio(1), {{1}}}},
                                        {"g", {Ratio(1, -3), {{0, 1}}}},
                                        {"s", {Ratio(1), {{0, 0, 1}}}},
                                        {"A", {Ratio(1), {{0, 0, 0, 1}}}},
                                        {"K", {Ratio(1), {{0, 0, 0, 0, 1}}}},
                                        {"mol", {Ratio(1), {{0, 0, 0, 0, 0, 1}}}},
                                        {"rad", {Ratio(1), {{0, 0, 0, 0, 0, 0, 1}}}},
                                        {"N", {Ratio(1), {{1, 1, -2}}}},
                                        {"Pa", {Ratio(1), {{-1, 1, -2}}}},
                                        {"J", {Ratio(1), {{2, 1, -2}}}},
                                        {"W", {Ratio(1), {{2, 1, -3}}}},
                                        {"Hz", {Ratio(1), {{0, 0, -1}}}},
                                        {"C", {Ratio(1), {{0, 0, 1, 1}}}},
                                        {"V", {Ratio(1), {{2, 1, -3, -1}}}},
                                        {"F", {Ratio(1), {{-2, -1, 4, 2}}}},
                                        {"eV", {Ratio(1602176634, -28), {{2, 1, -2}}}}};
  return table;
}

const std::vector<Entry>& without_prefix() {
  static const std::vector<Entry> table{{"deg", {Ratio::pi() / Ratio(180), {{0, 0, 0, 0, 0, 0, 1}}}},
                                        {"min", {Ratio(60), {{0, 0, 1}}}},
                                        {"h", {Ratio(3600), {{0, 0, 1}}}},
                                        {"Angstrom", {Ratio(1, -10), {{1}}}}};
  return table;
}

struct Prefix {
  char symbol;
  int exponent;
};
constexpr std::array<Prefix, 12> prefixes{{{'f', -15},
                                           {'p', -12},
                                           {'n', -9},
                                           {'u', -6},
                                           {'m', -3},
                                           {'c', -2},
                                           {'d', -1},
                                           {'h', 2},
                                           {'k', 3},
                                           {'M', 6},
                                           {'G', 9},
                                           {'T', 12}}};

}  // namespace

std::optional<Unit> si_unit(const std::string& symbol) {
  for (const auto* table : {&without_prefix(), &with_prefix()})
    for (const Entry& entry : *table)
      if (symbol == entry.symbol) return entry.unit;
  for (const auto [prefix, exponent] : prefixes)
    for (const Entry& entry : with_prefix())
      if (symbol == prefix + std::string(entry.symbol))
        return Unit{entry.unit.factor * Ratio(1, exponent), entry.unit.dimension};
  return std::nullopt;
}

std::string ascii_units(std::string text) {
  using Spellings = std::vector<std::pair<std::string, std::string>>;
  static const Spellings spellings{{"\u00b5", "u"},        {"\u03bc", "u"},         {"\u00c5", "Angstrom"},
                                   {"\u212b", "Angstrom"}, {"A\u030a", "Angstrom"}, {"\u00b7", "*"},
                                   {"\u22c5", "*"},        {"\u2212", "-"},         {"\u00b0", "deg"}};
  for (const auto& [character, spelling] : spellings)
    for (auto at = text.find(character); at != std::string::npos; at = text.find(character, at + spelling.size()))
      text.replace(at, character.size(), spelling);
  static const Spellings raised{{"\u207b", "-"}, {"\u2070", "0"}, {"\u00b9", "1"}, {"\u00b2", "2"},
                                {"\u00b3", "3"}, {"\u2074", "4"}, {"\u2075", "5"}, {"\u2076", "6"},
                                {"\u2077", "7"}, {"\u2078", "8"}, {"\u2079", "9"}};
  std::string result;
  bool in_exponent = false;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::find_if(raised.begin(), raised.end(), [&](const auto& own) {
      return text.compare(at, own.first.size(), own.first) == 0;
    });
    const bool is_raised = found != raised.end();
    if (is_raised && !in_exponent) result += '^';
    result += is_raised ? found->second : text.substr(at, 1);
    at += is_raised ? found->first.size() : 1;
    in_exponent = is_raised;
  }
  return result;
}

}  // namespace ixos

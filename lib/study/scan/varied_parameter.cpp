#include "study/scan/varied_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"

namespace ixos {
namespace {

constexpr int most_values = 10000;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(
      fmt::format("--vary \"{}\": {}; write \"List/Sublist/Name=from:to:number\", the same with \":log\" behind for "
                  "equal ratios, or "
                  "\"List/Sublist/Name={{one, two}}\"",
                  text, why));
}

std::optional<double> number_of(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Returns numbers of twelve digits, so that 0.1 + 2 0.1 is 0.3, or of six where ratios are equal.
std::vector<std::string> spread(const std::string& text, const std::vector<std::string>& words, bool logarithmic) {
  const auto from = number_of(words[0]), to = number_of(words[1]), count = number_of(words[2]);
  if (!from || !to)
    refuse(text, fmt::format("\"{}\" is not a number; a range takes plain ones, in the units of the scene",
                             from ? words[1] : words[0]));
  if (!count || *count != std::floor(*count) || *count < 2 || *count > most_values)
    refuse(text,
           fmt::format("the number of values is \"{}\", which must be an integer from 2 to {}", words[2], most_values));
  if (*from == *to) refuse(text, "both ends are equal");
  if (logarithmic && !(*from * *to > 0)) refuse(text, "equal ratios need two ends of one sign, and none is 0");
  std::vector<std::string> values;
  const int last = static_cast<int>(*count) - 1;
  for (int i = 0; i <= last; ++i) {
    const double share = static_cast<double>(i) / last;
    double value = logarithmic ? *from * std::pow(*to / *from, share) : *from + share * (*to - *from);
    const bool is_end = i == 0 || i == last;
    if (std::abs(value) < 1e-12 * std::max(std::abs(*from), std::abs(*to))) value = 0;
    values.push_back(fmt::format("{:.{}g}", i == last ? *to : value, logarithmic && !is_end ? 6 : 12));
  }
  return values;
}

/// Returns the pieces between commas; an array in braces is one piece.
std::vector<std::string> pieces(const std::string& text) {
  std::vector<std::string> result{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (c == ',' && depth == 0)
      result.emplace_back();
    else
      result.back() += c;
  }
  for (std::string& piece : result) piece = trimmed(piece);
  return result;
}

/// Returns a value as tables and folders show it: {40, 2} as 40x2.
std::string label_of(const std::string& value) {
  if (value.size() < 2 || value.front() != '{' || value.back() != '}') return value;
  std::string label;
  for (const std::string& part : split(value.substr(1, value.size() - 2), ','))
    label += (label.empty() ? "" : "x") + part;
  return label;
}

}  // namespace

bool VariedParameter::has_plain_numbers() const {
  return std::all_of(values.begin(), values.end(), [](const AxisValue& value) { return number_of(value.label); });
}

VariedParameter read_varied(const std::string& text) {
  const auto equal = text.find('=');
  if (equal == std::string::npos || equal == 0) refuse(text, "there is no \"=\" behind the name of a parameter");
  VariedParameter varied;
  varied.path = trimmed(text.substr(0, equal));
  varied.name = varied.path.substr(varied.path.rfind('/') + 1);
  const std::string values = trimmed(text.substr(equal + 1));
  std::vector<std::string> words;
  if (values.size() > 1 && values.front() == '{' && values.back() == '}') {
    words = pieces(values.substr(1, values.size() - 2));
  } else {
    std::vector<std::string> parts = split(values, ':');
    varied.logarithmic = parts.size() == 4 && parts[3] == "log";
    if (parts.size() != 3 && !varied.logarithmic) refuse(text, fmt::format("\"{}\" is no range of values", values));
    words = spread(text, parts, varied.logarithmic);
  }
  for (const std::string& word : words) {
    if (word.empty()) refuse(text, "a value is empty");
    const std::string label = label_of(word);
    for (const AxisValue& before : varied.values)
      if (before.label == label) refuse(text, fmt::format("\"{}\" is given twice", word));
    varied.values.push_back({label, {varied.path + "=" + word}});
  }
  return varied;
}

}  // namespace ixos

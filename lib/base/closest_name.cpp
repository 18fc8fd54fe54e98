#include "base/closest_name.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <utility>

namespace ixos {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + substitution});
      const bool transposed =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (transposed) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// Returns the words of a name in lower case; blanks and hyphens separate them.
std::vector<std::string> words(const std::string& name) {
  std::vector<std::string> result;
  bool inside = false;
  for (char c : name) {
    const bool separates = c == ' ' || c == '-';
    if (!separates && !inside) result.emplace_back();
    if (!separates) result.back() += lower(c);
    inside = !separates;
  }
  return result;
}

/// Returns whether `name` abbreviates a candidate of several words: it consists of beginnings of all of them ("AVF",
/// "gen-alpha"), of the first of them in full ("HHT"), or of another one of four letters or more ("Dugdale").
bool abbreviates(const std::string& name, const std::string& candidate) {
  const std::vector<std::string> full = words(candidate);
  if (full.size() < 2) return false;
  std::string letters, first;
  for (const std::string& word : words(name)) letters += word;
  // True if beginnings of the words so far spell the first k letters.
  std::vector<bool> spelt(letters.size() + 1, false);
  spelt[0] = true;
  for (const std::string& word : full) {
    first += word;
    if (first == letters || (word == letters && word.size() >= 4)) return true;
    std::vector<bool> next(spelt.size(), false);
    for (std::size_t k = 0; k < letters.size(); ++k)
      for (std::size_t n = 0; spelt[k] && n < word.size() && k + n < letters.size() && letters[k + n] == word[n]; ++n)
        next[k + n + 1] = true;
    spelt = std::move(next);
  }
  return spelt[letters.size()];
}

}  // namespace

std::string closest_name(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string beginning = name.substr(0, 255);  // the work is the product of the lengths
  std::string best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  bool short_form = false;
  for (const std::string& candidate : candidates) {
    const std::size_t d = distance(beginning, candidate);
    const bool fits = d <= 1 || abbreviates(beginning, candidate);
    if (fits == short_form ? d < least : fits) {
      least = d;
      best = candidate;
      short_form = fits;
    }
  }
  return best;
}

std::string no_such(const std::string& what, const std::string& name, const std::vector<std::string>& names,
                    const std::string& there) {
  if (names.empty()) return what + " \"" + name + "\" does not exist. " + there + " none";
  constexpr std::size_t most = 30;
  std::string some =
      quoted_list({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size()))});
  if (names.size() > most) some += " and " + std::to_string(names.size() - most) + " more";
  return what + " \"" + name + "\" does not exist; did you mean \"" + closest_name(name, names) + "\"? " + there + " " +
         some;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text;
}

}  // namespace ixos

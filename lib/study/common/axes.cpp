#include "study/common/axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cstddef>
#include <set>

#include "base/error.hpp"

namespace ixos {
namespace {

/// A larger study is presumably a mistake.
constexpr std::size_t most_runs = 10000;
constexpr std::size_t most_settings = 1000000;  ///< of all runs together
constexpr std::size_t longest_name = 200;       ///< of a run's folder

/// Returns the text with letters, digits and + . - unchanged, anything else as one dash.
std::string file_name(const std::string& label) {
  std::string result;
  for (char c : label) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
    if (plain)
      result += c;
    else if (!result.empty() && result.back() != '-')
      result += '-';
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result.empty() ? "-" : result;
}

[[noreturn]] void refuse_run_name(const StudyRun& run) {
  throw InputError("Axes: the labels \"" + fmt::format("{}", fmt::join(run.labels, "\", \"")) +
                   "\" give the folder name \"" + run.name +
                   "\", which another run has, which is reserved, or which is too long; choose other labels");
}

}  // namespace

std::vector<StudyRun> combinations(const std::vector<Axis>& axes, const Assignments& common,
                                   const std::vector<std::string>& reserved) {
  std::vector<StudyRun> runs{{"", {}, common}};
  for (const Axis& axis : axes) {
    if (runs.size() * axis.values.size() > most_runs)
      throw InputError(fmt::format("Axes: more than {} runs", most_runs));
    std::vector<StudyRun> longer;
    std::size_t settings = 0;
    for (const StudyRun& run : runs)
      for (const AxisValue& value : axis.values) {
        StudyRun next = run;
        next.name += (run.name.empty() ? "" : "_") + file_name(value.label);
        next.labels.push_back(value.label);
        next.settings.insert(next.settings.end(), value.settings.begin(), value.settings.end());
        settings += next.settings.size();
        if (settings > most_settings)
          throw InputError(fmt::format("Axes: more than {} settings of all runs together", most_settings));
        if (next.name.size() > longest_name) refuse_run_name(next);
        longer.push_back(std::move(next));
      }
    runs = std::move(longer);
  }
  std::set<std::string> names(reserved.begin(), reserved.end());
  for (const StudyRun& run : runs)
    if (!names.insert(run.name).second) refuse_run_name(run);
  return runs;
}

}  // namespace ixos

#include "study/asked_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace ixos {
namespace {

using Kind = AskedQuantity::Kind;

constexpr double at_rest = 0.01;    ///< part of the largest kinetic energy below which a body has stopped
constexpr double near_end = 0.05;   ///< part of the window that a run may miss at its end
constexpr double same_time = 1e-9;  ///< part of a run's duration

/// A form: the words before the column, whether there is a column, a word after it, and a number after that.
struct Form {
  Kind kind;
  const char* before;
  const char* column;  ///< of a user, a given one, or empty: none
  const char* after;   ///< before a number; empty: there is none
  bool window;
  const char* shown;
};

const char* const any_column = "COLUMN";

const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {Kind::PeakTime, "time of peak", any_column, "", true, "time of peak COLUMN"},
      {Kind::FirstContact, "time of first contact", "contact_measure", "", true, "time of first contact"},
      {Kind::Detachment, "time of detachment", "contact_measure", "", true, "time of detachment"},
      {Kind::Arrest, "time of arrest", "kinetic_energy", "", true, "time of arrest"},
      {Kind::TimeAbove, "time of", any_column, "above", true, "time of COLUMN above LIMIT"},
      {Kind::TimeBelow, "time of", any_column, "below", true, "time of COLUMN below LIMIT"},
      {Kind::Peak, "peak", any_column, "", true, "peak COLUMN"},
      {Kind::Maximum, "maximum", any_column, "", true, "maximum COLUMN"},
      {Kind::Minimum, "minimum", any_column, "", true, "minimum COLUMN"},
      {Kind::Mean, "mean", any_column, "", true, "mean COLUMN"},
      {Kind::Rms, "rms", any_column, "", true, "rms COLUMN"},
      {Kind::Final, "final", any_column, "", false, "final COLUMN"},
      {Kind::Value, "value", any_column, "at", false, "value COLUMN at TIME"},
      {Kind::Work, "work", "external_work", "", true, "work"},
      {Kind::EnergyError, "energy error", "kinetic_energy", "", false, "energy error"},
      {Kind::Restitution, "restitution", any_column, "", true, "restitution COLUMN"}};
  return all;
}

bool to_number(const std::string& text, double& number) {
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size() && std::isfinite(number);
}

/// Returns the text with one blank between words.
std::string single_spaced(const std::string& text) {
  std::string result;
  for (char c : trimmed(text)) {
    const char read = c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
    if (read != ' ' || result.empty() || result.back() != ' ') result += read;
  }
  return result;
}

/// Matches a text without its window with a form, and fills in the column and the number.
bool matches(const std::string& text, const Form& form, std::string& column, double& number) {
  const std::string before = form.before;
  column = form.column;
  if (column != any_column) return text == before;
  if (text.rfind(before + " ", 0) != 0) return false;
  column = text.substr(before.size() + 1);
  const std::string after = form.after;
  if (after.empty()) return true;
  const auto place = column.rfind(" " + after + " ");
  if (place == std::string::npos || !to_number(column.substr(place + after.size() + 2), number)) return false;
  column.resize(place);
  return true;
}

}  // namespace

std::string quantity_forms() {
  std::string text;
  for (const Form& form : forms()) text += std::string("  ") + form.shown + (form.window ? " [FROM, TO]" : "") + "\n";
  return text + "A window [FROM, TO] may be left out.\n";
}

/// The chosen rows of a column.
struct AskedQuantity::Rows {
  std::vector<double> times, values;

  std::size_t largest() const {
    const auto found =
        std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    return static_cast<std::size_t>(found - values.begin());
  }
  /// Returns the mean in time of a function of the values, by the trapezoidal rule.
  template <class Function>
  double mean(const Function& function) const {
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
      sum += (times[i] - times[i - 1]) * (function(values[i]) + function(values[i - 1])) / 2;
    return sum / (times.back() - times.front());
  }
  /// Returns the time between two rows at which the straight line through their values has a value.
  double crossing(std::size_t i, double value) const {
    if (i == 0) return times[0];
    return times[i - 1] + (times[i] - times[i - 1]) * (value - values[i - 1]) / (values[i] - values[i - 1]);
  }
};

AskedQuantity::AskedQuantity(const std::string& text) : text_(single_spaced(text)), kind_(Kind::Peak) {
  std::string head = text_;
  const auto bracket = head.rfind('[');
  const bool has_window = bracket != std::string::npos && head.back() == ']';
  if (has_window) {
    const std::vector<std::string> ends = split(head.substr(bracket + 1, head.size() - bracket - 2), ',');
    if (ends.size() != 2 || !to_number(ends[0], from_) || !to_number(ends[1], to_))
      refuse("the window must be two times, as in [20, 50]");
    if (!(from_ < to_)) refuse("the start of the window must be less than its end");
    head = trimmed(head.substr(0, bracket));
  }
  for (const Form& form : forms()) {
    if (!matches(head, form, column_, number_)) continue;
    if (has_window && !form.window) refuse("this quantity takes no window");
    kind_ = form.kind;
    return;
  }
  refuse("this is no quantity. Quantities are:\n" + quantity_forms());
}

void AskedQuantity::refuse(const std::string& why) const { throw InputError("\"" + text_ + "\": " + why); }

void AskedQuantity::check_columns(const std::vector<std::string>& names) const {
  if (std::find(names.begin(), names.end(), column_) == names.end())
    refuse(no_such("column", column_, names, "The scene's history.csv has"));
}

void AskedQuantity::check_times(double from, double to) const {
  if (kind_ == Kind::Value && (number_ < from || number_ > to))
    refuse(fmt::format("the time {:.6g} is not within the run, from {:.6g} to {:.6g} T0", number_, from, to));
  if (std::isfinite(from_) && (from_ >= to || to_ <= from))
    refuse(fmt::format("the window holds no rows: the run is from {:.6g} to {:.6g} T0", from, to));
}

AskedQuantity::Rows AskedQuantity::rows(const RunHistory& run) const {
  if (!run.table().has(column_)) check_columns(run.table().names());
  const std::vector<double> times = run.times(column_);
  const std::vector<double>& values = run.table().column(column_);
  const double slack = same_time * (times.back() - times.front());
  if (std::isfinite(to_) && times.back() < to_ - near_end * (to_ - from_) - slack)
    refuse(fmt::format("the run ended at {:.6g} T0, before the end of the window", run.table().column("time").back()));
  Rows chosen;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < from_ - slack || times[i] > to_ + slack) continue;
    if (std::isnan(values[i])) continue;
    chosen.times.push_back(times[i]);
    chosen.values.push_back(values[i]);
  }
  if (chosen.times.empty()) refuse("the window holds no rows with a value of " + column_);
  if (chosen.times.size() < 2) refuse("the window holds one row only; a shorter step or a longer window gives more");
  return chosen;
}

double AskedQuantity::event(const RunHistory& run) const {
  const Rows all = rows(run);
  const std::size_t n = all.values.size();
  std::size_t i = 0;
  switch (kind_) {
    case Kind::TimeAbove:
    case Kind::TimeBelow:
      while (i < n && !(kind_ == Kind::TimeAbove ? all.values[i] > number_ : all.values[i] < number_)) ++i;
      if (i == n) refuse("the column never passes the limit");
      return all.crossing(i, number_);
    case Kind::FirstContact:
      while (i < n && !(all.values[i] > 0)) ++i;
      if (i == n) refuse("there is no contact");
      return i == 0 ? all.times[0] : (all.times[i] + all.times[i - 1]) / 2;
    case Kind::Detachment:
      i = n;
      while (i > 0 && !(all.values[i - 1] > 0)) --i;
      if (i == 0) refuse("there is no contact");
      if (i == n) refuse("the contact lasts to the end of the run");
      return (all.times[i] + all.times[i - 1]) / 2;
    default:  // arrest
      const double limit = at_rest * all.values[all.largest()];
      i = n;
      while (i > 0 && all.values[i - 1] < limit) --i;
      if (i == n) refuse("the body still moves at the end of the run");
      return all.crossing(i, limit);
  }
}

double AskedQuantity::value(const RunHistory& run) const {
  if (kind_ == Kind::EnergyError) {
    const Rows kinetic = rows(run);
    const double scale = kinetic.values[kinetic.largest()], error = run.energy_error();
    if (!(scale > 0) || std::isnan(error)) refuse("the run has no kinetic energy to compare with");
    return error / scale;
  }
  if (kind_ == Kind::Value) {
    const double found = interpolated(run.times(column_), run.table().column(column_), number_);
    if (std::isnan(found)) refuse("the run has no value at that time");
    return found;
  }
  if (kind_ >= Kind::TimeAbove) return event(run);
  const Rows all = rows(run);
  switch (kind_) {
    case Kind::Peak:
      return std::abs(all.values[all.largest()]);
    case Kind::PeakTime:
      return all.times[all.largest()];
    case Kind::Maximum:
      return *std::max_element(all.values.begin(), all.values.end());
    case Kind::Minimum:
      return *std::min_element(all.values.begin(), all.values.end());
    case Kind::Mean:
      return all.mean([](double value) { return value; });
    case Kind::Rms:
      return std::sqrt(all.mean([](double value) { return value * value; }));
    case Kind::Work:
      return all.values.back() - all.values.front();
    case Kind::Final:
      return all.values.back();
    default:
      break;
  }
  double before = 0, after = 0;  // restitution
  for (double value : all.values) {
    if (after == 0 && value * before >= 0)
      before = std::abs(value) > std::abs(before) ? value : before;
    else if (value * before < 0)
      after = std::abs(value) > std::abs(after) ? value : after;
    else
      break;  // the sign changed back
  }
  if (after == 0) refuse("the column does not change its sign");
  return std::abs(after / before);
}

}  // namespace ixos

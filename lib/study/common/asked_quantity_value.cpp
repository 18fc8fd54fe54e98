#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "study/common/asked_quantity.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

using Kind = AskedQuantity::Kind;

const char* const contact_column = "contact_measure";

/// Returns whether a quantity is the time at which something happens first.
bool is_first_event(Kind kind) {
  return kind == Kind::TimeAbove || kind == Kind::TimeBelow || kind == Kind::FirstContact;
}

/// Returns the difference below which times count as the same.
double slack(const std::vector<double>& times) { return tuning::same_time * (times.back() - times.front()); }

}  // namespace

/// The chosen rows of a column.
struct AskedQuantity::Rows {
  std::vector<double> times, values;

  template <class Value>
  std::size_t first_largest(const Value& value) const {
    const auto found =
        std::max_element(values.begin(), values.end(), [&](double a, double b) { return value(a) < value(b); });
    return static_cast<std::size_t>(found - values.begin());
  }
  std::size_t largest() const {
    return first_largest([](double value) { return std::abs(value); });
  }
  std::size_t maximum() const {
    return first_largest([](double value) { return value; });
  }
  std::size_t minimum() const {
    return first_largest([](double value) { return -value; });
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

/// Returns the rows in the window, whose end the run must have reached.
AskedQuantity::Rows AskedQuantity::rows(const RunHistory& run) const {
  if (!run.table().has(column_)) check_columns(run.table().names());
  const std::vector<double> times = run.times(column_);
  if (std::isfinite(to_) && times.back() < to_ - tuning::near_end * (to_ - from_) - slack(times))
    refuse(fmt::format("the run ended at {:.6g} T0, before the end of the window", run.table().column("time").back()));
  Rows chosen = rows_so_far(run);
  if (chosen.times.empty()) refuse("the window holds no rows with a value of " + column_);
  if (chosen.times.size() < 2) refuse("the window holds one row only; a shorter step or a longer window gives more");
  return chosen;
}

/// Returns the rows in the window, however few.
AskedQuantity::Rows AskedQuantity::rows_so_far(const RunHistory& run) const {
  if (!run.table().has(column_)) check_columns(run.table().names());
  const std::vector<double> times = run.times(column_);
  const std::vector<double>& values = run.table().column(column_);
  Rows chosen;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < from_ - slack(times) || times[i] > to_ + slack(times)) continue;
    if (std::isnan(values[i])) continue;
    chosen.times.push_back(times[i]);
    chosen.values.push_back(values[i]);
  }
  return chosen;
}

double AskedQuantity::event(const RunHistory& run) const {
  if (is_first_event(kind_)) {
    const Rows all = rows_so_far(run);
    const std::size_t n = all.values.size();
    const auto happened = [&](double value) {
      if (kind_ == Kind::FirstContact) return value > 0;
      return kind_ == Kind::TimeAbove ? value > number_ : value < number_;
    };
    std::size_t i = 0;
    while (i < n && !happened(all.values[i])) ++i;
    if (i == n || n < 2) {
      rows(run);  // throws if the run ended too early, or the window holds too few rows
      refuse(kind_ == Kind::FirstContact ? "there is no contact" : "the column never passes the limit");
    }
    if (kind_ != Kind::FirstContact) return all.crossing(i, number_);
    return i == 0 ? all.times[0] : (all.times[i] + all.times[i - 1]) / 2;
  }
  const Rows all = rows(run);
  const std::size_t n = all.values.size();
  std::size_t i = 0;
  switch (kind_) {
    case Kind::Detachment:
      i = n;
      while (i > 0 && !(all.values[i - 1] > 0)) --i;
      if (i == 0) refuse("there is no contact");
      if (i == n) refuse("the contact lasts to the end of the run");
      return (all.times[i] + all.times[i - 1]) / 2;
    default:  // arrest
      const double limit = tuning::at_rest * all.values[all.largest()];
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
      return all.values[all.maximum()];
    case Kind::Minimum:
      return all.values[all.minimum()];
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

/// Returns the time after which rows do not change the value as they stand.
double AskedQuantity::deciding_time(const RunHistory& run) const {
  if (kind_ == Kind::Value) return number_;
  if (kind_ >= Kind::TimeAbove) return event(run);
  const Rows all = rows(run);
  if (kind_ == Kind::Peak || kind_ == Kind::PeakTime) return all.times[all.largest()];
  if (kind_ == Kind::Maximum) return all.times[all.maximum()];
  if (kind_ == Kind::Minimum) return all.times[all.minimum()];
  return all.times.back();
}

ColumnHistory AskedQuantity::history(const RunHistory& run) const {
  ColumnHistory result;
  result.decided = deciding_time(run);
  const std::vector<double> times = run.times(column_);
  const std::vector<double>& values = run.table().column(column_);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isnan(values[i])) continue;
    result.times.push_back(times[i]);
    result.values.push_back(values[i]);
  }
  return result;
}

/// Returns whether the contact was released before the last row, and the value's time is before that. Forces that
/// follow are those of a free body.
bool AskedQuantity::is_decided_by_release(const RunHistory& run) const {
  const bool is_extreme = kind_ == Kind::Peak || kind_ == Kind::Maximum || kind_ == Kind::Minimum ||
                          kind_ == Kind::PeakTime || kind_ == Kind::Detachment;
  const bool is_of_contact = column_.rfind("contact_", 0) == 0 || column_.rfind("reaction_", 0) == 0;
  if (!is_extreme || !is_of_contact || !run.table().has(contact_column)) return false;
  const std::vector<double>&measure = run.table().column(contact_column), &times = run.table().column("time");
  std::size_t released = measure.size();
  while (released > 0 && measure[released - 1] == 0) --released;
  // The last row must be without contact, and one before it must have some.
  if (released == 0 || released == measure.size() || !(measure[released - 1] > 0)) return false;
  return deciding_time(run) <= times[released] + slack(times);
}

bool AskedQuantity::is_decided(const RunHistory& run) const {
  if (!run.table().has(column_) || kind_ == Kind::Final || kind_ == Kind::EnergyError) return false;
  const std::vector<double> times = run.times(column_);
  if (kind_ == Kind::Value) return times.back() >= number_ - slack(times);
  try {
    if (is_first_event(kind_)) return std::isfinite(event(run));
    if (std::isfinite(to_)) return times.back() >= to_ - slack(times);
    return is_decided_by_release(run);
  } catch (const InputError&) {
    return false;  // the event has not happened
  }
}

bool are_decided(const std::vector<AskedQuantity>& quantities, const RunHistory& run) {
  return std::all_of(quantities.begin(), quantities.end(),
                     [&](const AskedQuantity& quantity) { return quantity.is_decided(run); });
}

}  // namespace ixos

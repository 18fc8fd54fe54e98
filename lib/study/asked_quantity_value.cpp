#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/asked_quantity.hpp"

namespace ixos {
namespace {

constexpr double at_rest = 0.01;    ///< part of the largest kinetic energy below which a body has stopped
constexpr double near_end = 0.05;   ///< part of the window that a run may miss at its end
constexpr double same_time = 1e-9;  ///< part of a run's duration

}  // namespace

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

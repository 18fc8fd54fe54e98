#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "histories/catalogue.hpp"
#include "histories/monotone_knots.hpp"
#include "histories/quintic.hpp"

namespace ixos {
namespace {

void check(const std::vector<double>& times, const std::vector<double>& values) {
  if (times.size() < 2) throw InputError(fmt::format("the table has {} times; it needs at least 2", times.size()));
  if (values.size() != times.size())
    throw InputError(fmt::format("the table has {} times and {} values; it needs as many values as times", times.size(),
                                 values.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !std::isfinite(values[i]))
      throw InputError(
          fmt::format("entry {} of the table is ({}, {}); both numbers must be finite", i + 1, times[i], values[i]));
    if (i > 0 && times[i] <= times[i - 1])
      throw InputError(fmt::format("entry {} of the table: the times must increase, but {} follows {}", i + 1, times[i],
                                   times[i - 1]));
  }
}

class Tabulated : public TimeFunction {
 public:
  Tabulated(std::vector<double> times, std::vector<double> values)
      : times_(std::move(times)), values_(std::move(values)) {
    check(times_, values_);
  }

  TimeValue at(double time) const final {
    if (time >= first_time() - slack() && time <= last_time() + slack()) return inside(time);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  double first_time() const final { return times_.front(); }
  double last_time() const final { return times_.back(); }

 protected:
  /// Returns the values at a time of the table, or one beyond it by roundoff.
  virtual TimeValue inside(double time) const = 0;

  /// Returns the number of the interval that begins at the time or holds it.
  std::size_t interval(double time) const {
    const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    return static_cast<std::size_t>(above - times_.begin()) - 1;
  }
  double length(std::size_t i) const { return times_[i + 1] - times_[i]; }
  double slope(std::size_t i) const { return (values_[i + 1] - values_[i]) / length(i); }
  double slack() const { return 1e-9 * (last_time() - first_time()); }

  std::vector<double> times_, values_;
};

/// The derivatives at a knot are those of the parabola through the three values around it.
class QuinticTable final : public Tabulated {
 public:
  QuinticTable(std::vector<double> times, std::vector<double> values, bool monotone)
      : Tabulated(std::move(times), std::move(values)) {
    const std::size_t last = times_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      if (last == 1) {
        knots_.push_back({values_[i], slope(0), 0});
        continue;
      }
      // The parabola through the times m - 1, m and m + 1, in Newton's form.
      const std::size_t m = std::clamp<std::size_t>(i, 1, last - 1);
      const double half_curvature = (slope(m) - slope(m - 1)) / (times_[m + 1] - times_[m - 1]);
      const double rate = slope(m - 1) + half_curvature * ((times_[i] - times_[m - 1]) + (times_[i] - times_[m]));
      knots_.push_back({values_[i], rate, 2 * half_curvature});
    }
    if (monotone) make_monotone(times_, knots_);
  }

 private:
  TimeValue inside(double time) const override {
    const std::size_t i = interval(time);
    return quintic(knots_[i], knots_[i + 1], length(i), time - times_[i]);
  }

  std::vector<TimeValue> knots_;
};

class LinearTable final : public Tabulated {
 public:
  using Tabulated::Tabulated;
  Jumps jumps() const override {
    Jumps result{"Interpolation Linear", false, {}, "choose Interpolation Monotone"};
    for (std::size_t i = 1; i + 1 < times_.size(); ++i) {
      const double before = slope(i - 1), after = slope(i);
      // Three points on a line have slopes that differ by roundoff.
      if (std::abs(after - before) > 1e-9 * std::max(std::abs(before), std::abs(after)))
        result.times.push_back(times_[i]);
    }
    return result;
  }

 private:
  TimeValue inside(double time) const override {
    const std::size_t i = interval(time);
    return {values_[i] + (time - times_[i]) / length(i) * (values_[i + 1] - values_[i]), slope(i), 0};
  }
};

class StepTable final : public Tabulated {
 public:
  using Tabulated::Tabulated;
  Jumps jumps() const override {
    Jumps result{"Interpolation Step", true, {}, "choose Interpolation Monotone"};
    for (std::size_t i = 1; i < times_.size(); ++i)
      if (values_[i] != values_[i - 1]) result.times.push_back(times_[i]);
    return result;
  }

 private:
  /// Takes a time that misses the next one of the table by roundoff for that one, as times of a run are sums of steps.
  TimeValue inside(double time) const override {
    const std::size_t i = interval(time);
    const bool at_next = times_[i + 1] - time <= std::min(slack(), length(i) / 2);
    return {values_[at_next ? i + 1 : i], 0, 0};
  }
};

struct Parameters {
  std::vector<double> times, values;
  TableInterpolation interpolation = TableInterpolation::Monotone;
};

}  // namespace

std::shared_ptr<const TimeFunction> interpolated(std::vector<double> times, std::vector<double> values,
                                                 TableInterpolation interpolation) {
  if (interpolation == TableInterpolation::Linear)
    return std::make_shared<LinearTable>(std::move(times), std::move(values));
  if (interpolation == TableInterpolation::Step)
    return std::make_shared<StepTable>(std::move(times), std::move(values));
  return std::make_shared<QuinticTable>(std::move(times), std::move(values),
                                        interpolation == TableInterpolation::Monotone);
}

HistoryEntry table_history() {
  Options<Parameters> options;
  options
      .add("Times", &Parameters::times, "Times of the table [T0]. They must increase strictly and cover the whole run.",
           any_number())
      .add("Values", &Parameters::values, history_value("Values of the table, one for each of Times"), any_number())
      .choose("Interpolation", &Parameters::interpolation,
              {{"Monotone", TableInterpolation::Monotone},
               {"Unlimited", TableInterpolation::Unlimited},
               {"Linear", TableInterpolation::Linear},
               {"Step", TableInterpolation::Step}},
              "Curve between Values. Monotone and Unlimited are quintic splines, twice continuously differentiable. "
              "Monotone stays between the values of neighbouring times. Unlimited may pass beyond them. " +
                  history_jump("Linear is a straight line between neighbouring times. Step holds each value until the "
                               "next time. The rate or the value jumps there"));
  return {"Table", "Interpolation of a table.", "", options.list(), [options](const SceneNode& node) {
            Parameters p = options.read(node);
            return interpolated(std::move(p.times), std::move(p.values), p.interpolation);
          }};
}

}  // namespace ixos

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "histories/catalogue.hpp"
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

class Table final : public TimeFunction {
 public:
  Table(std::vector<double> times, const std::vector<double>& values) : times_(std::move(times)) {
    check(times_, values);
    const std::size_t last = times_.size() - 1;
    const auto length = [this](std::size_t i) { return times_[i + 1] - times_[i]; };
    const auto slope = [&](std::size_t i) { return (values[i + 1] - values[i]) / length(i); };
    for (std::size_t i = 0; i <= last; ++i) {
      if (last == 1) {
        knots_.push_back({values[i], slope(0), 0});
        continue;
      }
      // The parabola through the times m - 1, m and m + 1, in Newton's form.
      const std::size_t m = std::clamp<std::size_t>(i, 1, last - 1);
      const double half_curvature = (slope(m) - slope(m - 1)) / (times_[m + 1] - times_[m - 1]);
      const double rate = slope(m - 1) + half_curvature * ((times_[i] - times_[m - 1]) + (times_[i] - times_[m]));
      knots_.push_back({values[i], rate, 2 * half_curvature});
    }
  }

  TimeValue at(double time) const override {
    const double slack = 1e-9 * (last_time() - first_time());
    if (!(time >= first_time() - slack && time <= last_time() + slack)) {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      return {nan, nan, nan};
    }
    const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto i = static_cast<std::size_t>(above - times_.begin()) - 1;
    return quintic(knots_[i], knots_[i + 1], times_[i + 1] - times_[i], time - times_[i]);
  }
  double first_time() const override { return times_.front(); }
  double last_time() const override { return times_.back(); }

 private:
  std::vector<double> times_;
  std::vector<TimeValue> knots_;
};

struct Parameters {
  std::vector<double> times, values;
};

}  // namespace

std::shared_ptr<const TimeFunction> interpolated(std::vector<double> times, const std::vector<double>& values) {
  return std::make_shared<Table>(std::move(times), values);
}

HistoryEntry table_history() {
  Options<Parameters> options;
  options
      .add("Times", &Parameters::times, "Times of the table [T0]. They must increase strictly and cover the whole run.",
           any_number())
      .add("Values", &Parameters::values, history_value("Values of the table, one for each of Times"), any_number());
  return {"Table", "Quintic interpolation of a table, twice continuously differentiable.", "", options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return interpolated(p.times, p.values);
          }};
}

}  // namespace ixos

#include "histories/monotone_knots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ixos {
namespace {

/// Two neighbouring knots, to be changed.
struct Interval {
  double length;
  TimeValue &from, &to;

  double slope() const { return (to.value - from.value) / length; }
};

/// Calls visit(interval, index of its first knot).
template <class Visit>
void for_each_interval(const std::vector<double>& times, std::vector<TimeValue>& knots, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    visit(Interval{times[i + 1] - times[i], knots[i], knots[i + 1]}, i);
}

/// Returns how much of a total an end of an interval may have if the other end wants `other`: half of it or more.
double share(double total, double other) { return std::max(total / 2, total - other); }

void bound(double& x, double most) { x = std::clamp(x, -most, most); }

/// Sets rates against the slope of a neighbouring interval to zero, and at an interval without a slope all.
void orient(const Interval& interval) {
  const double slope = interval.slope();
  for (TimeValue* knot : {&interval.from, &interval.to}) {
    if (slope == 0) knot->acceleration = 0;
    if (slope == 0 || (knot->rate > 0) != (slope > 0)) knot->rate = 0;
  }
}

}  // namespace

void make_monotone(const std::vector<double>& times, std::vector<TimeValue>& knots) {
  for_each_interval(times, knots, [](const Interval& interval, std::size_t) { orient(interval); });

  const std::vector<TimeValue> oriented = knots;
  for_each_interval(times, knots, [&](const Interval& interval, std::size_t i) {
    const double total = 2.5 * std::abs(interval.slope());
    bound(interval.from.rate, share(total, std::abs(oriented[i + 1].rate)));
    bound(interval.to.rate, share(total, std::abs(oriented[i].rate)));
  });

  for_each_interval(times, knots, [](const Interval& interval, std::size_t) {
    double &first = interval.from.acceleration, &last = interval.to.acceleration;
    const double falls = 4 * std::abs(interval.from.rate) / interval.length;
    const double rises = 4 * std::abs(interval.to.rate) / interval.length;
    const bool up = interval.slope() > 0;
    first = up ? std::max(first, -falls) : std::min(first, falls);
    last = up ? std::min(last, rises) : std::max(last, -rises);
  });

  const std::vector<TimeValue> bent = knots;
  for_each_interval(times, knots, [&](const Interval& interval, std::size_t i) {
    const double sign = interval.slope() > 0 ? 1 : -1;
    const double rates = std::abs(interval.from.rate) + std::abs(interval.to.rate);
    const double total = std::max(0.0, (20 * std::abs(interval.slope()) - 8 * rates) / interval.length);
    // Accelerations of the other signs take nothing of the total.
    const double first = sign * bent[i].acceleration, last = -sign * bent[i + 1].acceleration;
    if (first > 0) bound(interval.from.acceleration, share(total, std::max(0.0, last)));
    if (last > 0) bound(interval.to.acceleration, share(total, std::max(0.0, first)));
  });
}

}  // namespace ixos

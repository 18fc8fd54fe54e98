#include "study/common/column_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "study/common/history_table.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

double slack(const ColumnHistory& column) { return tuning::same_time * (column.times.back() - column.times.front()); }

double largest_value(const ColumnHistory& column) {
  double largest = 0;
  for (std::size_t i = 0; i < column.times.size(); ++i)
    if (column.times[i] <= column.decided + slack(column)) largest = std::max(largest, std::abs(column.values[i]));
  return largest;
}

/// Returns the largest difference up to a time.
double largest_difference(const ColumnHistory& a, const ColumnHistory& b, double end) {
  const bool fewer = a.times.size() <= b.times.size();
  const ColumnHistory &rows = fewer ? a : b, &line = fewer ? b : a;
  if (std::min(rows.times.back(), line.times.back()) < end - slack(rows)) return unknown;
  double largest = 0;
  for (std::size_t i = 0; i < rows.times.size() && rows.times[i] <= end + slack(rows); ++i) {
    const double difference = std::abs(rows.values[i] - interpolated(line.times, line.values, rows.times[i]));
    if (std::isnan(difference)) return unknown;
    largest = std::max(largest, difference);
  }
  return largest;
}

}  // namespace

ColumnHistory scaled(ColumnHistory column, double factor) {
  for (double& value : column.values) value *= factor;
  return column;
}

double column_difference(const ColumnHistory& own, const ColumnHistory& other) {
  if (own.times.empty() || other.times.empty()) return unknown;
  const double first = std::min(own.decided, other.decided), last = std::max(own.decided, other.decided);
  const double scale = largest_value(own);
  const auto relative = [&](double end) {
    const double difference = largest_difference(own, other, end);
    return difference == 0 ? 0 : difference / scale;
  };
  if (!(last > first)) return relative(last);
  const double shift = (last - first) / (last - own.times.front());
  return std::min(relative(last), std::max(relative(first), shift));
}

}  // namespace ixos

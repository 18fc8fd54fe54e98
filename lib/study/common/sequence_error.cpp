#include "study/common/sequence_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Returns the order p of q = limit + C h^p through three points whose differences have the same sign; NaN if there is
/// none between 0 and twice the largest order.
double observed_order(const SequencePoint& a, const SequencePoint& b, const SequencePoint& c) {
  const double wanted = (a.value - b.value) / (b.value - c.value);
  // Rises with p from log(a/b) / log(b/c).
  const auto ratio = [&](double p) {
    return (std::pow(a.size / c.size, p) - std::pow(b.size / c.size, p)) / (std::pow(b.size / c.size, p) - 1);
  };
  double low = 1e-6, high = 2 * tuning::largest_order;
  if (!(wanted > ratio(low) && wanted < ratio(high))) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (ratio(middle) < wanted ? low : high) = middle;
  }
  return low;
}

bool same_sign(double a, double b) { return a * b > 0; }

/// Returns the power of the size with which the three finest points approach a limit, between `slowest`, also for
/// differences that grow, and 1; 1 if there are fewer points, or if they oscillate.
double power_of_fall(const std::vector<SequencePoint>& points) {
  const std::size_t n = points.size();
  if (n < 3) return 1;
  const SequencePoint &a = points[n - 3], &b = points[n - 2], &c = points[n - 1];
  if (!same_sign(a.value - b.value, b.value - c.value)) return 1;
  const double power = observed_order(a, b, c);
  if (std::isnan(power)) return std::abs(a.value - b.value) > std::abs(b.value - c.value) ? 1 : tuning::slowest;
  return std::clamp(power, tuning::slowest, 1.0);
}

/// Returns whether three coarser points confirm an order, and lowers the order to theirs.
bool confirms(const SequencePoint& a, const SequencePoint& b, const SequencePoint& c, double& order) {
  if (!same_sign(a.value - b.value, b.value - c.value)) return false;
  const double other = observed_order(a, b, c);
  if (!(std::abs(other - order) <= tuning::agreement * order)) return false;
  order = std::min(order, other);
  return true;
}

/// Fills in the limit and its order if there is one, and the reason in any case.
void extrapolate(const std::vector<SequencePoint>& points, SequenceErrors& result) {
  const std::size_t n = points.size();
  if (n < 3) {
    result.reason = "two sizes only";
    return;
  }
  const SequencePoint &a = points[n - 3], &b = points[n - 2], &c = points[n - 1];
  if (!same_sign(a.value - b.value, b.value - c.value)) {
    result.reason = "the differences change their sign";
    return;
  }
  double order = observed_order(a, b, c);
  if (!(order >= tuning::least_order && order <= tuning::largest_order)) {
    result.reason = "the differences do not fall as a power of the size does";
    return;
  }
  result.asymptotic = n > 3 && confirms(points[n - 4], a, b, order);
  order = result.asymptotic ? order : std::min(order, tuning::trusted_order);
  result.order = order;
  const double error = (b.value - c.value) / (std::pow(b.size / c.size, order) - 1);
  result.limit = c.value - error;
  result.limit_uncertainty = (result.asymptotic ? tuning::confirmed_part : tuning::single_part) * std::abs(error);
  result.reason =
      fmt::format(result.asymptotic ? "asymptotic, of order {:.2g}" : "of order {:.2g} by three sizes alone", order);
}

}  // namespace

SequenceErrors sequence_errors(const std::vector<SequencePoint>& points, bool may_fall_slowly) {
  if (points.size() < 2) throw std::invalid_argument("sequence_errors: fewer than two points");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].size > 0 && points[i].size < points[i - 1].size))
      throw std::invalid_argument("sequence_errors: the sizes do not fall");
  SequenceErrors result;
  const SequencePoint& finest = points.back();
  result.limit = finest.value;
  double largest = 0, magnitude = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double power = may_fall_slowly && i + 2 < points.size() ? tuning::power_of_earlier : 1;
    largest = std::max(largest,
                       std::abs(points[i].value - points[i - 1].value) * std::pow(finest.size / points[i].size, power));
    magnitude = std::max(magnitude, std::abs(points[i].value));
  }
  if (largest <= tuning::rounding * magnitude) {
    result.reason = "the size has no effect";
  } else {
    extrapolate(points, result);
    if (result.order == 0) {
      // The finest point's own error, if errors fall with the power that the last differences show.
      const double ratio = points[points.size() - 2].size / finest.size;
      const double power = may_fall_slowly ? power_of_fall(points) : 1;
      result.limit_uncertainty = tuning::bound_factor * largest / std::min(1.0, std::pow(ratio, power) - 1);
    }
  }
  result.errors = errors_against(points, result.limit, result.limit_uncertainty);
  return result;
}

std::vector<double> errors_against(const std::vector<SequencePoint>& points, double limit, double uncertainty) {
  std::vector<double> errors(points.size());
  double worst = 0;
  for (std::size_t i = points.size(); i-- > 0;) {
    worst = std::max(worst, std::abs(points[i].value - limit) + uncertainty);
    errors[i] = worst;
  }
  return errors;
}

double error_at(const std::vector<SequencePoint>& points, const SequenceErrors& errors, double size) {
  constexpr double same = 1 + 1e-9;
  if (points.empty() || size > points.front().size * same) return std::numeric_limits<double>::infinity();
  for (std::size_t i = points.size(); i-- > 0;)
    if (points[i].size * same >= size && (i + 1 == points.size() || points[i + 1].size * same < size)) {
      if (i + 1 < points.size() || size * same >= points[i].size) return errors.errors[i];
      const double order = errors.asymptotic ? errors.order : 1;
      return errors.errors[i] * std::pow(size / points[i].size, order);
    }
  return std::numeric_limits<double>::infinity();
}

}  // namespace ixos

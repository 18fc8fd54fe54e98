#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fem/quadrature.hpp"
#include "histories/time_function.hpp"

namespace ixos {
namespace {

class Check {
 public:
  Check(const TimeFunction& function, double from, double to, bool derivatives)
      : function_(function), from_(from), to_(to), derivatives_(derivatives) {}

  /// Throws if the function says that it jumps within the run.
  void smooth() const {
    const Jumps jumps = function_.jumps();
    std::vector<std::string> times;
    for (double time : jumps.times)
      if (time > from_ && time <= to_) times.push_back(fmt::format("{:.10g}", time));
    if (times.empty()) return;
    constexpr std::size_t most = 5;
    const std::string more = times.size() > most ? fmt::format(" and {} more", times.size() - most) : "";
    const std::string word = times.size() > 1 ? "times" : "time";
    if (times.size() > most) times.resize(most);
    throw InputError(fmt::format(
        "{} cannot drive a motion of a dynamic scheme: its {} jumps at the {} {}{}, where its {} is not defined; {}, "
        "or the scheme Static",
        jumps.choice, jumps.of_value ? "value" : "rate", word, fmt::join(times, ", "), more,
        jumps.of_value ? "rate" : "acceleration", jumps.remedy));
  }

  void finite() const {
    constexpr int intervals = 1000;
    double time = from_;
    double value = at(time).value;
    for (int k = 1; k <= intervals; ++k) {
      const double next_time = point(k, intervals);
      const double next = at(next_time).value;
      if ((value < 0 && next > 0) || (value > 0 && next < 0)) search(time, next_time, value < 0);
      time = next_time;
      value = next;
    }
  }

  /// Checks that `derivative` of the function is the derivative of its `primitive`.
  void consistent(double TimeValue::*primitive, double TimeValue::*derivative, const char* primitive_name,
                  const char* derivative_name) const {
    constexpr int parts = 50;
    // Lengthening parts: over equal ones a sine of just as many cycles would hide a wrong rate, all changes being zero.
    const auto time = [this](int k) { return point(k * (k + parts), 2 * parts * parts); };
    double lowest = at(from_).*primitive;
    double highest = lowest;
    for (int k = 0; k < parts; ++k)
      for (double xi : gauss_.points) {
        const double value = at(time(k) + xi * (time(k + 1) - time(k))).*primitive;
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    const double tolerance = 1e-6 * (highest - lowest) + 1e-11 * std::max(std::abs(lowest), std::abs(highest));
    for (int k = 0; k < parts; ++k) {
      const double start = time(k);
      const double end = time(k + 1);
      const double change = at(end).*primitive - at(start).*primitive;
      int halvings = most_halvings;
      // A piece is settled at a share of the tolerance so small that all of them together stay below it.
      const double sum = integral(start, end, primitive, derivative, tolerance / (2 * most_halvings), 40, halvings);
      if (!(std::abs(sum - change) <= tolerance))
        throw InputError(fmt::format(
            "the {0} is not the derivative of the {1}: from t = {2:.10g} to t = {3:.10g} the {1} changes by {4:.6g}, "
            "but the integral of the {0} is {5:.6g}",
            derivative_name, primitive_name, start, end, change, sum));
    }
  }

 private:
  /// Enough for a hundred kinks in a part; if a derivative is wrong everywhere, it bounds the work.
  static constexpr int most_halvings = 4096;

  /// Returns the time at the fraction part / whole of the run; its end exactly.
  double point(int part, int whole) const { return part == whole ? to_ : from_ + (to_ - from_) * part / whole; }

  /// Throws if the function is not finite.
  TimeValue at(double time) const {
    const TimeValue f = function_.at(time);
    const auto check = [time](const char* name, double number) {
      if (!std::isfinite(number)) throw InputError(fmt::format("the {} is not finite at t = {:.10g}", name, time));
    };
    check("value", f.value);
    if (derivatives_) check("rate", f.rate);
    if (derivatives_) check("acceleration", f.acceleration);
    return f;
  }

  /// Bisects to where the sign changes, which may be a pole; `rising` from negative to positive.
  void search(double low, double high, bool rising) const {
    for (int bisection = 0; bisection < 64; ++bisection) {
      const double middle = low + (high - low) / 2;
      (at(middle).value < 0) == rising ? low = middle : high = middle;
    }
  }

  /// Returns the integral of the derivative. Halves intervals until it equals the change of the primitive to
  /// `tolerance`, to a depth, and as long as `halvings` last.
  double integral(double start, double end, double TimeValue::*primitive, double TimeValue::*derivative,
                  double tolerance, int depth, int& halvings) const {
    double sum = 0;
    for (std::size_t i = 0; i < gauss_.points.size(); ++i)
      sum += (end - start) * gauss_.weights[i] * (at(start + gauss_.points[i] * (end - start)).*derivative);
    const double change = at(end).*primitive - at(start).*primitive;
    if (std::abs(sum - change) <= tolerance || depth == 0 || halvings == 0) return sum;
    --halvings;
    const double middle = start + (end - start) / 2;
    return integral(start, middle, primitive, derivative, tolerance, depth - 1, halvings) +
           integral(middle, end, primitive, derivative, tolerance, depth - 1, halvings);
  }

  const TimeFunction& function_;
  double from_, to_;
  bool derivatives_;
  Quadrature gauss_ = gauss_legendre_unit(8);
};

}  // namespace

void check_over(const TimeFunction& function, double from, double to, bool derivatives) {
  const Check check(function, from, to, derivatives);
  if (derivatives) check.smooth();
  check.finite();
  if (!derivatives) return;
  check.consistent(&TimeValue::value, &TimeValue::rate, "value", "rate");
  check.consistent(&TimeValue::rate, &TimeValue::acceleration, "rate", "acceleration");
}

void check_static_over(const TimeFunction& function, double from, double to) {
  const Check check(function, from, to, true);
  check.finite();
  if (function.jumps().times.empty()) check.consistent(&TimeValue::value, &TimeValue::rate, "value", "rate");
}

}  // namespace ixos

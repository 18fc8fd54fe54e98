/// Named histories in time, which drive a motion or scale a load.
#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace ixos {

/// Value and exact derivatives of a function of time: in some unit, in that per T0 and in that per T0^2.
struct TimeValue {
  double value = 0;
  double rate = 0;
  double acceleration = 0;
};

/// Where the value or the rate of a function jumps, and which choice of a scene makes it jump.
struct Jumps {
  std::string choice{};         ///< "Shape Linear"
  bool of_value = false;        ///< the value jumps, otherwise only the rate
  std::vector<double> times{};  ///< increasing [T0]
  std::string remedy{};         ///< what to choose, for a message: "choose Shape Cosine or Quintic"
};

/// A function of time, times in T0. At jumps of a ramp or its derivatives, the values are those from the right.
class TimeFunction {
 public:
  virtual ~TimeFunction() = default;

  /// Returns the values at `time`; NaN or infinity if the function is not defined there. Never throws.
  virtual TimeValue at(double time) const = 0;
  /// Returns the span on which the function is defined: for a table its first and last time.
  virtual double first_time() const { return -std::numeric_limits<double>::infinity(); }
  virtual double last_time() const { return std::numeric_limits<double>::infinity(); }
  /// Returns the time at which a ramp has reached its end, start + length; -infinity for all other functions.
  virtual double ramp_end() const { return -std::numeric_limits<double>::infinity(); }
  /// Returns where the value or the rate jumps; no times if neither does, or if the function does not know.
  virtual Jumps jumps() const { return {}; }
};

/// s(tau), which grows from 0 at tau = 0 to 1 at tau = 1.
enum class RampShape {
  Linear,  ///< tau
  Cosine,  ///< (1 - cos(pi tau)) / 2: the rate is continuous
  Quintic  ///< 10 tau^3 - 15 tau^4 + 6 tau^5: the acceleration too
};

/// Returns a function of the program's own: f(t) returns value, rate and acceleration; a load needs the value only. It
/// is called on every rank and must return the same there, and must not throw. The value and the rate of a motion must
/// be continuous, and the rates those of the value: check_over() tests that.
std::shared_ptr<const TimeFunction> function_of_time(std::function<TimeValue(double)> f);

/// Returns the function that is `value` at all times.
std::shared_ptr<const TimeFunction> constant(double value);

/// Returns amplitude s((t - start) / length), zero before `start` and constant after start + length. With length 0 the
/// value jumps at `start` and the rate is zero throughout. As a motion a jump has no velocity and a Linear ramp no
/// acceleration at its ends: check_over refuses both within a run. Throws InputError unless length is finite and at
/// least 0.
std::shared_ptr<const TimeFunction> value_ramp(double amplitude, double start, double length, RampShape shape);

/// Returns the function whose rate grows like that from 0 to `rate`; the value is its integral, zero until `start`. For
/// Cosine, with t counted from `start`, V the rate and t_r the length: u(t) = V (t / 2 - t_r / (2 pi) sin(pi t / t_r))
/// for t < t_r and V (t - t_r / 2) from then on, as for every shape. With length 0 the rate jumps at `start`, which
/// check_over refuses as a motion within a run. Throws InputError unless length is finite and at least 0.
std::shared_ptr<const TimeFunction> rate_ramp(double rate, double start, double length, RampShape shape);

/// Returns offset + amplitude sin(2 pi frequency t + phase); the frequency in cycles per T0, the phase in rad.
std::shared_ptr<const TimeFunction> sine(double offset, double amplitude, double frequency, double phase);

/// The curve between the points of a table.
enum class TableInterpolation {
  Monotone,   ///< Unlimited with its derivatives limited: no value leaves the range of its neighbours
  Unlimited,  ///< quintic Hermite polynomials whose derivatives follow from neighbouring values
  Linear,     ///< straight lines: the rate jumps
  Step        ///< each value until the next time: the value jumps
};

/// Returns a function that interpolates a table.
/// - Unlimited: piecewise quintic Hermite polynomials, twice continuously differentiable. The derivatives at a time are
///   those of the parabola through its value and both neighbours', at the ends those of the parabola through the last
///   three; two points make a straight line. A parabola is reproduced.
/// - Monotone: the same with the derivatives that make_monotone() limits, twice continuously differentiable, too. It is
///   Unlimited where that curve is sure to rise or fall with the values.
/// - Linear and Step have the rates from the right, and accelerations of zero.
///
/// Outside the table all is NaN, except that times beyond an end by at most 1e-9 of the span count as inside, as the
/// last time of a run carries roundoff. Throws InputError unless there are at least two times, finite and strictly
/// increasing, and as many values, finite.
std::shared_ptr<const TimeFunction> interpolated(std::vector<double> times, std::vector<double> values,
                                                 TableInterpolation interpolation = TableInterpolation::Monotone);

/// Units of the argument and of the value of expressions.
struct ExpressionUnits {
  double time = 1;   ///< [T0]
  double value = 1;  ///< [L0 for a motion]
};

/// Returns a function of muParser expressions in the variable t, with the constants _pi and _e. A load needs the value
/// only: an empty `rate` or `acceleration` gives 0. Evaluation stores t in the object: use it from one thread at a
/// time. Throws InputError, quoting the expression and muParser's message (positions count from 0), for one that is
/// malformed, uses an unknown name, assigns, or is several separated by commas.
std::shared_ptr<const TimeFunction> expression(const std::string& value, const std::string& rate,
                                               const std::string& acceleration, const ExpressionUnits& units = {});

/// Checks whether a load can follow the function from `from` to `to` (finite, from <= to) or, with `derivatives`, a
/// motion of a dynamic scheme. Throws InputError naming
/// - for a motion, the times after `from` and up to `to` at which the function says that it jumps (see jumps());
/// - a time at which the value (or a derivative, for a motion) is not finite, of 1001 equally spaced ones and those at
///   which the value changes its sign, to the last bit: so poles of odd order are found, those of even order by chance;
/// - for a motion, one of 50 intervals over which the integral of the rate is not the change of the value, or that of
///   the acceleration not the change of the rate. The tolerance is 1e-6 of the range of the value (of the rate) over
///   the run plus roundoff. Derivatives may jump: the quadrature halves intervals around kinks.
/// The value and the rate of a motion must not jump.
void check_over(const TimeFunction& function, double from, double to, bool derivatives);

/// Checks whether a motion of the scheme Static can follow the function, as check_over() does. Its rate may jump, and
/// its acceleration need not be the derivative of the rate. Its value may jump where the function says so.
void check_static_over(const TimeFunction& function, double from, double to);

}  // namespace ixos

/// A history that the program sets while it runs.
#pragma once
#include "base/record.hpp"
#include "histories/time_function.hpp"

namespace ixos {

/// A function of time on one interval, which the caller sets as often as it likes: before each step, and again before a
/// step is repeated. Coupled programs exchange boundary data in this way. Between the two ends it is the quintic
/// Hermite polynomial of their values, rates and accelerations, so steps within the interval see an exact motion.
class Waveform final : public TimeFunction {
 public:
  /// Begins as the constant `value`, defined at all times until the first set().
  explicit Waveform(double value = 0) { first_.value = last_.value = value; }

  /// Sets the function on [from, to]. A motion is continuous if `first` is the value that it had at `from`. Throws
  /// InputError unless all numbers are finite and from < to.
  void set(double from, const TimeValue& first, double to, const TimeValue& last);

  /// Outside the interval, but for 1e-9 of its length, all is NaN: a step that leaves the interval fails.
  TimeValue at(double time) const override;
  const TimeValue& last() const { return last_; }  ///< at the end of the interval

  /// Writes or reads the interval and its ends, for checkpoints and snapshots.
  void transfer(Record& record);

 private:
  double from_ = 0, to_ = 0;  ///< equal before the first set()
  TimeValue first_, last_;
};

}  // namespace ixos

#include "model/time_function.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace ixos {
namespace {

class Constant final : public TimeFunction {
 public:
  explicit Constant(double value) : value_(value) {}
  TimeValue at(double) const override { return {value_, 0, 0}; }

 private:
  double value_;
};

class Sine final : public TimeFunction {
 public:
  Sine(double offset, double amplitude, double frequency, double phase)
      : offset_(offset), amplitude_(amplitude), omega_(2 * M_PI * frequency), phase_(phase) {}

  TimeValue at(double time) const override {
    const double sin = amplitude_ * std::sin(omega_ * time + phase_);
    const double cos = amplitude_ * std::cos(omega_ * time + phase_);
    return {offset_ + sin, omega_ * cos, -omega_ * omega_ * sin};
  }

 private:
  double offset_, amplitude_, omega_, phase_;
};

/// Growth s(tau) for 0 <= tau <= 1, its integral from 0 (1/2 at tau = 1 for every shape) and its derivatives.
struct Growth {
  double integral, value, slope, curvature;
};

Growth growth(RampShape shape, double tau) {
  const double square = tau * tau;
  const double rest = 1 - tau;
  if (shape == RampShape::Linear) return {square / 2, tau, 1, 0};
  if (shape == RampShape::Cosine) {
    const double sin = std::sin(M_PI * tau);
    const double cos = std::cos(M_PI * tau);
    return {tau / 2 - sin / (2 * M_PI), (1 - cos) / 2, M_PI / 2 * sin, M_PI * M_PI / 2 * cos};
  }
  return {square * square * (2.5 - 3 * tau + square), square * tau * (10 - 15 * tau + 6 * square),
          30 * square * rest * rest, 60 * tau * rest * (rest - tau)};
}

class Ramp : public TimeFunction {
 public:
  Ramp(double amplitude, double start, double length, RampShape shape)
      : amplitude_(amplitude), start_(start), length_(length), shape_(shape) {
    if (!(std::isfinite(length) && length >= 0))
      throw InputError(fmt::format("the ramp has length {}; it must be at least 0", length));
  }
  double ramp_end() const override { return start_ + length_; }

 protected:
  double amplitude_, start_, length_;
  RampShape shape_;
};

class ValueRamp final : public Ramp {
 public:
  using Ramp::Ramp;
  TimeValue at(double time) const override {
    if (time < start_) return {};
    if (time >= ramp_end()) return {amplitude_, 0, 0};
    const Growth s = growth(shape_, (time - start_) / length_);
    return {amplitude_ * s.value, amplitude_ * s.slope / length_, amplitude_ * s.curvature / (length_ * length_)};
  }
};

class RateRamp final : public Ramp {
 public:
  using Ramp::Ramp;
  TimeValue at(double time) const override {
    if (time < start_) return {};
    if (time >= ramp_end()) return {amplitude_ * (time - start_ - length_ / 2), amplitude_, 0};
    const Growth s = growth(shape_, (time - start_) / length_);
    return {amplitude_ * length_ * s.integral, amplitude_ * s.value, amplitude_ * s.slope / length_};
  }
};

}  // namespace

std::shared_ptr<const TimeFunction> constant(double value) { return std::make_shared<Constant>(value); }

std::shared_ptr<const TimeFunction> value_ramp(double amplitude, double start, double length, RampShape shape) {
  return std::make_shared<ValueRamp>(amplitude, start, length, shape);
}

std::shared_ptr<const TimeFunction> rate_ramp(double rate, double start, double length, RampShape shape) {
  return std::make_shared<RateRamp>(rate, start, length, shape);
}

std::shared_ptr<const TimeFunction> sine(double offset, double amplitude, double frequency, double phase) {
  return std::make_shared<Sine>(offset, amplitude, frequency, phase);
}

}  // namespace ixos

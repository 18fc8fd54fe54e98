// Ramps of the value and of the rate.
#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "histories/catalogue.hpp"

namespace ixos {
namespace {

constexpr const char* longer = "choose a Length above 0";

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
  Jumps jumps() const override {
    if (amplitude_ == 0) return {};
    if (length_ == 0) return {"a ramp of Length 0", true, {start_}, longer};
    if (shape_ != RampShape::Linear) return {};
    return {"Shape Linear", false, {start_, ramp_end()}, "choose Shape Cosine or Quintic"};
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
  Jumps jumps() const override {
    if (amplitude_ == 0 || length_ > 0) return {};
    return {"a ramp of Length 0", false, {start_}, longer};
  }
};

struct Parameters {
  double height = 0;  ///< value or rate at the end
  double start = 0, length = 0;
  RampShape shape = RampShape::Quintic;
};
struct RateParameters : Parameters {
  RateParameters() { shape = RampShape::Cosine; }
};

Options<Parameters>::Words<RampShape> shapes() {
  return {{"Linear", RampShape::Linear}, {"Cosine", RampShape::Cosine}, {"Quintic", RampShape::Quintic}};
}

}  // namespace

std::shared_ptr<const TimeFunction> value_ramp(double amplitude, double start, double length, RampShape shape) {
  return std::make_shared<ValueRamp>(amplitude, start, length, shape);
}

std::shared_ptr<const TimeFunction> rate_ramp(double rate, double start, double length, RampShape shape) {
  return std::make_shared<RateRamp>(rate, start, length, shape);
}

HistoryEntry ramp_history() {
  Options<Parameters> options;
  options.require("Value", &Parameters::height, history_value("Value reached at Start + Length"), any_number())
      .add("Start", &Parameters::start, "Time at which the ramp starts [T0].", any_number())
      .require("Length", &Parameters::length,
               history_jump("Duration of the ramp [T0]. With 0 the value jumps at Start"), at_least(0))
      .choose("Shape", &Parameters::shape, shapes(),
              history_jump("Shape of the ramp. Cosine has a continuous rate, Quintic also a continuous acceleration. "
                           "With Linear the rate jumps at both ends of the ramp"));
  return {"Ramp", "Rises from 0 to Value, then stays constant.", "", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return value_ramp(p.height, p.start, p.length, p.shape);
          }};
}

HistoryEntry rate_ramp_history() {
  Options<RateParameters> options;
  options
      .require("Rate", &RateParameters::height,
               "Rate reached at Start + Length [L0/T0 for a motion, 1/T0 for a load, rad/T0 for an angle].",
               any_number())
      .add("Start", &RateParameters::start, "Time at which the ramp of the rate starts [T0].", any_number())
      .require("Length", &RateParameters::length,
               history_jump("Duration of the ramp of the rate [T0]. With 0 the rate jumps at Start"), at_least(0))
      .choose("Shape", &RateParameters::shape, shapes(), "Shape of the ramp of the rate.");
  return {"Rate Ramp",
          "The rate rises from 0 to Rate, then stays constant. The value is the integral of the rate, 0 until Start.",
          "", options.list(), [options](const SceneNode& node) {
            const RateParameters p = options.read(node);
            return rate_ramp(p.height, p.start, p.length, p.shape);
          }};
}

}  // namespace ixos

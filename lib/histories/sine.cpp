#include <cmath>

#include "histories/catalogue.hpp"

namespace ixos {
namespace {

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

struct Parameters {
  double offset = 0, amplitude = 1, frequency = 0, phase = 0;
};

}  // namespace

std::shared_ptr<const TimeFunction> sine(double offset, double amplitude, double frequency, double phase) {
  return std::make_shared<Sine>(offset, amplitude, frequency, phase);
}

HistoryEntry sine_history() {
  Options<Parameters> options;
  options.add("Offset", &Parameters::offset, history_value("Mean value"), any_number())
      .add("Amplitude", &Parameters::amplitude, history_value("Amplitude"), any_number())
      .require("Frequency", &Parameters::frequency, "Number of cycles per time [1/T0].", greater_than(0))
      .add("Phase", &Parameters::phase, "Phase [rad].", any_number());
  return {"Sine", "Offset + Amplitude sin(2 pi Frequency t + Phase).", "", options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return sine(p.offset, p.amplitude, p.frequency, p.phase);
          }};
}

}  // namespace ixos

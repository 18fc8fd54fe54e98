#include <cmath>

#include "histories/catalogue.hpp"

namespace ixos {
namespace {

struct Parameters {
  double time = 0;
};

class Decay final : public TimeFunction {
 public:
  explicit Decay(double time) : time_(time) {}
  TimeValue at(double time) const override {  // value, rate, acceleration
    const double value = std::exp(-time / time_);
    return {value, -value / time_, value / (time_ * time_)};
  }

 private:
  double time_;
};

}  // namespace

HistoryEntry decay_history() {
  Options<Parameters> options;
  options.require("Time", &Parameters::time, "Time in which the value falls by a factor e [T0].", greater_than(0));
  return {"Decay", "exp(-t/Time).", "", options.list(),
          [options](const SceneNode& node) { return std::make_shared<Decay>(options.read(node).time); }};
}

}  // namespace ixos

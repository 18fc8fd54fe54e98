#include "histories/shifted.hpp"

#include <utility>

namespace ixos {
namespace {

class Shifted final : public TimeFunction {
 public:
  Shifted(std::shared_ptr<const TimeFunction> function, double time, double value)
      : function_(std::move(function)), time_(time), value_(value) {}
  TimeValue at(double time) const override {
    TimeValue result = function_->at(time - time_);
    result.value += value_;
    return result;
  }
  double first_time() const override { return function_->first_time() + time_; }
  double last_time() const override { return function_->last_time() + time_; }
  double ramp_end() const override { return function_->ramp_end() + time_; }
  Jumps jumps() const override {
    Jumps jumps = function_->jumps();
    for (double& time : jumps.times) time += time_;
    return jumps;
  }

 private:
  std::shared_ptr<const TimeFunction> function_;
  double time_, value_;
};

}  // namespace

std::shared_ptr<const TimeFunction> shifted(std::shared_ptr<const TimeFunction> function, double time, double value) {
  return std::make_shared<Shifted>(std::move(function), time, value);
}

}  // namespace ixos

#include "scene/step_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// Multiples of `interval` from `start`: the next one after `time`; one that rounding has just missed counts as
/// reached.
double next_multiple(double start, double interval, double time, double slack) {
  return start + (std::floor((time - start) / interval + slack / interval) + 1) * interval;
}

}  // namespace

bool StepControl::done(double time) const {
  return !(options_.final_time - time > 1e-3 * std::min(length_, options_.time_step));
}

/// To the next time that must be hit.
double StepControl::room(double time) const {
  const double slack = 1e-3 * std::min(length_, options_.time_step);
  double end = options_.final_time;
  if (!options_.adaptive.on) end = std::min(end, next_multiple(options_.initial_time, options_.time_step, time, slack));
  for (double interval : options_.output_intervals)
    end = std::min(end, next_multiple(options_.initial_time, interval, time, slack));
  return end - time;
}

double StepControl::next(double time, const std::function<double(double)>& stable) const {
  const double left = room(time);
  double step = length_ > left * (1 - 1e-9) ? left : length_;
  if (options_.adaptive.on && step < left && left < 2 * step) step = left / 2;
  if (!stable) return step;
  const double longest = stable(step);
  return longest < step ? step / std::ceil(step / longest) : step;
}

void StepControl::succeeded() {
  if (options_.adaptive.on) return;
  cuts_ = std::max(cuts_ - 1, 0);
  length_ = cuts_ == 0 ? options_.time_step : std::min(2 * length_, options_.time_step);
}

bool StepControl::cut(double failed_step) {
  if (cuts_ >= options_.maximum_cuts || failed_step / 2 < options_.minimum_step) return false;
  ++cuts_;
  length_ = failed_step / 2;
  rejected_ = true;
  return true;
}

bool StepControl::accepts(double dt, const StepJudgement& judgement) {
  const AdaptiveOptions& asked = options_.adaptive;
  judgement_ = judgement;
  double factor = asked.growth, ratio_factor = asked.growth;
  const bool good = judgement.error <= (asked.tolerance > 0 ? asked.tolerance : judgement.error) &&
                    judgement.gap_ratio <= (asked.gap_ratio > 0 ? asked.gap_ratio : judgement.gap_ratio);
  // The share of the length is aimed at, not the tolerance itself.
  const double aim = asked.tolerance * asked.safety * asked.safety * asked.safety;
  const double error = asked.tolerance > 0 ? std::max(judgement.error / aim, 1e-10) : 0;
  if (error > 0) {
    factor = std::pow(error, good && last_error_ > 0 ? -0.7 / 3 : -1.0 / 3);
    if (good && last_error_ > 0) factor *= std::pow(last_error_, 0.4 / 3);
  }
  if (asked.gap_ratio > 0 && judgement.gap_ratio > 1)
    ratio_factor = asked.safety * std::log(asked.gap_ratio) / std::log(judgement.gap_ratio);
  factor = std::clamp(std::min(factor, ratio_factor), 0.1, good && rejected_ ? 1.0 : asked.growth);
  // A step that was shortened for a time of output says nothing against the length that was wanted.
  const double wanted = std::min(factor * dt, options_.maximum_step);
  length_ = good && dt < length_ * (1 - 1e-9) && factor >= 1 ? std::max(length_, wanted) : wanted;
  if (good) {
    last_error_ = error;
    cuts_ = std::max(cuts_ - 1, 0);
  }
  rejected_ = !good;
  return good;
}

bool StepControl::exhausted(std::string& why) const {
  const double least = std::max(options_.minimum_step, 1e-10 * options_.time_step);
  if (length_ >= least) return false;
  why = fmt::format(
      "a step of {:.3g} T0 would be needed, and {:.3g} is the least allowed; the last had a local error of {:.3g} L0 "
      "and "
      "a gap ratio of {:.3g}",
      length_, least, judgement_.error, judgement_.gap_ratio);
  return true;
}

int time_points(double gap_ratio) { return gap_ratio <= 1.4 ? 5 : gap_ratio <= 2 ? 8 : 16; }

}  // namespace ixos

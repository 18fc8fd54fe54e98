#include "time/step_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ixos {
namespace {

/// The rounding of a time: two times that are nearer to each other are the same.
double slack(double interval, double time) {
  return 1e-8 * interval + 8 * std::numeric_limits<double>::epsilon() * std::abs(time);
}

/// Multiples of `interval` from `start`: the next one after `time`.
double next_multiple(double start, double interval, double time) {
  return start + (std::floor((time - start + slack(interval, time)) / interval) + 1) * interval;
}

}  // namespace

StepControl::StepControl(const StepControlOptions& options)
    : options_(options), length_(std::min(options.time_step, options.maximum_step)) {}

bool StepControl::done(double time) const {
  // A step longer than the run is cut to the run: it must not make the run look done.
  const double step = std::min(options_.time_step, options_.final_time - options_.initial_time);
  return !(options_.final_time - time > slack(step, options_.final_time));
}

/// To the next time that must be hit.
double StepControl::room(double time) const {
  double end = options_.final_time;
  if (!options_.adaptive.on) end = std::min(end, next_multiple(options_.initial_time, options_.time_step, time));
  for (double interval : options_.output_intervals)
    end = std::min(end, next_multiple(options_.initial_time, interval, time));
  return end - time;
}

double StepControl::next(double time, const std::function<double(double)>& stable) const {
  const double left = room(time);
  double step = length_ > left * (1 + 1e-9) ? left : length_;
  if (options_.adaptive.on && step < left && left < 2 * step) step = left / 2;
  if (!stable) return step;
  const double longest = stable(step);
  return longest > 0 && longest < step ? step / std::ceil(step / longest) : std::min(step, longest);
}

void StepControl::succeeded() {
  if (options_.adaptive.on) return;
  cuts_ = std::max(cuts_ - 1, 0);
  length_ = cuts_ == 0 ? options_.time_step : std::min(2 * length_, options_.time_step);
}

bool StepControl::cut(double failed_step) {
  const bool allowed = options_.adaptive.on ? failed_step / 2 >= least() : cuts_ < options_.maximum_cuts;
  if (!allowed || failed_step / 2 < options_.minimum_step) return false;
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
  const bool shortened = dt < length_ * (1 - 1e-9);
  const double wanted = std::min(factor * dt, options_.maximum_step);
  length_ = good && shortened && factor >= 1 ? std::max(length_, wanted) : wanted;
  if (good) {
    // The error of a step that was shortened, or in which nothing happens, says little of the next.
    if (!shortened) last_error_ = std::max(error, 1e-4);
    cuts_ = std::max(cuts_ - 1, 0);
  }
  rejected_ = !good;
  return good;
}

double StepControl::least() const { return std::max(options_.minimum_step, 1e-10 * options_.time_step); }

bool StepControl::exhausted(std::string& why) const {
  if (length_ >= least()) return false;
  why = fmt::format(
      "the next step would have to be {:.3g} T0 long, but the shortest one allowed is {:.3g} T0; the last step had",
      length_, least());
  if (options_.adaptive.tolerance > 0) why += fmt::format(" a local error of {:.3g} L0", judgement_.error);
  if (options_.adaptive.gap_ratio > 0)
    why += fmt::format("{} a gap ratio of {:.3g}", options_.adaptive.tolerance > 0 ? " and" : "", judgement_.gap_ratio);
  return true;
}

void StepControl::transfer(Record& record) {
  const Record::Section section(record, "step control");
  record.number("length", length_);
  record.number("cuts", cuts_);
  record.number("last error", last_error_);
  record.number("rejected", rejected_);
  record.number("judged error", judgement_.error);
  record.number("judged gap ratio", judgement_.gap_ratio);
  if (!(length_ > 0 && std::isfinite(length_) && cuts_ >= 0))
    throw InputError(
        fmt::format("the checkpoint has a step length of {} after {} cuts, which is not allowed", length_, cuts_));
}

int time_points(double gap_ratio) { return gap_ratio <= 1.4 ? 5 : gap_ratio <= 2 ? 8 : 16; }

}  // namespace ixos

#include "scene/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

bool StepControl::done(double time) const { return !(options_.final_time - time > 1e-3 * length_); }

double StepControl::next(double time) const {
  const double h = options_.time_step;
  // The next time of the grid; one that rounding has just missed counts as reached.
  const double count = std::floor((time - options_.initial_time) / h + 1e-3 * length_ / h) + 1;
  const double room = std::min(options_.initial_time + count * h, options_.final_time) - time;
  return length_ > room * (1 + 1e-9) ? room : length_;
}

void StepControl::succeeded() {
  cuts_ = std::max(cuts_ - 1, 0);
  length_ = cuts_ == 0 ? options_.time_step : std::min(2 * length_, options_.time_step);
}

bool StepControl::cut(double failed_step) {
  if (cuts_ >= options_.maximum_cuts || failed_step / 2 < options_.minimum_step) return false;
  ++cuts_;
  length_ = failed_step / 2;
  return true;
}

}  // namespace ixos

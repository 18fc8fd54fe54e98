#include "scene/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

double StepControl::next(double time) const {
  const double h = options_.time_step;
  // The next time of the grid; one that rounding has just missed counts as reached.
  const double count = std::floor((time - options_.initial_time) / h + 1e-3) + 1;
  const double room = std::min(options_.initial_time + count * h, options_.final_time) - time;
  return length_ > room * (1 + 1e-9) ? room : length_;
}

void StepControl::succeeded() {
  if (cuts_ == 0) return;
  --cuts_;
  length_ = std::ldexp(options_.time_step, -cuts_);
}

bool StepControl::cut(double failed_step) {
  if (cuts_ >= options_.maximum_cuts || failed_step / 2 < options_.minimum_step) return false;
  do {
    ++cuts_;
    length_ = std::ldexp(options_.time_step, -cuts_);
  } while (length_ > 0.75 * failed_step && cuts_ < options_.maximum_cuts);
  return length_ < failed_step;
}

}  // namespace ixos

#include "run/front_watch.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

void FrontWatch::row(long steps, double measure) {
  if (front_.zone == 0 || std::isnan(measure)) return;
  constexpr double at_rest = 0.01, pi = 3.14159265358979323846;
  const double change = std::abs(measure - measure_), larger = std::max(measure, measure_);
  if (steps > steps_ && std::min(measure, measure_) > 0 && change < 0.5 * larger) {
    const double rim = dimension_ == 2 ? 1 : 2 * std::sqrt(pi * larger);
    const double way = change / rim / static_cast<double>(steps - steps_);
    if (way > at_rest * front_.zone) ++front_.moving;
    if (way > front_.zone) {
      ++front_.fast;
      front_.way += way;
    }
  }
  steps_ = steps;
  measure_ = measure;
}

FrontSteps FrontWatch::front() const {
  FrontSteps result = front_;
  if (result.fast > 0) result.way /= static_cast<double>(result.fast);
  return result;
}

void FrontWatch::transfer(Record& record) {
  const Record::Section section(record, "front");
  record.number("way", front_.way);
  record.number("moving", front_.moving);
  record.number("fast", front_.fast);
  record.number("steps", steps_);
  record.number("measure", measure_);
}

}  // namespace ixos

#include "histories/waveform.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "histories/quintic.hpp"

namespace ixos {
namespace {

bool is_finite(const TimeValue& x) {
  return std::isfinite(x.value) && std::isfinite(x.rate) && std::isfinite(x.acceleration);
}

}  // namespace

void Waveform::set(double from, const TimeValue& first, double to, const TimeValue& last) {
  if (!(std::isfinite(from) && std::isfinite(to) && from < to))
    throw InputError(fmt::format("a waveform from t = {} to {} T0: the times must increase", from, to));
  if (!is_finite(first) || !is_finite(last))
    throw InputError(fmt::format("a waveform from t = {} to {} T0 has a value that is not finite", from, to));
  from_ = from;
  to_ = to;
  first_ = first;
  last_ = last;
}

TimeValue Waveform::at(double time) const {
  if (from_ == to_) return last_;
  const double slack = 1e-9 * (to_ - from_);
  if (time >= from_ - slack && time <= to_ + slack) return quintic(first_, last_, to_ - from_, time - from_);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan};
}

void Waveform::transfer(Record& record) {
  record.number("from", from_);
  record.number("to", to_);
  record.number("first value", first_.value);
  record.number("first rate", first_.rate);
  record.number("first acceleration", first_.acceleration);
  record.number("last value", last_.value);
  record.number("last rate", last_.rate);
  record.number("last acceleration", last_.acceleration);
  if (!(std::isfinite(from_) && std::isfinite(to_) && from_ <= to_ && is_finite(first_) && is_finite(last_)))
    throw InputError("the waveform has a value that is not finite, or its times decrease");
}

}  // namespace ixos

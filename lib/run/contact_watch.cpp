#include "run/contact_watch.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

void ContactWatch::row(double time, double measure, const std::vector<std::pair<std::string, double>>& forces) {
  if (std::isnan(measure)) return;
  for (std::size_t k = forces_.size(); k < forces.size(); ++k) forces_.push_back({forces[k].first, 0, 0, 0});
  const double change = measure - measure_;
  if (any_ && -change > fall_.before - fall_.after) fall_ = {measure_, measure, time_, time};
  const bool counts = any_ && face_ > 0 && std::abs(change) <= face_ / 2;
  if (counts) passed_ += std::abs(change);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    Force& own = forces_[k];
    const double force = forces[k].second;
    if (counts && change != 0)
      own.sum += (force - own.last) * std::polar(1.0, 2 * M_PI * (measure_ + change / 2) / face_);
    own.last = force;
    own.largest = std::max(own.largest, std::abs(force));
  }
  largest_ = std::max(largest_, measure);
  time_ = time;
  measure_ = measure;
  any_ = true;
}

Ripple ContactWatch::ripple() const {
  Ripple result;
  if (!(passed_ >= 8 * face_) || face_ == 0) return result;
  for (const Force& own : forces_)
    if (own.largest > result.largest)
      result = {own.column, std::abs(own.sum) * face_ / (M_PI * passed_), own.largest};
  return result;
}

void ContactWatch::transfer(Record& record) {
  const Record::Section section(record, "contact watch");
  record.number("any", any_);
  record.number("time", time_);
  record.number("measure", measure_);
  record.number("largest", largest_);
  record.number("passed", passed_);
  record.number("fall before", fall_.before);
  record.number("fall after", fall_.after);
  record.number("fall from", fall_.from);
  record.number("fall to", fall_.to);
  auto count = forces_.size();
  record.number("forces", count);
  forces_.resize(record.loading() ? std::min<std::size_t>(count, 1000) : count);
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    Force& own = forces_[k];
    const Record::Section force(record, "force " + std::to_string(k));
    double real = own.sum.real(), imaginary = own.sum.imag();
    record.text("column", own.column);
    record.number("last", own.last);
    record.number("largest", own.largest);
    record.number("real", real);
    record.number("imaginary", imaginary);
    own.sum = {real, imaginary};
  }
}

}  // namespace ixos

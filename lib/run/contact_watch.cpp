#include "run/contact_watch.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

void ContactWatch::row(double time, double measure, const std::vector<std::pair<std::string, double>>& forces) {
  if (std::isnan(measure)) return;
  const auto same = [](const Force& own, const auto& force) { return own.column == force.first; };
  if (!std::equal(forces_.begin(), forces_.end(), forces.begin(), forces.end(), same)) {
    forces_.clear();  // the first row, or a restart that records others
    rows_ = 0;
    for (const auto& force : forces) forces_.push_back({force.first, {}, 0, 0});
  }
  if (rows_ > 0 && measure_[0] - measure > fall_.before - fall_.after) fall_ = {measure_[0], measure, time_, time};
  const double way = std::abs(measure - measure_[1]);
  const bool counts = rows_ > 1 && way > 0 && way <= 4 * face_;
  if (counts) passed_ += way / 2;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    Force& own = forces_[k];
    if (counts) {
      const double rough = own.last[0] - (own.last[1] + forces[k].second) / 2;
      own.rough += rough * rough;
      own.size += own.last[0] * own.last[0];
    }
    own.last = {forces[k].second, own.last[0]};
  }
  largest_ = std::max(largest_, measure);
  time_ = time;
  measure_ = {measure, measure_[0]};
  ++rows_;
}

Ripple ContactWatch::ripple() const {
  Ripple result;
  double largest = 0;
  for (const Force& own : forces_) {
    if (!(own.size > largest)) continue;  // a small reaction across the pull vibrates
    largest = own.size;
    result = {own.column, std::sqrt(own.rough / own.size), passed_ / face_};
  }
  return result;
}

void ContactWatch::transfer(Record& record) {
  const Record::Section section(record, "contact watch");
  record.number("rows", rows_);
  record.number("time", time_);
  record.number("measure", measure_[0]);
  record.number("measure before", measure_[1]);
  record.number("largest", largest_);
  record.number("passed", passed_);
  record.number("fall before", fall_.before);
  record.number("fall after", fall_.after);
  record.number("fall from", fall_.from);
  record.number("fall to", fall_.to);
  auto count = forces_.size();
  record.number("forces", count);
  // A checkpoint of another scene restores only the forces that this scene has, too.
  std::vector<Force> loaded;
  for (std::size_t k = 0; k < count; ++k) {
    Force own = !record.loading() ? forces_[k] : Force();
    const Record::Section force(record, "force " + std::to_string(k));
    record.text("column", own.column);
    record.number("last", own.last[0]);
    record.number("before", own.last[1]);
    record.number("rough", own.rough);
    record.number("size", own.size);
    if (record.loading()) loaded.push_back(std::move(own));
  }
  if (record.loading()) forces_ = record.same_scene() ? std::move(loaded) : std::vector<Force>();
}

}  // namespace ixos

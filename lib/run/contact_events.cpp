#include "run/contact_events.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

ContactEvents::ContactEvents(const std::vector<std::string>& interactions) : touches_(interactions.size(), 0) {
  for (const std::string& name : interactions) times_.push_back({name});
}

/// Takes over the times of the interaction of that name; of another one only with `new_ones_too`.
void ContactEvents::take(const ContactTimes& times, bool touches, bool new_ones_too) {
  const auto own = std::find_if(times_.begin(), times_.end(),
                                [&](const ContactTimes& other) { return other.interaction == times.interaction; });
  const auto place = static_cast<std::size_t>(own - times_.begin());
  if (own == times_.end()) {
    if (!new_ones_too) return;
    times_.emplace_back();
    touches_.push_back(0);
  }
  times_[place] = times;
  touches_[place] = touches ? 1 : 0;
}

void ContactEvents::go_on_from(const ContactEvents& before) {
  for (std::size_t k = 0; k < before.times_.size(); ++k) take(before.times_[k], before.touches_[k] != 0, true);
}

void ContactEvents::row(double time, const std::vector<double>& measures) {
  for (std::size_t k = 0; k < std::min(times_.size(), measures.size()); ++k) {
    const bool touches = measures[k] > 0;
    ContactTimes& own = times_[k];
    if (touches && std::isnan(own.first)) own.first = time;
    if (touches)
      own.released = std::numeric_limits<double>::quiet_NaN();
    else if (touches_[k] != 0)
      own.released = time;
    touches_[k] = touches ? 1 : 0;
  }
}

void ContactEvents::transfer(Record& record) {
  const Record::Section section(record, "contact events");
  auto count = times_.size();
  record.number("interactions", count);
  // A checkpoint of another scene restores only the interactions that this scene has, too. A number that is not one
  // stands as an infinite one.
  const auto transfer = [&](const char* name, double& time) {
    double stored = std::isnan(time) ? HUGE_VAL : time;
    record.number(name, stored);
    time = std::isfinite(stored) ? stored : std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Record::Section interaction(record, "interaction " + std::to_string(k));
    ContactTimes own = k < times_.size() ? times_[k] : ContactTimes();
    bool touches = k < touches_.size() && touches_[k] != 0;
    record.text("name", own.interaction);
    transfer("first", own.first);
    transfer("released", own.released);
    record.number("touches", touches);
    if (record.loading()) take(own, touches, record.same_scene());  // new ones are of earlier stages
  }
}

}  // namespace ixos

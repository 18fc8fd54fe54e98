#include "run/contact_events.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

ContactEvents::ContactEvents(const std::vector<std::string>& interactions) : touches_(interactions.size(), 0) {
  for (const std::string& name : interactions) times_.push_back({name});
}

void ContactEvents::go_on_from(const ContactEvents& before) {
  for (std::size_t k = 0; k < before.times_.size(); ++k) {
    const auto own = std::find_if(times_.begin(), times_.end(), [&](const ContactTimes& times) {
      return times.interaction == before.times_[k].interaction;
    });
    if (own == times_.end()) {
      times_.push_back(before.times_[k]);
      touches_.push_back(before.touches_[k]);
      continue;
    }
    *own = before.times_[k];
    touches_[static_cast<std::size_t>(own - times_.begin())] = before.touches_[k];
  }
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
    if (!record.loading()) continue;
    const bool is_new = std::none_of(times_.begin(), times_.end(),
                                     [&](const ContactTimes& times) { return times.interaction == own.interaction; });
    if (is_new && record.same_scene()) {  // of an earlier stage
      times_.push_back(own);
      touches_.push_back(touches ? 1 : 0);
    }
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (times_[i].interaction != own.interaction) continue;
      times_[i] = own;
      touches_[i] = touches ? 1 : 0;
    }
  }
}

}  // namespace ixos

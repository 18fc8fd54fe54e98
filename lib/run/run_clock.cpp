#include "run/run_clock.hpp"

#include <Teuchos_Time.hpp>
#include <string>

namespace ixos {

void RunClock::reset() {
  start_ = Teuchos::Time::wallTime();
  phases_start_ = phase_seconds();
}

double RunClock::seconds() const { return Teuchos::Time::wallTime() - start_; }

PhaseSeconds RunClock::phases() const {
  PhaseSeconds seconds = phase_seconds();
  for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] -= phases_start_[i];
  return seconds;
}

double RunClock::transfer(Record& record) {
  double own = seconds();
  PhaseSeconds by_phase = phases();
  record.number("wall seconds", own);
  for (std::size_t i = 0; i < phase_names.size(); ++i)
    record.number((std::string("seconds ") + phase_names[i]).c_str(), by_phase[i]);
  if (!record.loading()) return own;
  start_ -= own;
  for (std::size_t i = 0; i < phases_start_.size(); ++i) phases_start_[i] -= by_phase[i];
  return own;
}

}  // namespace ixos

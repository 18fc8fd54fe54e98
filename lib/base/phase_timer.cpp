#include "base/phase_timer.hpp"

#include <Teuchos_TimeMonitor.hpp>

namespace ixos {
namespace {

using Timers = std::array<Teuchos::RCP<Teuchos::Time>, phase_names.size()>;

const Timers& timers() {
  static const Timers all = [] {
    Timers made;
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = Teuchos::TimeMonitor::getNewCounter(std::string("Ixos: ") + phase_names[i]);
    return made;
  }();
  return all;
}

const char* current = nullptr;  ///< see current_phase()

}  // namespace

const char* current_phase() noexcept { return current; }

TimedScope::TimedScope(Phase phase) : timer_(phase_timer(phase)), outermost_(!timer_.isRunning()), outer_(current) {
  current = phase_names[static_cast<std::size_t>(phase)];
  if (outermost_) timer_.start();
}

TimedScope::~TimedScope() {
  if (outermost_) timer_.stop();
  current = outer_;
}

NamedScope::NamedScope(const char* name) : outer_(current) { current = name; }

NamedScope::~NamedScope() { current = outer_; }

Teuchos::Time& phase_timer(Phase phase) { return *timers()[static_cast<std::size_t>(phase)]; }

PhaseSeconds phase_seconds() {
  PhaseSeconds seconds{};
  for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] = timers()[i]->totalElapsedTime();
  return seconds;
}

}  // namespace ixos

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

}  // namespace

Teuchos::Time& phase_timer(Phase phase) { return *timers()[static_cast<std::size_t>(phase)]; }

PhaseSeconds phase_seconds() {
  PhaseSeconds seconds{};
  for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] = timers()[i]->totalElapsedTime();
  return seconds;
}

}  // namespace ixos

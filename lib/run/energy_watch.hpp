/// A watch on the energy balance: a scheme that conserves energy knows its own bound.
#pragma once
#include <limits>
#include <string>

#include "base/record.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Compares the change of the energy balance from row to row with what the scheme (Table::energy_promise), its points
/// in time, Newton's tolerance and rounding (unbalanced_work()) allow. A larger change means that the points do not
/// suffice for the step. A change far beyond that may also mean that memory was damaged: a flipped bit in a
/// displacement or a velocity moves the balance at once.
class EnergyWatch {
 public:
  /// Reads the settings of the simulation's WatchOptions. By default the watch is on for schemes with a promise, if
  /// nothing dissipates, and if their points in time (Table::interaction_points) meet neither moved obstacles nor laws
  /// that end or that are defined at every gap.
  explicit EnergyWatch(const Simulation& simulation);

  bool on() const { return allowed_ > 0; }
  WatchAction action() const { return action_; }

  /// Takes part in each attempted step, before it is accepted: measures what the bound depends on. Collective.
  void step(const Integrator& integrator);

  /// Looks at a row: the energy less external work plus dissipation after so many steps, and the largest energy so far
  /// [both E0 L0^D]. Returns what is wrong, or nothing.
  std::string look(long step, double balance, double largest_energy);

  /// For checkpoints.
  void transfer(Record& record);

 private:
  double allowed_ = 0;  ///< change of the balance in a step, over the largest energy; 0: off
  WatchAction action_ = WatchAction::Warn;
  bool by_scheme_ = false;  ///< the scheme set the bound
  int elastic_points_ = 0;  ///< in time, of the elastic force; 0: its mean has none
  double quadrature_ = 0;   ///< what points in time add to the share since the last row, summed over the steps
  double work_ = 0;         ///< what tolerance and rounding add to the bound itself, likewise [E0 L0^D]
  std::string scheme_;
  double last_ = std::numeric_limits<double>::quiet_NaN();  ///< balance of the row before
  long last_step_ = 0;
};

}  // namespace ixos

/// Running a scene to its end, with results on disk.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/phase_timer.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Where a run stands, for whoever watches it.
struct Progress {
  double time = 0;
  double final_time = 0;
  long step = 0;
  long newton_iterations = 0;  ///< since the start
  double wall_seconds = 0;
};

struct RunOptions {
  std::string folder;                          ///< results go here; made where it does not exist
  std::function<void(const Progress&)> watch;  ///< called after every step on rank 0; may be empty
  std::function<bool()> interrupted;           ///< asked before every step; set on all ranks or on none
};

enum class RunStatus { Completed, Stopped, Diverged, Interrupted };  ///< Stopped: a stop criterion holds

struct RunResult {
  RunStatus status = RunStatus::Completed;
  std::string reason;
  long steps = 0;
  long rejected_steps = 0;  ///< that failed, and were cut where that is allowed
  double end_time = 0;
  long newton_iterations = 0;
  long linear_iterations = 0;
  double wall_seconds = 0;                                 ///< of the time loop, output included
  double max_energy_error = 0;                             ///< see History::max_energy_error
  std::vector<std::pair<std::string, double>> max_forces;  ///< see History::max_forces
  std::array<double, phase_names.size()> phase_seconds{};  ///< of rank 0
};

/// Runs from the simulation's present state to its final time; writes effective.xml, history.csv and summary.json. A
/// step that fails, and may not be cut, ends the run with RunStatus::Diverged; the rows up to there are on disk. Throws
/// FileError, before anything is computed, where the folder cannot be written. Collective.
RunResult run(Simulation& simulation, const RunOptions& options);

}  // namespace ixos

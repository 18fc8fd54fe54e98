/// summary.json: how a run ended and what it cost.
#pragma once
#include <array>
#include <string>

#include "base/phase_timer.hpp"
#include "scene/run.hpp"

namespace ixos {

struct RunTotals {
  long newton_iterations = 0;
  double wall_seconds = 0;
  double max_energy_error = 0;
  std::array<double, phase_names.size()> phase_seconds{};  ///< of rank 0, in this run
};

/// Collective; written on rank 0. Throws FileError.
void write_summary(const Simulation& simulation, const RunResult& result, const RunTotals& totals,
                   const std::string& path);

}  // namespace ixos

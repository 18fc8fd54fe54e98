/// summary.json: how a run ended and what it cost.
#pragma once
#include <string>

#include "run/run.hpp"

namespace ixos {

/// Returns the word of the summary for a status: completed, stopped, diverged or interrupted.
std::string to_string(RunStatus status);

/// Writes the summary on rank 0. Throws FileError. Collective.
void write_summary(const Simulation& simulation, const RunResult& result, const std::string& path);

}  // namespace ixos

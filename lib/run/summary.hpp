/// summary.json: how a run ended and what it cost.
#pragma once
#include <string>

#include "run/run.hpp"

namespace ixos {

/// Writes the summary on rank 0. Throws FileError. Collective.
void write_summary(const Simulation& simulation, const RunResult& result, const std::string& path);

}  // namespace ixos

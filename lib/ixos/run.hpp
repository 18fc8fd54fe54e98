/// Runs of a Simulation to its end, with results on disk.
///
/// Stable: run, RunOptions, RunResult, RunStatus, Progress.
#pragma once
#include "run/run.hpp"

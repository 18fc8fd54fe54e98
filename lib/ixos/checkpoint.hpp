/// The state of an Integrator and of a program, in memory (Snapshot) and in checkpoints.
///
/// Stable: Record, Snapshot, ProgramState, write_checkpoint, read_checkpoint.
#pragma once
#include "base/record.hpp"
#include "base/snapshot.hpp"
#include "checkpoint/program_state.hpp"
#include "run/loop_checkpoint.hpp"

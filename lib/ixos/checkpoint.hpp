/// Checkpoints: records that write and read the state of an Integrator and of a program.
///
/// Stable: Record, CheckpointSize, CheckpointWriter, CheckpointReader.
#pragma once
#include "base/record.hpp"
#include "checkpoint/checkpoint_file.hpp"

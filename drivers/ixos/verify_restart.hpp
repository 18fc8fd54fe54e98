/// ixos --verify-restart.
#pragma once
#include "ixos/arguments.hpp"

namespace ixos {

/// Verifies that killed runs of the scene resume bit for bit, see check_restarts(). Prints a line for each part. Must
/// be called without MPI: it starts processes of the same program, with mpirun if there are several ranks. Returns the
/// exit status: 0 if all is the same, 3 if anything differs, the status of a run that failed, else as ixos does.
int verify_restart(const Arguments& arguments);

}  // namespace ixos

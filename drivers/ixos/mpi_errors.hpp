// Failures of MPI.
#pragma once

namespace ixos {

/// Makes every failure of MPI end the job at once with exit status 4 and MPI's message. MPI's own abort would end it
/// with any status. Must be called between MPI's initialization and the first communicator.
void end_on_mpi_errors();

}  // namespace ixos

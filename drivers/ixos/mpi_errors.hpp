// What happens when MPI fails.
#pragma once

namespace ixos {

/// Has every failure of MPI end the job at once with exit status 4 and MPI's words, in place of MPI's own abort, whose
/// status could mean anything. To be called between MPI's initialization and the first communicator.
void end_on_mpi_errors();

}  // namespace ixos

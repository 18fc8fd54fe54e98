#include "ixos/mpi_errors.hpp"

#include <mpi.h>

#include <cstdio>

namespace ixos {
namespace {

void end(MPI_Comm*, int* code, ...) {
  char words[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  MPI_Error_string(*code, words, &length);
  std::fprintf(stderr, "ixos: the communication between the ranks failed: %s\n", words);
  std::fflush(stderr);
  MPI_Abort(MPI_COMM_WORLD, 4);
}

}  // namespace

void end_on_mpi_errors() {
  MPI_Errhandler handler = MPI_ERRHANDLER_NULL;
  MPI_Comm_create_errhandler(end, &handler);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, handler);
  MPI_Comm_set_errhandler(MPI_COMM_SELF, handler);
  MPI_Errhandler_free(&handler);
}

}  // namespace ixos

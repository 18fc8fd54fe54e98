// The one function that solver_library() looks up.
#include "solve/loaded/mumps_factorization.hpp"
#include "solve/loaded/stratimikos_builder.hpp"

extern "C" const ixos::SolverLibrary* ixos_solver_library() {
  static const ixos::SolverLibrary library{ixos::make_stratimikos_builder, ixos::make_mumps};
  return &library;
}

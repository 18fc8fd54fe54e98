/// MUMPS.
#pragma once
#include <memory>

#include "solve/direct/factorization.hpp"

namespace ixos {

/// See SolverLibrary::mumps.
std::unique_ptr<Factorization> make_mumps(bool single_precision);

}  // namespace ixos

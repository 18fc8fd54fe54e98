/// Linear solvers and preconditioners by Stratimikos.
#pragma once
#include "solve/solver_library.hpp"

namespace ixos {

/// See SolverLibrary::stratimikos.
std::unique_ptr<SolverBuilder> make_stratimikos_builder(const Teuchos::ParameterList& list);

}  // namespace ixos

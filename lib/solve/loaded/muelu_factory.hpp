/// MueLu's multigrid, compiled in one place: its headers take a compiler half a minute.
#pragma once
#include "solve/operator_preconditioner.hpp"

namespace ixos {

/// Returns a factory of MueLu's preconditioners.
Teuchos::RCP<PreconditionerFactory> make_muelu_factory();

}  // namespace ixos

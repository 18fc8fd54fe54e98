/// What a scene models, and what it leaves out.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// For a person, before a run: bodies, interactions, scheme, solvers, output, the memory that the large arrays take on
/// this rank, and what is left out and hence costs nothing. Collective.
std::string explain(const Simulation& simulation);

}  // namespace ixos

/// A description of a scene's models, and of the parts that it leaves out.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns a text for the user, before a run: bodies, sets and their sizes, interactions, scheme, solvers, output, the
/// memory that the large arrays take on this rank, notes, the parts that are left out and hence cost nothing, and its
/// numbers in SI units.
/// Collective.
std::string explain(const Simulation& simulation);

}  // namespace ixos

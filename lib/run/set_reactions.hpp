/// The reactions of node sets.
#pragma once
#include <vector>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns the sums of the present state's reactions over node sets, given by their numbers in the mesh: sets x
/// dimension [E0 L0^(D-1)]. Leaves out derivative nodes, whose reactions are moments. Collective.
std::vector<double> set_reactions(const Simulation& simulation, const std::vector<std::size_t>& sets);

}  // namespace ixos

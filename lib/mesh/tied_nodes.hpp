/// The tied nodes of a whole mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the ties of a mesh whose masters are tied to nothing, see resolved_ties(). Messages count nodes from 1.
std::vector<Tie> resolved_ties(const Mesh& mesh);

/// Moves nodes that are tied in place to where their masters put them, X = sum of weight X, see Tie.
void place_tied_nodes(Mesh& mesh);

}  // namespace ixos

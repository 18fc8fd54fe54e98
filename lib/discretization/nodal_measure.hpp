/// Integrals of the shape functions, which turn a load per volume or area into nodal forces. Those of an axisymmetric
/// mesh are over the whole body, volumes [L0^3] and areas [L0^2]. Masters take over those of tied nodes.
#pragma once
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// Adds int N_a dV over the block's cells to measure[a], per local node [L0^D]; complete for owned nodes.
void add_block_measure(const LocalMesh& mesh, const LocalBlock& block, std::vector<double>& measure);

/// Adds int N_a dA over the sides [L0^(D-1)].
void add_side_measure(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::vector<double>& measure);

}  // namespace ixos

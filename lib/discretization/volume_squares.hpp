/// Integrals of squares of fields over the reference volume. Those of an axisymmetric mesh are over the whole body.
#pragma once
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the reference volumes of this rank's own cells [L0^D], by block and local cell; 0 for cells of other ranks.
std::vector<std::vector<double>> owned_volumes(const LocalMesh& mesh);

/// Returns int sum_i f_i^2 dV over this rank's own cells. `components`: the f_i by local node, ghosts included; the
/// shape functions interpolate them. As exact as the consistent mass, see Mass::add_block().
double nodal_square(const LocalMesh& mesh, const std::vector<std::vector<double>>& components);

}  // namespace ixos

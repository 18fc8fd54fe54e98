/// Integrals over cells of one mesh of a field of another one.
#pragma once
#include <vector>

#include "adapt/split_mesh.hpp"
#include "model/model.hpp"

namespace ixos {

/// Returns int rho N_a (v - v') dV of a field v of one mesh and a field v' of another one of the same unsplit cells, a
/// local array of the other one's model, valid for owned nodes [E0 T0 L0^(D-1)]. Both: by node of the whole meshes.
/// Cells on which both are the same function are left out: parts of plain cells without other values of tied nodes.
std::vector<double> missing_momentum(const SplitMesh& from, const std::vector<double>& v, const SplitMesh& to,
                                     const Model& model, const std::vector<double>& interpolated);

}  // namespace ixos

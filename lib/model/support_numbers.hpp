/// Stiffness and damping by direction.
#pragma once
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the coefficients of springs or dashpots by direction; none if they are empty or all are 0. `what`:
/// "stiffness" or "damping". Throws InputError if their number is not the mesh's dimension, one is negative or not
/// finite, or the radial one of an axisymmetric mesh is not 0.
std::vector<double> support_numbers(const char* what, std::vector<double> values, const LocalMesh& mesh);

}  // namespace ixos

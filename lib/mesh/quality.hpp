/// Is a mesh fit for computation?
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Throws InputError, naming block and cell (from 1), where a cell's reference Jacobian is not positive at some corner
/// point xi = +-1/sqrt(3): an inverted, degenerate or wrongly numbered cell.
void check_cells(const Mesh& mesh);

}  // namespace ixos

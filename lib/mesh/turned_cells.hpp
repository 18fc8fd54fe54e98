/// Cells whose nodes run the wrong way round.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Renumbers the nodes of the cells of a file that are numbered as mirror images: clockwise quadrilaterals in the
/// plane, left-handed hexahedra; and the sides of side sets with them. The body keeps its shape, and each side set its
/// sides. Leaves a note of hexahedra. A cell that lies folded over a neighbour stays as it is, since it would then
/// overlap with it: check_cells() refuses it. The mesh has its final dimension and is not enriched.
void turn_cells(Mesh& mesh);

}  // namespace ixos

/// Cells whose edges are not straight.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Returns whether cells of a block need the rule for Jacobians of a higher degree, see own_rule(): quadratic
/// tetrahedra, prisms and pyramids that have a node elsewhere than in the middle of its corners, by more than 1e-10 of
/// their size, and quadratic triangles that are sections of rings.
bool needs_high_rule(const Mesh& mesh, const ElementBlock& block);

}  // namespace ixos

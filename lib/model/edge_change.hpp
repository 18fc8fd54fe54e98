/// How far cells deform in a step.
#pragma once
#include "model/model.hpp"

namespace ixos {

/// Returns the largest change of a cell's edge, as a vector, between the local displacements u0 and u1, over the edge's
/// length half-way [-]: about the change of the displacement gradient; for a rotation by an angle, twice the tangent of
/// its half. Edges lead from corner to corner. Equal on all ranks; collective.
double edge_change(const Model& model, const double* u0, const double* u1);

}  // namespace ixos

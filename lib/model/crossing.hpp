/// Surfaces that cross their obstacles between the points at which forces act.
#pragma once
#include <string>

#include "model/model.hpp"

namespace ixos {

/// Returns "node 12 of the mesh at (1, -0.015)" if a node of this rank stands at that place at displacement u
/// and is none that a contact element added, otherwise "the place (1, -0.015) on a side".
std::string in_words(const LocalMesh& mesh, const double* u, const LowestPoint& point);

/// Returns how far and where a surface is in or below its obstacle at the end of the way, by
/// Admissibility::lowest_point(); empty if all gaps are positive. A law that is defined at every gap allows all
/// gaps but minus infinity, beyond the obstacle's edge. If the way has a beginning, a point that passes
/// through its obstacle or another body on the way counts, too, by Admissibility::passage(), whatever the law. Equal on
/// all ranks; collective.
std::string crossing(const Model& model, const Segment& way);

/// Returns the least gap of the interactions whose laws are defined at every gap, likewise; infinity if there are none.
/// Collective if there are any.
double least_free_gap(const Model& model, const Place& at);

}  // namespace ixos

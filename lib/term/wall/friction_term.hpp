/// Friction of a surface along a rigid obstacle.
#pragma once
#include <memory>
#include <vector>

#include "interaction/friction_law.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {

/// Returns the terms of friction beside those of make_surface_terms(), on the same quadrature points. Each keeps the
/// traction of its points from step to step. Its energy is what the elastic slip stores, its work the rest of what the
/// friction force takes.
///
/// Rules that average over the straight path from the start of their segment follow the mean in closed form. If that is
/// the step's start, the work of the force is the potential's change to rounding. Other rules evaluate the force at
/// their points.
Interactions make_friction_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                                 const FrictionLaw& law, const std::shared_ptr<const Obstacle>& obstacle,
                                 const SurfaceOptions& options);

}  // namespace ixos

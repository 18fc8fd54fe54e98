/// Friction between the surfaces of two bodies.
#pragma once
#include <memory>
#include <vector>

#include "discretization/pattern.hpp"
#include "interaction/friction_law.hpp"
#include "term/pair/pair_points.hpp"

namespace ixos {

/// Returns the term of friction beside that of make_pair_term(), on the same quadrature points, see PairSlip. Rules
/// that average over the straight path from the start of their segment follow the mean in closed form. If that is the
/// step's start, the work of the force is the potential's change to rounding. In space that mean is no gradient: its
/// tangent is unsymmetric by the rotation of the step. Other rules evaluate the force at their points. The threshold
/// must be that of the step's start, the surfaces two that react. Its matrix entries go to nodes that the pair's own
/// term couples. Mesh and pattern must outlive the term.
template <std::size_t D>
std::unique_ptr<Interaction> make_pair_friction(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
                                                std::shared_ptr<const GapLaw> law, const FrictionLaw& friction,
                                                const PairOptions& options);

}  // namespace ixos

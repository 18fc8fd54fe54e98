/// Displacements and velocities of a body on another mesh.
#pragma once
#include <vector>

#include "adapt/split_mesh.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Local arrays [L0, L0/T0].
struct Motion {
  std::vector<double> u, v;
};

/// Returns displacements and velocities on another mesh of the same unsplit cells. Where cells are split, both are the
/// same functions; where they are joined, u takes the values at the nodes that stay, and v is projected with the mass:
/// int N rho v over the body is kept (a quasi-static model has none). A part gets a rigid motion, too, as far as
/// its supports allow one, so that its linear and angular momentum are those before: joined cells change its
/// displacements, and finer cells on curves its places. Throws InputError if the system of the mass is not
/// solved. Collective.
Motion moved_motion(const SplitMesh& from, const Model& before, const State& state, const SplitMesh& to,
                    const Model& after);

}  // namespace ixos

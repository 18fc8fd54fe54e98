/// The state of one stage of a scene as the beginning of the next.
#pragma once
#include "scene/simulation.hpp"

namespace ixos {

/// Gives the state of a simulation to one of another stage, on the same mesh and partition: as a restart in another
/// scene does, with what each source has dissipated so far. Velocities that the other stage gives are added; the energy
/// that they, other laws or another scheme bring or take counts as external work. Throws InputError, on all ranks, if
/// the state is not admissible there, or if a prescribed displacement would jump. Collective.
void hand_over(Simulation& from, Simulation& to);

}  // namespace ixos

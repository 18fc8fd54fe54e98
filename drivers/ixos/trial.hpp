/// A few steps of a scene, to see what the whole run would take.
#pragma once
#include "ixos/arguments.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Runs the first 20 steps of a scene, or those of 20 seconds. Its folder is removed. Tells how long the whole run
/// would take, and what the run's warnings are so far. Returns the exit status: 0 or that of the run. Throws InputError
/// if the folder exists, FileError. Collective.
int try_scene(Simulation& simulation, const Arguments& arguments);

}  // namespace ixos

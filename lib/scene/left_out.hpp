/// The parts that a scene leaves out.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns a text for the user: a line for each effect and each output that the scene does not have, with what its
/// absence means. Friction and contact between bodies are in the list of every scene, since Ixos has neither.
std::string left_out(const Simulation& simulation);

}  // namespace ixos

/// The parts that a scene leaves out.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns a text for the user: a line for each effect and each output that the scene does not have, with what its
/// absence means. Contact between bodies is in the list of every scene, since Ixos has none.
std::string left_out(const Simulation& simulation);

}  // namespace ixos

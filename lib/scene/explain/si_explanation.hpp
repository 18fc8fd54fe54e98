/// The numbers of a scene in its own units and in SI units, for the user.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns lines with the units of the scene, every value that has a dimension, and the numbers that follow from them
/// (see CharacteristicNumbers, gravity_length()).
std::string explain_numbers(const Simulation& simulation);

}  // namespace ixos

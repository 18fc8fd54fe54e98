/// The quantities that a scene names.
#pragma once
#include <vector>

#include "scene/simulation.hpp"
#include "study/asked_quantity.hpp"

namespace ixos {

/// Returns the quantities of "Output/Quantities". Throws InputError, with that path, if one has no form of
/// AskedQuantity, needs a column that the scene's history.csv lacks, or a time outside the run.
std::vector<AskedQuantity> named_quantities(const Simulation& simulation);

}  // namespace ixos

/// The quantities that a scene names.
#pragma once
#include <vector>

#include "scene/simulation.hpp"
#include "study/common/asked_quantity.hpp"

namespace ixos {

/// Returns the quantities of "Output/Quantities". Throws InputError, with that path, if one has no form of
/// AskedQuantity or needs a column that the scene's history.csv lacks.
std::vector<AskedQuantity> named_quantities(const Simulation& simulation);

/// Throws InputError, with that path, if a quantity needs a time outside the run.
void check_times(const std::vector<AskedQuantity>& quantities, const Simulation& simulation);

}  // namespace ixos

/// Units in the documentation of parameters.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// One unit of a parameter, and the use to which it applies; empty if the parameter has one unit only.
struct DocumentedUnit {
  std::string expression;  ///< see UnitSystem::unit()
  std::string use;         ///< "motion" of "for a motion"
};

/// Reads the units in the first brackets of a documentation: "[L0]", "[E0 for a Traction, E0/L0 for a Body Force]". It
/// returns nothing, for a pure number, if there are none or they hold "-".
std::vector<DocumentedUnit> documented_units(const std::string& documentation);

}  // namespace ixos

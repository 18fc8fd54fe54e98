/// From the units that a user writes to plain numbers in L0, E0 and T0, and back for the user to read.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

#include "units/unit_system.hpp"

namespace ixos {

/// Returns the units of the list "Units" of a scene, complete or as a user writes it. Throws InputError with the list
/// path.
UnitSystem scene_units(const Teuchos::ParameterList& scene);

/// Returns a user's scene in which plain numbers take the place of all numbers with units. `valid` describes it: the
/// dimension of a parameter is in the brackets of its documentation (see DocumentedUnit). Leaves alone what validated()
/// refuses: unknown names, strings that do not begin with a number. Throws InputError, with the list path, for a unit
/// that does not exist or has another dimension.
Teuchos::ParameterList in_scene_units(const Teuchos::ParameterList& user, const Teuchos::ParameterList& valid);

/// Returns the user's scene in plain numbers with every default filled in, see validated(). Throws InputError.
Teuchos::ParameterList complete_scene(const Teuchos::ParameterList& user);

/// Returns a line for each length, stress, time and the like of a complete scene that is not 0: its path, its value in
/// units of the scene and in SI units. `dimension`: that of the mesh; 0 if no more is known than the scene states.
std::string values_in_si(const Teuchos::ParameterList& complete, const UnitSystem& units, int dimension = 0);

/// Returns the unit of a parameter of a complete scene, "E0" or "L0/T0"; empty for a pure number, or if the unit
/// depends on a use that the scene leaves open. `path`: its lists and its name, with "/" between them.
std::string unit_of(const Teuchos::ParameterList& complete, const std::string& path);

}  // namespace ixos

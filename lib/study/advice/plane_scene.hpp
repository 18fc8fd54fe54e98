/// Scenes in space whose bodies deform in a plane.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <optional>
#include <string>

namespace ixos {

/// Returns why a complete scene needs three dimensions; empty if two have the same solution. It is a box whose faces
/// front and back stay in their planes, y = const, and nothing else in the scene acts along y or depends on y.
std::string why_spatial(const Teuchos::ParameterList& complete);

/// Returns the same scene in two dimensions, of depth 1: x stays, z becomes y. `scene`: a scene of which why_spatial()
/// says nothing, with or without defaults.
Teuchos::ParameterList plane_scene(Teuchos::ParameterList scene);

/// Returns the name of a column of such a scene in two dimensions; none if that scene does not have it.
std::optional<std::string> plane_column(const std::string& column);

/// Returns whether the numbers of a column are those of the whole depth: forces, energies, momenta, measures. `probes`:
/// the list of the scene's probes.
bool grows_with_depth(const std::string& column, const Teuchos::ParameterList& probes);

}  // namespace ixos

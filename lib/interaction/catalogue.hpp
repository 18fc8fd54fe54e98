/// The interaction laws and the obstacles that a scene may choose.
#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "parameters/catalogue.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {

class GapLaw;
class Obstacle;

/// An entry makes a law, or an obstacle in a space of `dimension` dimensions, from its parameters.
using LawEntry = CatalogueEntry<std::shared_ptr<const GapLaw>>;
using ObstacleEntry = CatalogueEntry<std::shared_ptr<const Obstacle>, std::size_t>;

/// Returns the catalogues; their choices are "Law" and "Obstacle".
const Catalogue<LawEntry>& laws();
const Catalogue<ObstacleEntry>& obstacles();

/// Return the law or the obstacle of that name, for programs: make_gap_law("Van der Waals", {{"Gamma L", 2.5}, {"Gamma
/// W", 25.0}}), make_obstacle("Half-Space", 2, {{"Normal", {0.0, 1.0}}}). docs/parameters.md lists names, parameters
/// and defaults ("Interactions"). Throw InputError.
std::shared_ptr<const GapLaw> make_gap_law(const std::string& name, const Settings& settings = {});
std::shared_ptr<const Obstacle> make_obstacle(const std::string& name, std::size_t dimension,
                                              const Settings& settings = {});

}  // namespace ixos

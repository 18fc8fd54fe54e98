/// The interaction laws and the obstacles that a scene may choose.
#pragma once
#include <cstddef>
#include <memory>

#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "parameters/catalogue.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {

/// An entry makes a law, or an obstacle in a space of `dimension` dimensions, from its parameters.
using LawEntry = CatalogueEntry<std::shared_ptr<const GapLaw>>;
using ObstacleEntry = CatalogueEntry<std::shared_ptr<const Obstacle>, std::size_t>;

/// Returns the catalogues; their choices are "Law" and "Obstacle".
const Catalogue<LawEntry>& laws();
const Catalogue<ObstacleEntry>& obstacles();

}  // namespace ixos

/// Laws whose attraction ends almost with a jump.
#pragma once
#include <string>
#include <vector>

#include "scene/read/interactions.hpp"

namespace ixos {

/// Returns the length over which the attraction falls, on its way out to the end of its range, from 0.9 to 0.1 of its
/// largest value, as a share of the range; infinity for a law without a range or an attraction. Smooth Dugdale with a
/// Smoothing s has 0.608 x 2 s/(1 + s).
double fall_of_attraction(const GapLaw& law);

/// Returns, for the reason of a failed step, that the attraction of an interaction falls within less than 0.15 of its
/// range, and that Smooth Dugdale with more Smoothing does not; empty if there is none. Newton's method may cycle
/// there: points pass the end of the attraction to and fro.
std::string steep_law_hint(const std::vector<SceneInteraction>& interactions);

}  // namespace ixos

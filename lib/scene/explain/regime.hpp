/// The regime of an adhesive surface: brittle, flaw-tolerant, or by its Tabor number.
#pragma once
#include <string>

#include "scene/examine/characteristic_numbers.hpp"

namespace ixos {

enum class Regime {
  FlawTolerant,  ///< the cohesive zone is as large as the surface, which comes off everywhere at once
  Between,
  Brittle  ///< the zone is a tenth of the surface or less: a crack runs, and the law's strength does not matter
};

/// Returns the regime of a flat surface (Gao and Yao 2004, who compare its size with E* W/s0^2).
Regime regime(const SurfaceNumbers& surface);

/// Returns the strength [E0] at which the zone in a bulky body would be a tenth of the surface: a law of that strength
/// and the same work of adhesion gives the same pull-off force of a brittle surface, on faces that are larger.
double least_strength(const SurfaceNumbers& surface);

/// Returns a sentence on an adhesive surface: by its Tabor number where it or its obstacle is round (Johnson and
/// Greenwood 1997), else, if it is flat, by its cohesive zone; empty if it has no work of adhesion, or is an
/// electrode.
std::string regime_in_words(const SurfaceNumbers& surface);

}  // namespace ixos

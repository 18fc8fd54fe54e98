/// Choices of an advice beside the scene's own.
#pragma once
#include <vector>

#include "study/advice_errors.hpp"

namespace ixos {

/// Returns the next point that tells of another choice, the cheap ones first: each other model, tolerance and
/// quadrature once, with a step four times that of the base; each other element on the next coarser mesh and each other
/// scheme with the next coarser step, and once more, coarser still, if the first error is within the tolerance or at
/// most that of the scene's own. Returns an empty point if nothing is left.
AdvicePoint next_exploration(const AdviceDirections& directions, const AdvicePoint& base,
                             const std::vector<AdviceSample>& samples, const AdviceErrors& errors, double tolerance);

}  // namespace ixos

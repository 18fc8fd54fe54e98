/// Choices of an advice beside the scene's own.
#pragma once
#include <vector>

#include "study/advice_errors.hpp"

namespace ixos {

/// Returns the next point that tells of another choice: each other model, tolerance and quadrature once; each other
/// scheme and element at the base, and once more, coarser or finer, if its first error is within the tolerance or
/// at most that of the scene's own. Returns
/// an empty point if nothing is left.
AdvicePoint next_exploration(const AdviceDirections& directions, const AdvicePoint& base,
                             const std::vector<AdviceSample>& samples, const AdviceErrors& errors, double tolerance);

}  // namespace ixos

/// Choices of an advice beside the scene's own.
#pragma once
#include <vector>

#include "study/advice/advice_errors.hpp"

namespace ixos {

/// A run that tells of another choice.
struct AdviceTrial {
  AdvicePoint point;
  std::size_t direction = 0;
  double saving = 0;   ///< the part of the plan's cost that the choice may save
  double promise = 1;  ///< how much more accurate than the scene's own the choice was so far
};

/// Returns the runs that tell of other choices, all next to the base, where runs are cheap. `plan`: the
/// settings with the scene's own scheme and elements that they should be better than. Each other model, tolerance and
/// quadrature needs one run. Each other scheme and element is tried two levels coarser than the plan; then at finer
/// ones while it is not within the tolerance and at least as accurate as the scene's own, or at coarser ones while it
/// is within.
std::vector<AdviceTrial> explorations(const AdviceDirections& directions, const AdvicePoint& base,
                                      const AdvicePoint& plan, const std::vector<AdviceSample>& samples,
                                      const AdviceErrors& errors, double tolerance);

}  // namespace ixos

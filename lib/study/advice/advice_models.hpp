/// Comparison of runs with another model and runs with the scene's own.
#pragma once
#include <vector>

#include "study/advice/advice_point.hpp"

namespace ixos {

/// Fills in the comparisons of a good sample, in each direction in which it replaces the scene's model: with the run
/// of the scene's own model that differs in this direction alone, the finest one if there are several. No comparison
/// is added without such a run.
void compare_models(const AdviceDirections& directions, const std::vector<AdviceSample>& samples, AdviceSample& sample);

}  // namespace ixos

/// Two dimensions in place of three, for an advice.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/advice/advice.hpp"
#include "study/advice/advice_runs.hpp"

namespace ixos {

/// Returns the question on the scene in two dimensions, with the factors that its quantities have in the whole
/// depth; none if the scene or a quantity needs space. Throws InputError for a scene that is no good.
std::optional<AdvicePlane> plane_question(const AdviceQuestion& question, const std::string& path);

/// Writes the scene in two dimensions, to the path of that question.
void write_plane_scene(const AdviceQuestion& question, const AdvicePlane& plane);

/// Returns the largest difference of the quantities and their columns at a point in two dimensions, which was run, from
/// those in space with one cell across the depth, as a share of the latter; infinite if that run fails, or a quantity
/// cannot be compared. `runs`: those in two dimensions.
double difference_from_space(const AdviceQuestion& question, const AdvicePlane& plane,
                             const AdviceDirections& directions, AdviceRuns& runs, const AdvicePoint& point);

}  // namespace ixos

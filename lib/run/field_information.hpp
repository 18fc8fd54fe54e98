/// The records of fields.e for whoever finds it: what wrote it, of which scene, in which units.
#pragma once
#include <string>
#include <vector>

#include "scene/output/output_fields.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Returns the names of a frame's energies, in the order of fields.e.
const std::vector<std::string>& frame_energies();

/// Returns lines "key: value". They are the same for a run and for one that resumes it, if both have one motion: times
/// and the folder of results are not among them. `scene_file` may be empty. Collective.
std::vector<std::string> field_information(const Simulation& simulation, const std::string& scene_file,
                                           const std::vector<OutputField>& fields);

}  // namespace ixos

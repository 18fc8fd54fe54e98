/// Notes on a scene before its run.
#pragma once
#include <string>
#include <vector>

#include "scene/examine/scene_facts.hpp"

namespace ixos {

/// Returns what a sound scene may leave out unintended, a sentence for each surface that it concerns: a bond that never
/// forms, a foot that may slide while it is pulled off, a start far from equilibrium, a missing condition of symmetry.
std::vector<std::string> scene_notes(const SceneFacts& facts);

}  // namespace ixos

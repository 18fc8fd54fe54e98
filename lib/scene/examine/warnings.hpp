/// Warnings about a scene before its run.
#pragma once
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "scene/examine/scene_facts.hpp"

namespace ixos {

/// Returns what may be a mistake in the scene: the list in warnings.cpp, at most one warning of each kind. Limits are
/// such that sound scenes draw none.
std::vector<Warning> scene_warnings(const SceneFacts& facts);

/// Returns the warning of a velocity that jumps [L0/T0], at a time, by more than a share of the wave speed; else
/// nothing.
std::string velocity_jump(const CharacteristicNumbers& numbers, double jump, double time);

/// Returns whether the warning is about the initial time, which a run that resumes from a checkpoint does not see.
bool is_about_start(const Warning& warning);

}  // namespace ixos

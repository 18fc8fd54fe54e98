/// Scenes: the same files, parameters and messages as the command `ixos` has.
///
/// Stable: Simulation, GivenHistories, scene_parameters, read_scene_file, read_scene_text, set_parameter,
/// write_scene_file.
#pragma once
#include "scene/read/histories.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"

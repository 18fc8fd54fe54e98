/// Maxwell branches in a scene's materials.
#pragma once
#include <string>

#include "model/material.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Name of the list in a material.
extern const char* const maxwell_branches_name;

/// Declares the list of branches in a valid material.
void declare_branches(Teuchos::ParameterList& material);

/// Returns a user's scene in which branches that stand in a file are Relaxation Times and Moduli, so that restarts and
/// effective.xml have their numbers. Leaves alone what read_branches() refuses. Throws InputError with the path for a
/// file that cannot be read.
Teuchos::ParameterList with_branch_files(const Teuchos::ParameterList& scene, const std::string& scene_folder);

/// Reads the branches of a validated material into `material`. Throws InputError with the path if times and moduli do
/// not belong together, or stand beside a file.
void read_branches(const SceneNode& node, Material& material);

}  // namespace ixos

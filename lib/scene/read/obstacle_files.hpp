/// Files that obstacles of a scene read.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Returns the path, absolute, of a file that a scene names: beside the scene if there is one, otherwise from the
/// working folder.
std::string path_beside(const std::string& scene_folder, const std::string& file);

/// Returns a user's scene in which the files of obstacles have absolute paths, and their "Metre", if the user states
/// none, is that of the scene's Units. Leaves alone what the validation refuses. Throws InputError for bad Units.
Teuchos::ParameterList with_obstacle_files(const Teuchos::ParameterList& scene, const std::string& scene_folder);

/// Returns the checksums of the files that the obstacles of a complete scene read, four whole numbers for each, which
/// are exact as doubles; leaves out files that cannot be read. A restart recognises the heights by them.
std::vector<double> obstacle_file_checksums(const Teuchos::ParameterList& scene);

}  // namespace ixos

/// One run of a scene, and the scene that it has.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Changes of a scene, "List/Sublist/Name=value" as on the command line.
using Assignments = std::vector<std::string>;

/// One run of a study: a value of each axis.
struct StudyRun {
  std::string name;                 ///< its folder's: the labels, spelt so that any file system takes them
  std::vector<std::string> labels;  ///< by axis
  Assignments settings;             ///< common ones first
};

/// Returns the scene with changes, without defaults. Throws InputError.
Teuchos::ParameterList with_settings(Teuchos::ParameterList scene, const Assignments& settings);

/// Returns the scene of a file with changes, without defaults. Throws InputError.
Teuchos::ParameterList user_scene(const std::string& path, const Assignments& settings);

/// Returns the complete scene of a file with changes, as it will be read. Throws InputError.
Teuchos::ParameterList changed_scene(const std::string& path, const Assignments& settings);

/// Returns the same as text.
std::string changed_scene_text(const std::string& path, const Assignments& settings);

}  // namespace ixos

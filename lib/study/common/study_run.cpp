#include "study/common/study_run.hpp"

#include <utility>

#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"

namespace ixos {

Teuchos::ParameterList with_settings(Teuchos::ParameterList scene, const Assignments& settings) {
  for (const std::string& assignment : settings) set_parameter(scene, scene_parameters(), assignment);
  return scene;
}

Teuchos::ParameterList user_scene(const std::string& path, const Assignments& settings) {
  return with_settings(read_scene_file(path), settings);
}

Teuchos::ParameterList changed_scene(const std::string& path, const Assignments& settings) {
  return complete_scene(user_scene(path, settings));
}

std::string changed_scene_text(const std::string& path, const Assignments& settings) {
  return scene_text(changed_scene(path, settings));
}

}  // namespace ixos

/// Scene files: Teuchos parameter lists in XML.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// Reads a scene: see list_from_xml(). set_from_text() reads the values, because Teuchos' own reader takes "abc" for 0
/// and the last of two entries of one name. Throws InputError that names the file and the list path.
Teuchos::ParameterList read_scene_file(const std::string& path);

/// Reads a scene from text as read_scene_file() does; `origin` stands for the file name in messages.
Teuchos::ParameterList read_scene_text(const std::string& xml, const std::string& origin);

/// Carries out "List/Sublist/Name=value". The value is read in the type that `valid` has for that entry; in free-form
/// lists, as the first of int, double, bool and string that fits. If the entry chooses a law, an obstacle, a mesh or
/// the like, this removes the parameters of the ones not chosen: the new one takes their place. Throws InputError.
void set_parameter(Teuchos::ParameterList& scene, const Teuchos::ParameterList& valid, const std::string& assignment);

/// Returns a list as XML that read_scene_text() reads back to the last digit.
std::string scene_text(const Teuchos::ParameterList& scene);

/// Writes a list that read_scene_file() reads back to the last digit. Throws FileError.
void write_scene_file(const Teuchos::ParameterList& scene, const std::string& path);

}  // namespace ixos

#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <array>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "parameters/list_xml.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/scene_node.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

/// Sets the value in a free-form list, in the first type that the text spells.
void set_as_it_looks(Teuchos::ParameterList& list, const std::string& name, const std::string& text) {
  for (const char* type : {"int", "double", "bool"}) {
    try {
      return set_from_text(list, name, type, text);
    } catch (const InputError&) {
      continue;
    }
  }
  set_from_text(list, name, "string", text);
}

}  // namespace

Teuchos::ParameterList read_scene_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> part{};
  while (file && text.size() <= largest_xml) {  // not more of a file without an end
    file.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad() || (file.fail() && !file.eof())) throw InputError(path + ": the scene file cannot be read");
  return read_scene_text(text, path);
}

Teuchos::ParameterList read_scene_text(const std::string& xml, const std::string& origin) {
  return list_from_xml(xml, origin);
}

void set_parameter(Teuchos::ParameterList& scene, const Teuchos::ParameterList& valid, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--set \"" + assignment + "\": write \"List/Sublist/Name=value\"");
  const std::string path = assignment.substr(0, equals);
  const std::string text = assignment.substr(equals + 1);

  Teuchos::ParameterList* list = &scene;
  const Teuchos::ParameterList* known = &valid;
  std::size_t start = 0;
  for (auto slash = path.find('/'); slash != std::string::npos; slash = path.find('/', start)) {
    const std::string name = path.substr(start, slash - start);
    if (known != nullptr) known = valid_sublist(lists_of(*known, valid), name, "--set " + path);
    if (list->isParameter(name) && !list->isSublist(name))
      throw InputError(fmt::format("--set {}: {} is a parameter of the scene, not a list", path, name));
    at("--set " + path, [&name] { check_name(name); });
    list = &list->sublist(name);
    start = slash + 1;
  }
  const std::string name = path.substr(start);
  try {
    if (known == nullptr || is_free_form(*known)) return set_as_it_looks(*list, name, text);
    set_from_text(*list, name, type_name(valid_entry(*known, name, path)), text);
    discard_left_out(*list, *known, name);
  } catch (const InputError& error) {
    throw InputError("--set " + path + ": " + error.what());
  }
}

std::string scene_text(const Teuchos::ParameterList& scene) {
  std::ostringstream text;
  Teuchos::writeParameterListToXmlOStream(scene, text);
  return text.str();
}

void write_scene_file(const Teuchos::ParameterList& scene, const std::string& path) {
  write_whole_file(path, scene_text(scene));
}

}  // namespace ixos

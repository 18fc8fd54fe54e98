#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <Teuchos_FileInputSource.hpp>
#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "scene/parameter_text.hpp"
#include "scene/validation.hpp"

namespace ixos {
namespace {

std::string required(const Teuchos::XMLObject& element, const char* attribute, const std::string& place) {
  if (!element.hasAttribute(attribute))
    throw InputError(place + ": <" + element.getTag() + "> has no attribute \"" + attribute + "\"");
  return element.getAttribute(attribute);
}

void read_list(const Teuchos::XMLObject& element, const std::string& place, Teuchos::ParameterList& list) {
  for (int i = 0; i < element.numChildren(); ++i) {
    const Teuchos::XMLObject& child = element.getChild(i);
    const std::string& tag = child.getTag();
    if (tag == "Validators") continue;  // Teuchos writes an empty one
    if (tag != "Parameter" && tag != "ParameterList")
      throw InputError(fmt::format("{}: <{}> is neither <Parameter> nor <ParameterList>", place, tag));
    const std::string name = required(child, "name", place);
    std::string path = place;
    path.append(place.back() == ':' ? " " : "/").append(name);
    if (list.isParameter(name)) throw InputError(path + " is given twice");
    if (tag == "ParameterList") {
      read_list(child, path, list.sublist(name));
      continue;
    }
    const std::string type = required(child, "type", path);
    const std::string text = required(child, "value", path);
    try {
      set_from_text(list, name, type, text);
    } catch (const InputError& error) {
      throw InputError(path + ": " + error.what());
    }
  }
}

Teuchos::ParameterList read(const Teuchos::XMLInputSource& source, const std::string& origin) {
  Teuchos::XMLObject root;
  try {
    root = source.getObject();
  } catch (const std::exception& error) {
    throw InputError(origin + ": " + last_paragraph(error.what()));
  }
  if (root.getTag() != "ParameterList")
    throw InputError(origin + ": the outermost element is <" + root.getTag() + ">, not <ParameterList>");
  Teuchos::ParameterList list;
  if (root.hasAttribute("name")) list.setName(root.getAttribute("name"));
  read_list(root, origin + ":", list);
  return list;
}

/// In a free-form list, the first type that the text spells.
void set_as_it_looks(Teuchos::ParameterList& list, const std::string& name, const std::string& text) {
  for (const char* type : {"int", "double", "bool", "string"}) {
    try {
      return set_from_text(list, name, type, text);
    } catch (const InputError&) {
      continue;
    }
  }
}

}  // namespace

Teuchos::ParameterList read_scene_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw InputError(path + ": the scene file cannot be read");
  return read_scene_text(text.str(), path);
}

Teuchos::ParameterList read_scene_text(const std::string& xml, const std::string& origin) {
  return read(Teuchos::StringInputSource(xml), origin);
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
    if (known != nullptr) known = valid_sublist(*known, name, "--set " + path);
    if (list->isParameter(name) && !list->isSublist(name))
      throw InputError(fmt::format("--set {}: {} is a parameter of the scene, not a list", path, name));
    list = &list->sublist(name);
    start = slash + 1;
  }
  const std::string name = path.substr(start);
  try {
    if (known == nullptr || is_free_form(*known)) return set_as_it_looks(*list, name, text);
    set_from_text(*list, name, type_name(valid_entry(*known, name, path)), text);
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

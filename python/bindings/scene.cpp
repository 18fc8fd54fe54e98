// Scenes: lists of parameters that are read, changed, completed and written; what the catalogues say about them.
#include <pybind11/stl.h>

#include <Teuchos_Array.hpp>
#include <filesystem>

#include "bindings.hpp"
#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/validation.hpp"
#include "scene/explain/documentation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {

std::string SceneList::folder() const { return std::filesystem::path(file).parent_path().string(); }

namespace {

using List = Teuchos::ParameterList;
using Path = std::vector<std::string>;

template <class T>
py::list elements(const Teuchos::ParameterEntry& entry) {
  py::list result;
  for (const T& value : Teuchos::getValue<Teuchos::Array<T>>(entry)) result.append(py::cast(value));
  return result;
}

py::object value(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return py::float_(Teuchos::getValue<double>(entry));
  if (entry.isType<int>()) return py::int_(Teuchos::getValue<int>(entry));
  if (entry.isType<bool>()) return py::bool_(Teuchos::getValue<bool>(entry));
  if (entry.isType<std::string>()) return py::str(Teuchos::getValue<std::string>(entry));
  if (entry.isType<Teuchos::Array<double>>()) return elements<double>(entry);
  if (entry.isType<Teuchos::Array<int>>()) return elements<int>(entry);
  if (entry.isType<Teuchos::Array<std::string>>()) return elements<std::string>(entry);
  return py::str(value_text(entry));
}

/// Returns what the valid list says, as nested dictionaries.
py::dict described(const List& valid) {
  py::dict parameters, lists;
  for (const auto& [name, entry] : entries(valid)) {
    if (is_free_form(valid)) break;
    if (entry.isList()) {
      py::dict inner = described(valid.sublist(name));
      inner["documentation"] = entry.docString();
      lists[py::str(name)] = inner;
      continue;
    }
    py::dict parameter;
    parameter["type"] = type_name(entry);
    parameter["default"] = is_required(entry) ? py::none() : value(entry);
    parameter["allowed"] = allowed(entry);
    parameter["documentation"] = entry.docString();
    const auto& validator = entry.validator();
    if (!validator.is_null() && !validator->validStringValues().is_null()) {
      const auto& words = *validator->validStringValues();
      parameter["words"] = std::vector<std::string>(words.begin(), words.end());
    }
    parameter["chooses"] = choice_behind(validator) != nullptr;
    parameters[py::str(name)] = parameter;
  }
  py::dict result;
  result["parameters"] = parameters;
  result["lists"] = lists;
  result["free_form"] = is_free_form(valid);
  return result;
}

/// Returns the list at a path; null if the scene does not have it.
List* find(SceneList& scene, const Path& path) {
  List* list = &scene.list;
  for (const std::string& name : path) {
    if (!list->isSublist(name)) return nullptr;
    list = &list->sublist(name);
  }
  return list;
}

std::string joined(const Path& path, const std::string& name = "") {
  std::string result;
  for (const std::string& word : path) result += word + "/";
  return name.empty() ? result.substr(0, result.size() - (path.empty() ? 0 : 1)) : result + name;
}

/// Makes the list at a path. Throws InputError if no list may stand there.
std::pair<List*, const List*> make(SceneList& scene, const Path& path) {
  List* list = &scene.list;
  const List* known = &scene_parameters();
  Path here;
  for (const std::string& name : path) {
    here.push_back(name);
    if (known != nullptr) known = valid_sublist(lists_of(*known, scene_parameters()), name, joined(here));
    check_name(name);
    if (list->isParameter(name) && !list->isSublist(name))
      throw InputError(joined(here) + " is a parameter of the scene, not a list");
    list = &list->sublist(name);
  }
  return {list, known};
}

/// Sets a value in the type of the valid entry, and leaves what belongs to other choices to the validation.
void put(SceneList& scene, const Path& path, const std::string& name, const std::string& text) {
  const auto [list, known] = make(scene, path);
  if (known == nullptr || is_free_form(*known))
    return set_parameter(scene.list, scene_parameters(), joined(path, name) + "=" + text);
  try {
    set_from_text(*list, name, type_name(valid_entry(*known, name, joined(path, name))), text);
  } catch (const InputError& error) {
    const std::string what = error.what(), place = joined(path, name);
    throw InputError(what.rfind(place, 0) == 0 ? what : place + ": " + what);
  }
}

}  // namespace

void bind_scene(py::module_& module) {
  module.def("scene_parameters", [] { return described(scene_parameters()); });
  py::class_<SceneList>(module, "SceneList", "A scene as its user wrote it. ixos.Scene is made of one.")
      .def(py::init([](const std::string& name) {
             return SceneList{List(name), ""};
           }),
           py::arg("name") = "Scene")
      .def_static("read",
                  [](const std::string& path) {
                    return SceneList{read_scene_file(path), path};
                  })
      .def_static("parse",
                  [](const std::string& xml, const std::string& origin) {
                    return SceneList{read_scene_text(xml, origin), ""};
                  })
      .def_static("template",
                  [](const std::string& name) {
                    return SceneList{read_scene_text(scene_template(name), name), ""};
                  })
      .def("copy", [](const SceneList& scene) { return scene; })
      .def("assign", [](SceneList& scene, const SceneList& other) { scene = other; })
      .def_readwrite("file", &SceneList::file)
      .def_property(
          "name", [](const SceneList& scene) { return scene.list.name(); },
          [](SceneList& scene, const std::string& name) { scene.list.setName(name); })
      .def("set", [](SceneList& scene,
                     const std::string& assignment) { set_parameter(scene.list, scene_parameters(), assignment); })
      .def("put", &put)
      .def("make", [](SceneList& scene, const Path& path) { make(scene, path); })
      .def("has_list", [](SceneList& scene, const Path& path) { return find(scene, path) != nullptr; })
      .def("names",
           [](SceneList& scene, const Path& path) {
             std::vector<std::string> names;
             if (const List* list = find(scene, path); list != nullptr)
               for (const auto& item : *list) names.push_back(item.first);
             return names;
           })
      .def("get",
           [](SceneList& scene, const Path& path, const std::string& name) -> py::object {
             const List* list = find(scene, path);
             if (list == nullptr || !list->isParameter(name) || list->isSublist(name)) return py::none();
             return value(list->getEntry(name));
           })
      .def("remove",
           [](SceneList& scene, const Path& path, const std::string& name) {
             List* list = find(scene, path);
             return list != nullptr && list->remove(name, false);
           })
      .def("check_name",
           [](const SceneList&, const Path& path, const std::string& name) {
             const List* known = &scene_parameters();
             Path here;
             for (const std::string& word : path) {
               here.push_back(word);
               if (known != nullptr) known = valid_sublist(lists_of(*known, scene_parameters()), word, joined(here));
             }
             if (known != nullptr && !is_free_form(*known)) valid_entry(*known, name, joined(path, name));
           })
      .def("complete",
           [](const SceneList& scene) {
             return at_scene(scene.file, {}, [&] { return SceneList{complete_scene(scene.list), scene.file}; });
           })
      .def("text", [](const SceneList& scene) { return scene_text(scene.list); })
      .def("write", [](const SceneList& scene, const std::string& path) { write_scene_file(scene.list, path); });
}

}  // namespace ixos::python

/// A scene's parameter list in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos::python {

/// A scene as its user wrote it, and its file for messages and for mesh files beside it.
struct SceneList {
  Teuchos::ParameterList list;
  std::string file;  ///< empty if the scene has no file

  std::string folder() const;
};

/// Runs a function. An InputError that it throws gets the scene's file before its message, as the command prints it.
template <class Function>
auto at_scene(const std::string& file, const std::vector<std::string>& other_places, const Function& function);

}  // namespace ixos::python

#include "base/error.hpp"
#include "scene/read/placed_message.hpp"

template <class Function>
auto ixos::python::at_scene(const std::string& file, const std::vector<std::string>& other_places,
                            const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(placed_message(error.what(), file, other_places));
  }
}

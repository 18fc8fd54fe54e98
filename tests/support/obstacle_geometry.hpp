/// Entries of catalogues with the values that they need.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <map>
#include <string>

#include "parameters/validation.hpp"
#include "support/catalogue_walk.hpp"
#include "test_folders.hpp"

namespace ixos::test {

/// Gives an obstacle's list what its defaults lack. A height field has the file tests/interaction/hills.txt.
inline void set_geometry(Teuchos::ParameterList& own, const Teuchos::ParameterList& parameters) {
  const std::map<std::string, double> numbers{{"Radius", 2.0}, {"Amplitude", 0.15}, {"Period", 8.0}};
  for (const auto& [name, value] : numbers)
    if (parameters.isParameter(name)) own.set(name, value);
  if (!parameters.isParameter("File")) return;
  own.set("File", std::string(IXOS_TEST_DIRECTORY "/interaction/hills.txt"));
  own.set("Spacing", Teuchos::Array<double>(Teuchos::tuple<double>(0.25, 1.0)));
}

/// Returns the list of an entry of a catalogue with its required parameters and the numbers that are given.
template <class Catalogue>
Teuchos::ParameterList complete(const Catalogue& catalogue, const std::string& name,
                                const std::map<std::string, double>& given = {}) {
  Teuchos::ParameterList valid, user;
  catalogue.declare(valid);
  user.set(catalogue.choice(), name);
  for (const auto& entry : catalogue.entries()) {
    if (entry.name != name) continue;
    Teuchos::ParameterList& own = entry.in_place ? user : user.sublist(name);
    for (const auto& [parameter, value] : given) own.set(parameter, value);
    set_geometry(own, entry.parameters);
    fill_required(own, entry.parameters);
  }
  return validated(user, valid);
}

}  // namespace ixos::test

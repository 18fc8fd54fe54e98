/// The schemes by the names that scenes and literature use.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <string>
#include <vector>

#include "time/table.hpp"

namespace ixos {

/// One scheme: its name, the facts that a user should know, its parameters with defaults, ranges and documentation, and
/// the function that makes its table. The XML validators, the driver's list and the documentation are all made from
/// this.
struct Scheme {
  std::string name;
  std::string order;
  std::string stability;
  std::string conserves;
  std::string cost;  ///< relative to Newmark's method (docs/results/ball.md has the measurements)
  std::string citation;
  Teuchos::ParameterList parameters;
  std::function<Table(const Teuchos::ParameterList&)> table;
};

const std::vector<Scheme>& schemes();

/// Returns "Custom": the table that a scene defines itself (see custom_table). Not one of schemes().
const Scheme& custom_scheme();

/// Returns the name of the scheme of a scene that names none.
const char* default_scheme();

/// Returns the scheme of that name, or the custom one. Throws InputError with the nearest name.
const Scheme& scheme(const std::string& name);

}  // namespace ixos

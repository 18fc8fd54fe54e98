/// The histories that a scene may choose.
#pragma once
#include <memory>
#include <string>

#include "histories/time_function.hpp"
#include "parameters/catalogue.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {

/// An entry makes a function of time from its parameters.
using HistoryEntry = CatalogueEntry<std::shared_ptr<const TimeFunction>>;

/// Returns the catalogue; its choice is "Type".
const Catalogue<HistoryEntry>& histories();

/// Returns the documentation of a history's value, whose unit depends on its use. `what` has no full stop.
std::string history_value(const std::string& what);

/// Returns the documentation of a choice that makes a value or a rate jump. `what` has no full stop.
std::string history_jump(const std::string& what);

}  // namespace ixos

/// A table that a user defines.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "time/table.hpp"

namespace ixos {

/// Returns the list's parameters with defaults and documentation; its list "Stages" has one list for each stage, in
/// order.
Teuchos::ParameterList custom_parameters();

/// Returns the table of a validated list. A row is an array {s, p_0, q_0, r_0, p_1, q_1, r_1, ...}, for the stage's
/// unknown and the known states from the step's start on (see Row). Throws std::invalid_argument, with stage and entry,
/// if an array has the wrong length or a stage has no implicit part; check() tests the meaning of the rows and rules.
Table custom_table(const Teuchos::ParameterList& list);

}  // namespace ixos

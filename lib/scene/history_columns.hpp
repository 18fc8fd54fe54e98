/// The columns of history.csv.
#pragma once
#include <string>
#include <vector>

#include "scene/simulation.hpp"

namespace ixos {

/// The energy that jumps of a quasi-static body to other equilibria have released so far: a column of a run one of
/// whose stages has no inertia, with a value in all its rows. It belongs to the run, not to a state: history_columns()
/// does not have it.
inline constexpr const char* released_column = "released_energy";

/// The energy that changes of the mesh have added so far, of a run whose mesh follows the front; likewise of the run.
inline constexpr const char* adapted_column = "adapted_energy";

struct HistoryColumns {
  std::vector<std::string> names;      ///< in the order of a row
  std::vector<std::string> reactions;  ///< those that are forces of node sets, then of grips, in the same order
};

/// Returns the columns of a simulation with a model and probes. Throws InputError, with the path of the list, if a name
/// would repeat a column or cannot head one. Equal on all ranks.
HistoryColumns history_columns(const Simulation& simulation);

}  // namespace ixos

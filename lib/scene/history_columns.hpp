/// The columns of history.csv.
#pragma once
#include <string>
#include <vector>

#include "scene/simulation.hpp"

namespace ixos {

/// The energy that jumps of a quasi-static body to other equilibria have released so far: the last column of a
/// simulation without inertia, which has a value in the rows of all stages. No number of a HistoryRow.
inline constexpr const char* released_column = "released_energy";

struct HistoryColumns {
  std::vector<std::string> names;      ///< in the order of a row
  std::vector<std::string> reactions;  ///< those that are forces of node sets, then of grips, in the same order
};

/// Returns the columns of a simulation with a model and probes. Throws InputError, with the path of the list, if a name
/// would repeat a column or cannot head one. Equal on all ranks.
HistoryColumns history_columns(const Simulation& simulation);

}  // namespace ixos

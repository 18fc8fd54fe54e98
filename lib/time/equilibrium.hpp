/// Quasi-static steps without an equilibrium.
#pragma once
#include <string>

#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Returns whether dead loads grow in a step of length dt from `start`: forces that are no springs'; false if there are
/// springs, whose drives the model does not tell from loads. Collective.
bool load_grows(const Model& model, const State& start, double dt);

/// Returns why a quasi-static step from the equilibrium `start` failed, for the user: the load up to which
/// equilibria were found, the remedy, and `detail`, what Newton's method says. The load is the sum of the magnitudes
/// of the nodal forces [E0 L0^(D-1)]. If only supports move, it names the time. Collective.
std::string no_equilibrium(const Model& model, const State& start, double dt, const std::string& detail);

}  // namespace ixos

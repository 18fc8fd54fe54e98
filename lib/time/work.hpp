/// Work over a step, of loads and reactions.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "time/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns the work of loads and reactions over the step whose start and stage ends are `states` [E0 L0^D], as the
/// table's WorkSum says: with it the energy balance of the scheme closes up to its own error. If driven degrees of
/// freedom have the exact rates of their motion instead of the rows', d = (v_n + v)/2 - du/dt and e = dv - dt (a_n +
/// a)/2 do not vanish there, and EndMean adds d . M dv + du . M e/dt. Collective.
double work_of_external_forces(const Model& model, const Table& table, const std::vector<State>& states, double dt);

/// Returns the work of moved obstacles over that step, which begins at `time` [E0 L0^D]. Increment: along the path of
/// the interaction's mean force, see Interaction::obstacle_work(); with a mean that is no sum of points the balance
/// closes exactly. EndMean and Stages: the power of the forces in the states that the table's sum weighs. Collective.
double work_of_obstacles(const Model& model, const Table& table, const std::vector<State>& states, double time,
                         double dt);

}  // namespace ixos

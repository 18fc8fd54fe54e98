/// Work over a step, of loads and reactions.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns the work of loads and reactions over the step whose start and stage ends are `states` [E0 L0^D], as the
/// table's WorkSum says: with it the energy balance of the scheme closes up to its own error. If driven degrees of
/// freedom have the exact rates of their motion instead of the rows', d = (v_n + v)/2 - du/dt and e = dv - dt (a_n +
/// a)/2 do not vanish there, and EndMean adds d . M dv + du . M e/dt. Collective.
double work_of_external_forces(const Model& model, const Table& table, const std::vector<State>& states, double dt);

/// Returns a bound of the energy by which a step that conserves energy up to its residual moves the balance [E0 L0^D].
/// `residual`: bound of the norm of the residual that Newton's method leaves; `force`: the largest norm of its parts.
///
/// The residual's work over the step is r . (u1 - u0) <= |r| |u1 - u0|. It is not small against all energies if the
/// step is long against the period of a cell, or u is large against its change: then |r|, which is relative to the
/// forces and to the rounding of u, does more work in the step than the energies suggest. Besides, the energies of both
/// ends are those of rounded displacements: eps u moves each part by eps |f| |u|, eight parts of two rows by 16 times
/// as much.
double unbalanced_work(const Model& model, double residual, double force, const std::vector<double>& u0,
                       const std::vector<double>& u1);

/// Returns the work of moved obstacles over that step [E0 L0^D]. Increment: along the path of
/// the interaction's mean force, see ObstacleMotion::work(); with a mean that is no sum of points the balance
/// closes exactly. EndMean and Stages: the power of the forces in the states that the table's sum weighs. Collective.
double work_of_obstacles(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                         const StepMemories& step);

}  // namespace ixos

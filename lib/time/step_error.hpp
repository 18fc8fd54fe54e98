/// The local error of a step, by which adaptive step control judges it.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// The velocity at the start of the step before, for divided differences; without it, the acceleration is used.
struct PreviousVelocity {
  std::vector<double> v;  ///< local [L0/T0]
  bool known = false;     ///< whether the start of such a step was kept; the same on all ranks
  double dt = 0;          ///< length of that step [T0]
};

/// Returns the largest local error of a displacement in the step whose start and stage ends are `states`: the table's
/// error constant times dt^3 u''' [L0] (Zienkiewicz and Xie 1991 for Newmark's method; Bank et al. 1985 for two
/// stages). u''' is twice a divided difference of velocities: those of the step before, of the start and of the end. If
/// the table has two stages, it uses the three velocities of the step itself; in a first step, the start's velocity and
/// acceleration and the end's velocity. Derivative nodes and prescribed degrees of freedom do not count. If
/// history_error() is larger, returns that. Collective.
double local_error(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                   const PreviousVelocity& previous);

}  // namespace ixos

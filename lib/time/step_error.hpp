/// How far a step went wrong: what adaptive step control judges.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "time/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// The velocity at the start of the step before, for divided differences; without one, the acceleration serves.
struct PreviousVelocity {
  std::vector<double> v;  ///< local [L0/T0]
  bool known = false;     ///< was there a step whose start was kept? The same on all ranks
  double dt = 0;          ///< length of that step [T0]
};

/// The largest local error of a displacement in the step whose start and stage ends are `states`: the table's error
/// constant times dt^3 u''' [L0] (Zienkiewicz and Xie 1991 for Newmark's method; Bank et al. 1985 for two stages). u'''
/// is twice a divided difference of velocities: of those of the step before, of the start and of the end; where the
/// table has two stages, of its own three; in a first step of the start's velocity and acceleration, and of the end's.
/// Derivative nodes and prescribed
/// degrees of freedom do not count. Collective.
double local_error(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                   const PreviousVelocity& previous);

}  // namespace ixos

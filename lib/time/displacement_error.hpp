/// The local error of a step by displacements alone.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// Displacements at the starts of the two steps before the present one, and the lengths of these steps, the later one
/// first.
struct PastDisplacements {
  const std::vector<double>&later, &earlier;
  double later_dt, earlier_dt;
};

/// Returns the local error as local_error() does, with u''' from six times the third divided difference of the
/// displacements at the starts of the two steps before and at both ends of the step. Velocities of momentum-form
/// schemes ring from step to step, v_n+1 = 2 (u_n+1 - u_n)/dt - v_n, and divided differences of them are then no
/// derivatives. Collective.
double displacement_error(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                          const PastDisplacements& past);

}  // namespace ixos

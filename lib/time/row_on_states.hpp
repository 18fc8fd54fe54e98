/// Rows evaluated on states.
#pragma once
#include <vector>

#include "time/row.hpp"
#include "time/state.hpp"

namespace ixos {

/// Sets result = the row without its unknown part s (u_s - u_0). Since a consistent row is zero for a constant u,
/// displacements enter as differences from u_0: at small steps they agree in most digits, and the differences are
/// exact. States that the row does not use may be empty. All arrays are local and of the size of `result`.
void evaluate_known(const Row& row, const std::vector<State>& states, double dt, std::vector<double>& result);

/// Sets result = s (u - u_0) + known.
void evaluate(const Row& row, const std::vector<double>& u, const std::vector<double>& u0,
              const std::vector<double>& known, std::vector<double>& result);

}  // namespace ixos

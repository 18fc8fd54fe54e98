/// Rows evaluated on states.
#pragma once
#include <vector>

#include "rule/row.hpp"

namespace ixos {

/// A state whose time is past: local arrays of displacement [L0], velocity [L0/T0] and acceleration [L0/T0^2]. Arrays
/// that no row uses may be null.
struct KnownState {
  const double* u = nullptr;
  const double* v = nullptr;
  const double* a = nullptr;
  double time = 0;  ///< [T0]
};

/// Sets result = the row without its unknown part s (u_s - u_0). Since a consistent row is zero for a constant u,
/// displacements enter as differences from u_0: at small steps they agree in most digits, and the differences are
/// exact. All arrays are local and of the size of `result`.
void evaluate_known(const Row& row, const std::vector<KnownState>& states, double dt, std::vector<double>& result);

/// Sets result = s (u - u_0) + known, s the row's coefficient of the unknown.
void evaluate(double s, const double* u, const double* u0, const std::vector<double>& known,
              std::vector<double>& result);

}  // namespace ixos

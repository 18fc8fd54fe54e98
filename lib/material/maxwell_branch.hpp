/// Maxwell branches beside an elastic law.
#pragma once
#include <cmath>

namespace ixos {

/// A neo-Hookean spring of shear modulus mu in series with a dashpot of viscosity mu tau, beside the elastic law (Simo
/// and Miehe 1992; Reese and Govindjee 1998). It is isochoric: with Cb = J^(-2/3) C it stores mu/2 [tr(Cb Ci^-1) - 3].
/// The strain Ci of the dashpot, det Ci = 1, is its history; it follows Ci' = [Cb - tr(Cb Ci^-1)/3 Ci]/tau from Ci = I.
/// At small strain, and strain held constant, its stress relaxes as exp(-t/tau).
struct MaxwellBranch {
  double modulus = 0;  ///< mu [E0]
  double time = 0;     ///< tau [T0]
};

/// How the history follows a step of length dt.
enum class HistoryUpdate {
  BackwardEuler,  ///< from the strain at the step's end: no step dissipates less than 0
  SecondOrder     ///< from the strain in the middle: for steps shorter than about tau/3
};

/// A step at small strains: Cb - Ci at its end is `lag` times that at its start plus `change` times the change of Cb.
struct HistoryStep {
  double lag, change;
};

/// Returns those of a step of x = dt/tau.
inline HistoryStep history_step(double x, HistoryUpdate update) {
  if (update == HistoryUpdate::BackwardEuler) return {1 / (1 + x), 1 / (1 + x)};
  const double s = x * (1 + x / 2);
  return {1 / (1 + s), (1 + s / 2) / (1 + s)};
}

/// Returns those of the exact step in which Cb changes at a constant rate.
inline HistoryStep exact_history_step(double x) { return {std::exp(-x), -std::expm1(-x) / x}; }

}  // namespace ixos

/// The strip as a beam: an independent computation of its quasi-static pull-off.
#pragma once
#include <vector>

#include "interaction/van_der_waals.hpp"

namespace ixos::test {

/// A straight strip under plane strain as a Timoshenko beam, geometrically linear, per unit depth. Its bottom interacts
/// with a plane wall over 0 <= X <= adhering, at the gap r_eq + w(X) with w the deflection away from the wall. The end
/// X = 0 is free; the end X = length does not rotate. An infinite shear correction is the Euler-Bernoulli beam.
struct BeamOnWall {
  double length = 200, height = 10, adhering = 150;  ///< [L0]
  double youngs_modulus = 1;                         ///< [E0]
  double poissons_ratio = 0.2;
  double shear_correction = 5.0 / 6;
  int elements = 320;
};

/// A state of equilibrium.
struct PullOff {
  double displacement;        ///< w(length) [L0]
  double force;               ///< the reaction conjugate to it [E0 L0]
  double contact_length;      ///< where the gap is below that of largest attraction [L0]
  double elastic_energy;      ///< [E0 L0^2]
  double interaction_energy;  ///< against the wall at infinity [E0 L0^2]
  double wall_force;          ///< on the beam, away from the wall [E0 L0]
};

/// States of least energy, each followed from the one before, at the displacements 0, step, 2 step, ... up to the end
/// or to the first state without contact. Throws std::runtime_error where Newton's method does not converge.
std::vector<PullOff> peel(const BeamOnWall& beam, const VanDerWaals& law, double displacement_step,
                          double displacement_end);

}  // namespace ixos::test

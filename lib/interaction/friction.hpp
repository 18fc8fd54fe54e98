/// The settings of friction.
#pragma once

namespace ixos {

enum class FrictionType { None, ConstantStress, ExtendedAmontons, Smoothed };

/// How a surface that interacts resists slip along its obstacle.
struct Friction {
  FrictionType type = FrictionType::None;
  double stress = 0;        ///< tau of Constant Stress [E0]
  double sharpness = 0;     ///< k of Constant Stress [1/L0]; 0: a jump
  double coefficient = 0;   ///< mu of the others [-]
  double cutoff_share = 1;  ///< c in [0, 1]
  double stiffness = 0;     ///< eps of the elastic slip [E0/L0], 0: FrictionLaw chooses it; Smoothed has none
  double slip_speed = 0;    ///< eps_v of Smoothed [L0/T0]
  bool current = false;     ///< the threshold of a step is that at its end, otherwise that at its start
};

}  // namespace ixos

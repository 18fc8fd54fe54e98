/// Warnings about a run after its end.
#pragma once
#include <vector>

#include "base/warning.hpp"
#include "run/contact_watch.hpp"
#include "run/front_watch.hpp"
#include "run/jump_watch.hpp"
#include "run/strain_watch.hpp"

namespace ixos {

/// Measures of a finished run.
struct RunFacts {
  bool has_inertia = true;
  int body_dimension = 3;
  double energy_error = 0;    ///< see History::max_energy_error [E0 L0^D]
  double largest_energy = 0;  ///< see History::largest_energy
  StrainExtremes strains{};
  double first_scaled_jacobian = 1;  ///< of the mesh, see MeshQuality
  long crossings = 0;                ///< steps in which a surface crossed its obstacle
  double deepest = 0;                ///< the least gap of laws that are defined at every gap [L0]
  double scale = 0;                  ///< the least equilibrium gap of those laws [L0]; 0: there are none
  Detachment fall{};
  double largest_measure = 0;  ///< of contact [L0^(D-1)]
  double face_measure = 0;     ///< of the finest surface [L0^(D-1)]; 0: there is none
  Ripple ripple{};
  JumpSums jumps{};         ///< of a quasi-static run
  double friction_lag = 0;  ///< mean change of the threshold in a step over the threshold, by the work of friction
  FrontSteps front{};
  double relaxation_error = 0;  ///< see RelaxationWatch::share()
  int relaxation_order = 1;     ///< of that error in the step: the least of the bodies with branches
};

/// Returns what may be wrong with the run: the list in run_warnings.cpp, at most one warning of each kind.
std::vector<Warning> run_warnings(const RunFacts& facts);

}  // namespace ixos

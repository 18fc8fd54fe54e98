/// Reports of Maxwell branches on a step.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// The stress of one body with Maxwell branches after a step: roots of integrals over the reference volume of squares
/// at small strains [E0 L0^(D/2)].
struct HistoryStress {
  HistoryUpdate update = HistoryUpdate::BackwardEuler;
  std::vector<double> times;     ///< of relaxation, by branch [T0]
  std::vector<double> branches;  ///< of each branch
  double sum = 0;                ///< of all branches
  double all = 0;                ///< of the branches and the deviator of the elastic law: a bound
};

/// Returns the local error of a step that comes from the histories of Maxwell branches, as a displacement [L0]: the
/// root mean square, over the bodies with branches, of the error of stress over the shear modulus at once, times the
/// longest side of the box around the mesh. 0 without branches. Collective.
double history_error(const Model& model, const Segment& step);

/// Returns the stress of each body with Maxwell branches after the step that was accepted last. Collective if there
/// are any.
std::vector<HistoryStress> history_stresses(const Model& model, const TermHistories& histories);

}  // namespace ixos

/// A watch on the error of the time step in the stress of Maxwell branches.
#pragma once
#include <vector>

#include "base/record.hpp"
#include "model/branch_reports.hpp"

namespace ixos {

/// Sums the local errors of steps to the error of the branches' stress. At small strains a step takes a branch's stress
/// L_n to L_n+1 = lag L_n + change dL, the exact step has the factors e = exp(-x) and r, x = dt/tau (see HistoryStep).
/// With b = 1 - r/change and k = (lag - e) r/change the error is
///
///   E_n = b L_n + A_n,   A_n+1 = e A_n + k L_n
///
/// for equal steps. The watch has the size of a body's stress, not its components; it takes the larger of |b L| and
/// |b L + A|. |b L + A| is exact for a stress that keeps its direction, for example in relaxation, and zero for a
/// constant one. |b L| is the size of the error in vibrations.
class RelaxationWatch {
 public:
  /// Takes part in an accepted step of length dt.
  void step(const std::vector<HistoryStress>& bodies, double dt);

  /// Returns the mean of the error over that of the stress, branches and elastic deviator [-]; 0 without stress. The
  /// weight of a step is its length times the stress of the branches.
  double share() const { return stress_ > 0 ? error_ / stress_ : 0.0; }

  /// For checkpoints.
  void transfer(Record& record);

 private:
  struct Branch {
    double stress = 0, sum = 0, factor = 0;  ///< L, A and b of the step before
  };

  std::vector<Branch> branches_;   ///< of all bodies
  double error_ = 0, stress_ = 0;  ///< weighted sums over the steps
};

}  // namespace ixos

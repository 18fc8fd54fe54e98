/// A watch on the way of the contact's front in a step.
#pragma once
#include "base/record.hpp"

namespace ixos {

/// How far the front moved in the steps of recorded rows.
struct FrontSteps {
  double zone = 0;  ///< the shortest cohesive zone [L0]
  double way = 0;   ///< mean way in a step of the rows whose steps are longer than the zone [L0]
  long moving = 0;  ///< rows in which the front moved
  long fast = 0;    ///< among them: rows in which it moved by more than the zone in a step, on average
};

/// Compares the change of the contact measure between two rows with the cohesive zone. Its way is that change over the
/// steps between, in three dimensions also over the rim of a disk of the contact's area. That a body comes into contact
/// or leaves it as a whole, or by more than half of its contact, is no motion of a front.
class FrontWatch {
 public:
  /// `zone`: the cohesive zone [L0]; 0: looks for nothing. `dimension`: of the body.
  FrontWatch(double zone, int dimension) : front_{zone, 0, 0, 0}, dimension_(dimension) {}

  /// Takes part in a row after so many steps: contact measure (NaN if it is not recorded).
  void row(long steps, double measure);
  FrontSteps front() const;

  /// For checkpoints.
  void transfer(Record& record);

 private:
  FrontSteps front_;  ///< `way`: the sum
  int dimension_;
  long steps_ = 0;      ///< of the row before
  double measure_ = 0;  ///< of the row before [L0^(D-1)]
};

}  // namespace ixos

/// The clocks of a run.
#pragma once
#include "base/phase_timer.hpp"
#include "base/record.hpp"

namespace ixos {

/// The seconds that a run has taken, those before a restart included.
class RunClock {
 public:
  /// Begins at zero.
  RunClock() { reset(); }
  void reset();

  double seconds() const;       ///< of wall time
  PhaseSeconds phases() const;  ///< of this rank

  /// For checkpoints. Returns the seconds that the record holds.
  double transfer(Record& record);

 private:
  double start_ = 0;
  PhaseSeconds phases_start_{};
};

}  // namespace ixos

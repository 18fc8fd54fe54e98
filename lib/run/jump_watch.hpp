/// A watch on quasi-static rows: a body that snaps to another equilibrium releases energy at once.
#pragma once
#include <limits>

#include "base/record.hpp"

namespace ixos {

/// A jump between two rows of a quasi-static run.
struct Jump {
  double released = 0;      ///< energy that no work and no dissipation accounts for [E0 L0^D]; 0: there was no jump
  double from = 0, to = 0;  ///< times of the rows [T0]
};

/// All jumps of a run.
struct JumpSums {
  long count = 0;
  double released = 0;  ///< by all of them [E0 L0^D]
  Jump largest{};
};

/// Finds jumps. Between two equilibria of one path the balance (energy less external work plus dissipation)
/// moves by the error of the trapezoid rule alone. A jump lowers the balance by the energy that a dynamic run turns
/// into motion: at least half of the work of the interval. Stored and dissipated energy fall together, too, which they
/// do not where a contact begins within the interval.
class JumpWatch {
 public:
  /// Takes part in a row: balance and external work so far, and the run's largest energy [E0 L0^D]; NaN without
  /// energies. A jump that releases less than a thousandth of that energy is none. Returns the jump before this row.
  Jump row(double time, double balance, double external_work, double largest_energy);
  const JumpSums& jumps() const { return jumps_; }
  /// Counts on from the jumps of a run that ends; its last row is no row of this one.
  void go_on_from(const JumpSums& before) { jumps_ = before; }

  /// For checkpoints.
  void transfer(Record& record);

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double time_ = 0, balance_ = none, work_ = 0;  ///< of the row before
  JumpSums jumps_;
};

}  // namespace ixos

/// Counts of the work of iterative linear solvers.
#pragma once

namespace ixos {

/// Counts of the work that the iterative solvers of a factory did so far.
struct LinearStatistics {
  long iterations = 0;
  long setups = 0;  ///< of preconditioners
};

}  // namespace ixos

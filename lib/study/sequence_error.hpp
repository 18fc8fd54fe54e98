/// Errors of a sequence of ever finer runs, without a reference.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// A run of a sequence: a size, such as a time step or a cell's length, and the number that the run yields.
struct SequencePoint {
  double size = 0;
  double value = 0;
};

/// The errors of a sequence.
struct SequenceErrors {
  /// The number at size 0: extrapolated if the sequence is asymptotic, else that of the finest point.
  double limit = 0;
  double limit_uncertainty = 0;  ///< a bound of the limit's own error
  bool asymptotic = false;       ///< whether the differences fall as a power of the size
  double order = 0;              ///< of that power; 0 if the sequence is not asymptotic
  std::vector<double> errors;    ///< a bound of |value - exact value| of each point, in the order of the points
  std::string reason;            ///< why the sequence is taken to be asymptotic or not, as a part of a sentence
};

/// Estimates the errors of points, the coarsest first, whose sizes fall.
///
/// Three points q1, q2, q3 give an order p and a limit by Richardson's extrapolation: q = limit + C h^p. The sequence
/// counts as asymptotic if its last two differences have the same sign, and p is in the range of orders that
/// discretisations have. With four points, the three coarsest ones must agree on p, within a half of it. With three,
/// p counts as at most 2, because one order alone may be a coincidence. The uncertainty is a quarter of the estimated
/// error, after Roache's grid convergence index (Roache 1994).
///
/// Otherwise the error of the finest point is at most the largest difference of neighbours, each reduced in proportion
/// to the size: this holds for a sequence whose errors fall at least in proportion to the size, and also for one that
/// oscillates. A sequence of two points is bounded in this way.
///
/// Each error is at least that of every finer point: a coarse value near the limit is a coincidence.
///
/// Throws std::invalid_argument for fewer than two points, or sizes that do not fall.
SequenceErrors sequence_errors(const std::vector<SequencePoint>& points);

/// Returns bounds of the errors of points against a limit that another sequence knows to within `uncertainty`. Each is
/// at least that of every finer point.
std::vector<double> errors_against(const std::vector<SequencePoint>& points, double limit, double uncertainty);

/// Returns the error to expect at a size. Between two points it is that of the coarser one; beyond the finest, it falls
/// with the order of the sequence, or in proportion to the size; beyond the coarsest, it is infinite.
double error_at(const std::vector<SequencePoint>& points, const SequenceErrors& errors, double size);

}  // namespace ixos

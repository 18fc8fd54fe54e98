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
  /// The number at size 0: extrapolated if there is an order, else that of the finest point.
  double limit = 0;
  double limit_uncertainty = 0;  ///< a bound of the limit's own error
  bool asymptotic = false;       ///< whether two triples of points agree on the order
  double order = 0;              ///< of the error in the size; 0 if no triple gives one
  std::vector<double> errors;    ///< a bound of |value - exact value| of each point, in the order of the points
  std::string reason;            ///< why the sequence is taken to be asymptotic or not, as a part of a sentence
};

/// Estimates the errors of points, the coarsest first, whose sizes fall.
///
/// Three points q1, q2, q3 give an order p and a limit by Richardson's extrapolation, q = limit + C h^p, if their two
/// differences have the same sign and p is in the range of orders that discretisations have. The sequence counts as
/// asymptotic if the three points before the finest confirm p within a fifth of it. The uncertainty of the limit is
/// half of the estimated error of the finest point then. An order of three points alone may be a coincidence: it counts
/// as at most 2, and the uncertainty is twice the estimated error, so that the error of the finest point is three times
/// the estimate. Roache (1994) takes the same factor for two grids.
///
/// Without an order, the error of the finest point is at most 1.5 times the largest difference of neighbours, each
/// reduced in proportion to the size: this holds for a sequence whose errors fall at least in proportion to the size,
/// and also for one that oscillates. A sequence of two points is bounded in this way. If
/// `may_fall_slowly` and the last two differences have the same sign and fall more slowly, with the power 0.4 or more,
/// the bound grows to what is left with that power: meshes converge slowly before edges. With `may_fall_slowly`, the
/// last two differences therefore tell how slowly; earlier ones are reduced with the square of the size.
///
/// Each error is at least that of every finer point: a coarse value near the limit is a coincidence.
///
/// Throws std::invalid_argument for fewer than two points, or sizes that do not fall.
SequenceErrors sequence_errors(const std::vector<SequencePoint>& points, bool may_fall_slowly = false);

/// Returns bounds of the errors of points against a limit that another sequence knows to within `uncertainty`. Each is
/// at least that of every finer point.
std::vector<double> errors_against(const std::vector<SequencePoint>& points, double limit, double uncertainty);

/// Returns the error to expect at a size. Between two points it is that of the coarser one; beyond the finest, it falls
/// with the order of an asymptotic sequence, else in proportion to the size; beyond the coarsest, it is infinite.
double error_at(const std::vector<SequencePoint>& points, const SequenceErrors& errors, double size);

}  // namespace ixos

/// The length of each step.
#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// The limits of an adaptive step; 0: no limit.
struct AdaptiveOptions {
  bool on = false;
  double tolerance = 0;      ///< largest local error of a displacement [L0]
  double gap_ratio = 0;      ///< largest ratio of the gaps that a point of a surface has in one step
  bool time_points = false;  ///< choose the number of points in time of the interaction by the gap ratio
  double safety = 0.9;       ///< factor on the length that just meets the limits
  double growth = 2;         ///< largest ratio of a length to the one before
};

/// The times of a run and the limits of its steps.
struct StepControlOptions {
  double initial_time = 0;  ///< [T0], as all times here
  double final_time = 0;
  double time_step = 0;                                           ///< nominal; adaptive: the first
  int maximum_cuts = 0;                                           ///< halvings that a success has not made up for
  double minimum_step = 0;                                        ///< a cut may not go below
  double maximum_step = std::numeric_limits<double>::infinity();  ///< adaptive
  AdaptiveOptions adaptive{};
  std::vector<double> output_intervals{};  ///< steps end at the multiples of each, counted from the initial time
};

/// The measures of a converged step.
struct StepJudgement {
  double error = 0;      ///< see local_error()
  double gap_ratio = 1;  ///< see TermSums::gap_ratio()
};

/// Fixed: steps of nominal length on a fixed grid of times. A failed step is halved; after a step that succeeds the
/// length grows again by two, never beyond the next time of the grid, which so is hit whatever was cut.
///
/// Adaptive: the length follows the local error by a PI controller (Gustafsson 1991; Hairer and Wanner 1996, IV.8, for
/// an error of third order) and the gap ratio, whose logarithm grows with the step. A step that exceeds what is asked
/// is done again, shorter; the step after it does not grow.
///
/// Both end steps at the times of output, exactly; adaptive steps close to one share what is left evenly.
class StepControl {
 public:
  explicit StepControl(const StepControlOptions& options);

  /// Has the final time been reached, up to rounding?
  bool done(double time) const;
  /// The length of the step from `time`. `stable` says how much of a wanted length is stable, if anything limits it:
  /// the wanted length is then divided evenly.
  double next(double time, const std::function<double(double)>& stable = {}) const;
  void succeeded();
  /// False where no further cut is allowed. Adaptive runs cut down to least().
  bool cut(double failed_step);

  /// Adaptive runs: is the step of length dt good enough? Sets the next length either way.
  bool accepts(double dt, const StepJudgement& judgement);
  /// The shortest step that a run takes: the minimum of the options, and no less than rounding allows.
  double least() const;
  /// Adaptive runs: whether the length that is wanted next is below what is allowed; `why` it was wanted.
  bool exhausted(std::string& why) const;

  /// For checkpoints.
  void transfer(Record& record);

 private:
  double room(double time) const;

  StepControlOptions options_;
  double length_;
  int cuts_ = 0;
  double last_error_ = 0;  ///< of the last good step over what is aimed at, 0 where there was none
  bool rejected_ = false;
  StepJudgement judgement_;
};

/// The number of Gauss points in time that integrate an interaction to 1e-5 of the work of adhesion over a step with
/// that ratio of gaps: 5 up to 1.4, 8 up to 2, else 16.
int time_points(double gap_ratio);

}  // namespace ixos

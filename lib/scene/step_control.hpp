/// The length of each step.
#pragma once

namespace ixos {

struct StepControlOptions {
  double initial_time = 0;
  double final_time = 0;
  double time_step = 0;     ///< nominal
  int maximum_cuts = 0;     ///< halvings that a success has not made up for
  double minimum_step = 0;  ///< a cut may not go below
};

/// Steps of nominal length on a fixed grid of times. A failed step is halved; after a step that succeeds the length
/// grows again by two, never beyond the next time of the grid, which so is hit whatever was cut.
class StepControl {
 public:
  explicit StepControl(const StepControlOptions& options) : options_(options), length_(options.time_step) {}

  /// Has the final time been reached? A remainder below a thousandth of a step is rounding, not a step.
  bool done(double time) const;
  /// The length of the step from `time`.
  double next(double time) const;
  void succeeded();
  /// False where no further cut is allowed.
  bool cut(double failed_step);

 private:
  StepControlOptions options_;
  double length_;
  int cuts_ = 0;
};

}  // namespace ixos

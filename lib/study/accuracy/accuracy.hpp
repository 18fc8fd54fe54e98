/// Runs of a scene with ever finer steps, until its quantities are within an accuracy.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/accuracy/accuracy_settings.hpp"
#include "study/common/asked_quantity.hpp"

namespace ixos {

struct AccuracyQuestion {
  std::vector<AskedQuantity> quantities;
  double accuracy =
      0.01;  ///< largest relative error of each quantity; of one that is itself an error, the largest value
};

/// Good: the run ended as it should, or failed after the times that decide the quantities. Failed: it ended before
/// these. NoValue: a quantity has none.
enum class AccuracyOutcome { Good, NoValue, Failed, Interrupted };

struct AccuracyRun {
  AccuracySettings settings;
  AccuracyOutcome outcome = AccuracyOutcome::Good;
  std::string problem;  ///< why the run failed or is not good, as a part of a sentence
  long steps = 0;
  double end_time = 0;         ///< [T0]
  double mean_step = 0;        ///< [T0]
  double seconds = 0;          ///< with the set-up
  std::vector<double> values;  ///< by quantity; empty unless good
};

/// The last good run's error of a quantity.
struct AchievedAccuracy {
  double value = 0;
  double error = 0;       ///< relative to the exact value as the runs tell it; infinite if that may be 0
  std::string reason;     ///< how the error is known, see SequenceErrors::reason
  double mesh_error = 0;  ///< the part of the error that is the mesh's, see AccuracyResult::mesh_is_judged
};

/// Kept: all quantities are within the accuracy in the last run. Missed: they are not. NoRun: no run gave values, or
/// too few to estimate errors.
enum class AccuracyStatus { Kept, Missed, NoRun, Interrupted };

struct AccuracyResult {
  AccuracyStatus status = AccuracyStatus::Interrupted;
  std::vector<AccuracyRun> runs;
  std::vector<AchievedAccuracy> achieved;  ///< by quantity; empty if it cannot be estimated
  std::string limit;                       ///< what ended the refinement of an accuracy that is not kept
  bool mesh_is_judged = false;             ///< a run on a finer mesh told the error of the mesh
};

/// Carries out a run with these settings, which leaves its results where the last run's belong.
using CarryOut = std::function<AccuracyRun(const AccuracySettings&)>;

/// Halves the steps from run to run, and estimates the errors of three runs and more by sequence_errors(), whose sizes
/// are the mean steps. A run that took hardly more steps than the one before, because something else bounds them, takes
/// its place, and the next run's longest step is half of its mean one. Ends with the first run that keeps the accuracy,
/// if refinement no longer reduces the errors, if runs fail, or after ten runs.
///
/// A mesh that follows the front is judged after the steps: runs with the same steps and finer meshes, up to four of
/// them, until the error by the steps and the last change of the value by the mesh together are within the accuracy.
/// That change bounds the error of the finer mesh if errors at least halve with the size of the cells.
AccuracyResult run_to_accuracy(const AccuracyQuestion& question, const AccuracySettings& first,
                               const CarryOut& carry_out);

/// Returns the estimates for the last of the good runs, the coarsest first, whose mean steps fall. At least two.
std::vector<AchievedAccuracy> achieved_accuracy(const AccuracyQuestion& question, const std::vector<AccuracyRun>& runs);

}  // namespace ixos

#include "study/accuracy/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "study/common/sequence_error.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Returns the error as a part of the exact value, if that is away from 0.
double relative(double error, double limit) {
  if (error == 0) return 0;
  return error < std::abs(limit) ? error / std::abs(limit) : std::numeric_limits<double>::infinity();
}

/// Returns the largest change between neighbours, each reduced in proportion to the steps, over the last value. Unlike
/// an extrapolated error, it cannot be small by coincidence in one run and large again in the next.
double relative_change(const std::vector<AccuracyRun>& runs, std::size_t quantity) {
  const AccuracyRun& last = runs.back();
  double largest = 0;
  for (std::size_t i = 1; i < runs.size(); ++i)
    largest = std::max(largest, std::abs(runs[i].values[quantity] - runs[i - 1].values[quantity]) * last.mean_step /
                                    runs[i].mean_step);
  if (largest == 0) return 0;
  return largest / std::abs(last.values[quantity]);  // infinite for a last value of 0
}

double largest_error(const std::vector<AchievedAccuracy>& achieved) {
  double largest = 0;
  for (const AchievedAccuracy& each : achieved) largest = std::max(largest, each.error);
  return largest;
}

/// Whether changes from run to run still fall.
class Progress {
 public:
  /// Takes part in a run. Returns whether several in a row brought nothing.
  bool has_ended(double change) {
    without_ = change < tuning::progress * least_ ? 0 : without_ + 1;
    least_ = std::min(least_, change);
    return without_ >= tuning::most_without_progress;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int without_ = 0;
};

/// The good runs that differ in their steps, and whether their errors still fall.
class Sequence {
 public:
  explicit Sequence(const AccuracyQuestion& question) : question_(question) {}

  /// Adds a good run. Returns whether its steps are shorter than those of the run before.
  bool add(const AccuracyRun& run) {
    bool is_finer = true;
    while (!runs_.empty() && runs_.back().mean_step < tuning::refinement * run.mean_step) {
      runs_.pop_back();
      is_finer = false;
    }
    runs_.push_back(run);
    return is_finer;
  }

  bool can_judge() const { return runs_.size() >= tuning::least_runs; }

  /// Judges the last run. Returns what ended the refinement; empty if it may go on.
  std::string judge(std::vector<AchievedAccuracy>& achieved) {
    achieved = achieved_accuracy(question_, runs_);
    double change = 0;
    for (std::size_t q = 0; q < achieved.size(); ++q)
      if (achieved[q].error > question_.accuracy)
        change = std::max(change, question_.quantities[q].is_error() ? achieved[q].error : relative_change(runs_, q));
    if (!progress_.has_ended(change)) return "";
    return "shorter steps no longer reduce the error: the motion may be chaotic, or the quantity may jump or be 0";
  }

 private:
  const AccuracyQuestion& question_;
  std::vector<AccuracyRun> runs_;
  Progress progress_;
};

/// Judges the mesh of the last run, which keeps the accuracy by its steps, by runs with finer ones.
void judge_mesh(const AccuracyQuestion& question, AccuracySettings settings, const CarryOut& carry_out,
                AccuracyResult& result) {
  const std::vector<AchievedAccuracy> by_steps = result.achieved;
  Progress progress;
  result.status = AccuracyStatus::Missed;
  for (int finer = 0; result.limit.empty(); ++finer) {
    if (finer == tuning::most_finer_meshes || !has_finer_mesh(settings)) {
      result.limit = fmt::format("the mesh, with Mesh/Adapt/Levels = {} and Part = {:.3g}", settings.mesh.levels,
                                 settings.mesh.part);
      return;
    }
    settings = with_finer_mesh(settings);
    const std::vector<double> before = result.runs.back().values;
    AccuracyRun run;
    try {
      run = carry_out(settings);
    } catch (const InputError& error) {  // a mesh with too many cells, for example
      result.limit = fmt::format("a finer mesh cannot be made: {}", error.what());
      return;
    }
    result.runs.push_back(run);
    if (run.outcome == AccuracyOutcome::Interrupted) {
      result.status = AccuracyStatus::Interrupted;
      return;
    }
    if (run.outcome != AccuracyOutcome::Good) {
      result.limit = "the run on a finer mesh: " + run.problem;
      return;
    }
    result.mesh_is_judged = true;
    double change = 0;
    for (std::size_t q = 0; q < result.achieved.size(); ++q) {
      AchievedAccuracy& own = result.achieved[q];
      own.value = run.values[q];
      const bool is_error = question.quantities[q].is_error();
      own.mesh_error = is_error ? 0 : relative(std::abs(own.value - before[q]), own.value);
      own.error = (is_error ? std::abs(own.value) : by_steps[q].error) + own.mesh_error;
      if (own.error > question.accuracy) change = std::max(change, is_error ? own.error : own.mesh_error);
    }
    if (largest_error(result.achieved) <= question.accuracy) {
      result.status = AccuracyStatus::Kept;
      return;
    }
    if (progress.has_ended(change))
      result.limit =
          "finer meshes no longer reduce the error: cells that Mesh/Adapt leaves as they are may be too coarse";
  }
}

}  // namespace

std::vector<AchievedAccuracy> achieved_accuracy(const AccuracyQuestion& question,
                                                const std::vector<AccuracyRun>& runs) {
  std::vector<AchievedAccuracy> all;
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    AchievedAccuracy own;
    own.value = runs.back().values[q];
    if (question.quantities[q].is_error()) {
      own.error = std::abs(own.value);
      own.reason = "the quantity is an error itself";
    } else {
      std::vector<SequencePoint> points;
      points.reserve(runs.size());
      for (const AccuracyRun& run : runs) points.push_back({run.mean_step, run.values[q]});
      const SequenceErrors errors = sequence_errors(points);
      own.error = relative(errors.errors.back(), errors.limit);
      own.reason = errors.reason;
    }
    all.push_back(own);
  }
  return all;
}

AccuracyResult run_to_accuracy(const AccuracyQuestion& question, const AccuracySettings& first,
                               const CarryOut& carry_out) {
  AccuracyResult result;
  Sequence sequence(question);
  AccuracySettings settings = first;
  int failures = 0;
  while (result.limit.empty()) {
    const AccuracyRun run = carry_out(settings);
    result.runs.push_back(run);
    settings = refined(settings, 0.5);
    if (run.outcome == AccuracyOutcome::Interrupted) return result;
    if (run.outcome != AccuracyOutcome::Good) {
      if (++failures == tuning::most_failed_runs) result.limit = run.problem;
    } else {
      if (!sequence.add(run)) settings.longest_step = std::min(settings.longest_step, 0.5 * run.mean_step);
      if (sequence.can_judge()) {
        result.limit = sequence.judge(result.achieved);
        if (largest_error(result.achieved) <= question.accuracy) {
          result.limit.clear();
          result.status = AccuracyStatus::Kept;
          if (run.settings.mesh.levels > 0) judge_mesh(question, run.settings, carry_out, result);
          return result;
        }
      }
    }
    if (result.limit.empty() && result.runs.size() == tuning::most_runs)
      result.limit = fmt::format("{} runs are the most that one command makes", tuning::most_runs);
  }
  result.status = result.achieved.empty() ? AccuracyStatus::NoRun : AccuracyStatus::Missed;
  return result;
}

}  // namespace ixos

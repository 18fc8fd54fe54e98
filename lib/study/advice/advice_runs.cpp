#include "study/advice/advice_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "study/advice/advice_models.hpp"
#include "study/common/history_table.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Settings of all runs: nothing but the history is needed.
const Assignments without_fields{"Output/Fields Interval=0", "Output/Fields Time Interval=0"};
const char* const with_strains = "Output/Strains=true";

/// Fills in the quantities of a sample and their columns. Throws InputError if the run does not have one.
void read_quantities(const RunHistory& history, const std::vector<AskedQuantity>& quantities, AdviceSample& sample) {
  std::vector<ColumnHistory> columns;
  double decided = -std::numeric_limits<double>::infinity();
  for (const AskedQuantity& quantity : quantities) {
    sample.values.push_back(quantity.value(history));
    columns.push_back(quantity.history(history));
    decided = std::max(decided, columns.back().decided);
  }
  sample.good = std::all_of(sample.values.begin(), sample.values.end(), [](double v) { return std::isfinite(v); });
  if (!sample.good) sample.reason = "a quantity is no number";
  sample.histories = std::make_shared<const std::vector<ColumnHistory>>(std::move(columns));
  sample.strains = measured_strains(history.table(), decided);
}

/// Returns the sample of a run, without its point. A run that failed has its quantities, too, if it failed after the
/// times that decide them.
AdviceSample read_sample(const RunPool& pool, const StudyRun& run, const std::vector<AskedQuantity>& quantities) {
  const RunRecord record = pool.record(run);
  AdviceSample sample;
  sample.reason = record.reason;
  sample.refused = record.refused;
  sample.seconds = record.cpu_seconds;
  // Wall-clock time leaves out the start, processor time leaves out the waiting of a busy machine.
  const double seconds = std::min(record.wall_seconds, record.cpu_seconds);
  sample.seconds_per_step = seconds / static_cast<double>(std::max(1L, record.steps));
  sample.dofs = static_cast<double>(record.dofs);
  sample.steps = static_cast<double>(record.steps + record.rejected_steps);
  sample.reached_end = record.reached_its_end();
  if (!sample.reached_end && !record.failed_with_rows()) return sample;
  try {
    const RunHistory history(pool.folder(run));
    if (!sample.reached_end && !are_decided(quantities, history)) return sample;
    read_quantities(history, quantities, sample);
    sample.failed_later = !sample.reached_end && sample.good;
  } catch (const InputError& error) {
    if (sample.reached_end) sample.reason = error.what();
  } catch (const FileError&) {
    if (sample.reached_end) throw;  // a run that failed may have left no rows
  }
  return sample;
}

}  // namespace

AdviceRuns::AdviceRuns(const AdviceQuestion& question, const AdviceOptions& options, const AdviceDirections& directions)
    : question_(question), options_(options), directions_(directions), pool_(pool_of(question.scene)) {}

RunPool AdviceRuns::pool_of(const std::string& scene) const {
  return RunPool({options_.folder + "/runs", scene, options_.driver, options_.version, 0, options_.interrupted, true});
}

StudyRun AdviceRuns::run_of(const AdvicePoint& point) const {
  StudyRun run{name_of(directions_, point), {description_of(directions_, point)}, question_.common};
  for (const Assignments& more : {without_fields, settings_of(directions_, point)})
    run.settings.insert(run.settings.end(), more.begin(), more.end());
  if (has_other_laws(directions_)) run.settings.emplace_back(with_strains);
  return run;
}

void AdviceRuns::run(const std::vector<StudyRun>& runs, RunPool& pool) {
  if (budget_ > 0)
    pool.limit_time(std::max(0.0, budget_ - spent_) + tuning::grace_seconds);
  else
    pool.limit_time(0);
  const bool complete = pool.carry_out(runs, options_.jobs, [&](std::size_t number, bool reused) {
    const RunRecord record = pool.record(runs[number]);
    spent_ += record.cpu_seconds;
    if (options_.log)
      options_.log(fmt::format("{}: {}, {:.3g} s{}", runs[number].labels.front(),
                               record.status + (record.reason.empty() ? "" : ": " + record.reason), record.cpu_seconds,
                               reused ? " (reused)" : ""));
  });
  if (!complete) throw Interrupted();
}

void AdviceRuns::check_columns(const AdvicePoint& point) const {
  const HistoryTable table(pool_.folder(run_of(point)) + "/history.csv");
  for (const AskedQuantity& quantity : question_.quantities) quantity.check_columns(table.names());
}

void AdviceRuns::carry_out(const std::vector<AdvicePoint>& points) {
  std::vector<AdvicePoint> missing;
  std::vector<StudyRun> runs;
  for (const AdvicePoint& point : points) {
    if (sample(point) != nullptr || std::find(missing.begin(), missing.end(), point) != missing.end()) continue;
    missing.push_back(point);
    runs.push_back(run_of(point));
  }
  run(runs);
  const std::size_t before = samples_.size();
  for (std::size_t i = 0; i < runs.size(); ++i) samples_.push_back(sample_of(missing[i], runs[i]));
  for (std::size_t i = before; i < samples_.size(); ++i) compare_models(directions_, samples_, samples_[i]);
}

AdviceSample AdviceRuns::in_another_scene(const AdviceQuestion& other, StudyRun there, const Assignments& settings) {
  there.settings = other.common;
  for (const Assignments& more : {without_fields, settings})
    there.settings.insert(there.settings.end(), more.begin(), more.end());
  RunPool pool = pool_of(other.scene);
  run({there}, pool);
  AdviceSample sample = read_sample(pool, there, other.quantities);
  if (sample.reached_end && !sample.good) throw InputError(sample.reason);
  return sample;
}

AdviceSample AdviceRuns::sample_of(const AdvicePoint& point, const StudyRun& run) const {
  AdviceSample sample = read_sample(pool_, run, question_.quantities);
  sample.point = point;
  return sample;
}

std::vector<double> AdviceRuns::perturbed(const AdvicePoint& point) {
  if (directions_.perturbation.empty()) return {};
  StudyRun run = run_of(point);
  run.name += "_perturbed";
  run.labels = {fmt::format("{}, perturbed by {}", run.labels.front(), tuning::perturbation_size)};
  run.settings.insert(run.settings.end(), directions_.perturbation.begin(), directions_.perturbation.end());
  this->run({run});
  return sample_of(point, run).values;
}

const AdviceSample* AdviceRuns::sample(const AdvicePoint& point) const {
  const auto found =
      std::find_if(samples_.begin(), samples_.end(), [&](const AdviceSample& each) { return each.point == point; });
  return found == samples_.end() ? nullptr : &*found;
}

}  // namespace ixos

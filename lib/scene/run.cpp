#include "scene/run.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_Time.hpp>
#include <cmath>
#include <filesystem>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "scene/field_recorder.hpp"
#include "scene/history.hpp"
#include "scene/scene_file.hpp"
#include "scene/summary.hpp"

namespace ixos {
namespace {

/// Makes the results folder and effective.xml on rank 0; throws on all ranks alike.
void open_folder(const Simulation& simulation, const std::string& folder) {
  const Comm& comm = simulation.model().space().comm();
  together(comm, [&] {
    if (comm->getRank() != 0) return;
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw FileError("the results folder cannot be used: " + folder + ": " + code.message());
    // What an earlier run left is not this one's.
    std::filesystem::remove(folder + "/summary.json");
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().rfind("fields.e", 0) == 0) std::filesystem::remove(entry.path());
    write_scene_file(simulation.parameters(), folder + "/effective.xml");
  });
}

bool asked_to_stop(const RunOptions& options, const Comm& comm) {
  if (!options.interrupted) return false;
  int stop = options.interrupted() ? 1 : 0;
  if (comm->getSize() == 1) return stop != 0;
  int any = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MAX, 1, &stop, &any);
  return any != 0;
}

/// Which steps are recorded: every so many, or those that pass a multiple of a time interval.
class Recording {
 public:
  Recording(int steps, double interval, double start) : steps_(steps), interval_(interval), start_(start) {}
  bool any() const { return steps_ > 0 || interval_ > 0; }
  bool due(long step, double before, double now) const {
    if (interval_ == 0) return steps_ > 0 && step % steps_ == 0;
    const double slack = 1e-9 * (now - start_);
    return std::floor((now - start_ + slack) / interval_) > std::floor((before - start_ + slack) / interval_);
  }

 private:
  long steps_;
  double interval_;
  double start_;
};

/// Does the attempted step keep what an adaptive run asks? Tells the control, and sets the number of points in time.
bool good_enough(Integrator& integrator, const AdaptiveOptions& asked, double dt, StepControl& control) {
  StepJudgement judgement;
  if (asked.tolerance > 0) judgement.error = integrator.error();
  if (asked.gap_ratio > 0 || asked.time_points) judgement.gap_ratio = integrator.gap_ratio();
  const int used = integrator.table().interaction_points;
  if (asked.time_points && used > 0) {
    const int needed = time_points(judgement.gap_ratio);
    integrator.set_interaction_points(needed);
    if (needed > used) return false;  // the same step again
  }
  return control.accepts(dt, judgement);
}

}  // namespace

RunResult run(Simulation& simulation, const RunOptions& options) {
  const Comm& comm = simulation.model().space().comm();
  Integrator& integrator = simulation.integrator();
  const Teuchos::ParameterList& output = simulation.parameters().sublist("Output");
  const StepControlOptions times = simulation.step_control();
  StepControl control(times);
  StopCriteria stop = simulation.stop_criteria();
  open_folder(simulation, options.folder);
  History history(simulation,
                  {output.get<bool>("Energies"), output.get<bool>("Momenta"), output.get<bool>("Interaction")},
                  options.folder + "/history.csv");
  const double first_time = integrator.time();
  const Recording rows(output.get<int>("History Interval"), output.get<double>("History Time Interval"), first_time);
  const Recording frames(output.get<int>("Fields Interval"), output.get<double>("Fields Time Interval"), first_time);
  const double start = Teuchos::Time::wallTime();
  const auto phases_before = phase_seconds();

  std::unique_ptr<FieldRecorder> fields;
  if (frames.any()) {
    fields = std::make_unique<FieldRecorder>(simulation, options.folder + "/fields.e");
    fields->record();
  }

  std::function<double(double)> stable;
  if (is_explicit(integrator.table())) stable = [&](double wanted) { return integrator.stable_step(wanted); };
  RunResult result;
  RowCounts counts;
  history.record(counts);
  stop.reason(simulation.model(), integrator.state());  // the criteria's memory of the beginning
  bool recorded = true;
  bool framed = true;
  while (result.status == RunStatus::Completed && !control.done(integrator.time())) {
    if (asked_to_stop(options, comm)) {
      result.status = RunStatus::Interrupted;
      result.reason = "interrupted by a signal";
      break;
    }
    const double before = integrator.time();
    const double dt = control.next(before, stable);
    if (!(dt >= control.least()) && control.next(before) >= control.least()) {
      result.status = RunStatus::Diverged;
      result.reason =
          fmt::format("the stable step, {:.3g} T0, is below the least allowed, {:.3g}", dt, control.least());
      break;
    }
    const StepResult step = integrator.attempt(dt);
    counts.newton_iterations += step.newton_iterations;
    counts.linear_iterations += step.linear_iterations;
    result.linear_iterations += step.linear_iterations;
    result.newton_iterations += step.newton_iterations;
    counts.wall_seconds = Teuchos::Time::wallTime() - start;
    if (!step.converged) {
      ++result.rejected_steps;
      if (control.cut(dt)) continue;
      result.status = RunStatus::Diverged;
      result.reason = step.reason;
      break;
    }
    if (times.adaptive.on && !good_enough(integrator, times.adaptive, dt, control)) {
      ++result.rejected_steps;
      if (!control.exhausted(result.reason)) continue;
      result.status = RunStatus::Diverged;
      break;
    }
    integrator.accept();
    control.succeeded();
    ++result.steps;
    counts.step = result.steps;
    counts.time_step = dt;
    result.reason = stop.reason(simulation.model(), integrator.state());
    if (!result.reason.empty()) result.status = RunStatus::Stopped;
    recorded = rows.due(result.steps, before, integrator.time());
    if (recorded) {
      history.record(counts);
      counts.newton_iterations = 0;
      counts.linear_iterations = 0;
    } else {
      history.pass();
    }
    framed = frames.due(result.steps, before, integrator.time());
    if (fields && framed) fields->record();
    if (options.watch && comm->getRank() == 0)
      options.watch({integrator.time(), times.final_time, result.steps, result.newton_iterations, counts.wall_seconds});
  }
  if (!recorded) history.record(counts);  // the last state always
  if (fields && !framed) fields->record();
  history.flush();
  result.end_time = integrator.time();
  result.wall_seconds = Teuchos::Time::wallTime() - start;
  result.max_energy_error = history.max_energy_error();
  result.max_forces = history.max_forces();
  const auto phases_now = phase_seconds();
  for (std::size_t i = 0; i < phases_now.size(); ++i) result.phase_seconds[i] = phases_now[i] - phases_before[i];
  write_summary(simulation, result, options.folder + "/summary.json");
  return result;
}

}  // namespace ixos

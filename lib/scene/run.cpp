#include "scene/run.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_Time.hpp>
#include <cmath>
#include <filesystem>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "scene/checkpoints.hpp"
#include "scene/field_recorder.hpp"
#include "scene/history.hpp"
#include "scene/restart.hpp"
#include "scene/scene_file.hpp"
#include "scene/summary.hpp"

namespace ixos {
namespace {

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

HistoryOptions history_options(const Teuchos::ParameterList& output) {
  return {output.get<bool>("Energies"), output.get<bool>("Momenta"), output.get<bool>("Interaction")};
}

/// One run, from its beginning or a checkpoint to its end.
class Run {
 public:
  Run(Simulation& simulation, const RunOptions& options)
      : simulation_(simulation),
        options_(options),
        comm_(simulation.model().space().comm()),
        integrator_(simulation.integrator()),
        output_(simulation.parameters().sublist("Output")),
        times_(simulation.step_control()),
        control_(times_),
        stop_(simulation.stop_criteria()),
        history_(simulation, history_options(output_)),
        rows_(output_.get<int>("History Interval"), output_.get<double>("History Time Interval"), times_.initial_time),
        frames_(output_.get<int>("Fields Interval"), output_.get<double>("Fields Time Interval"), times_.initial_time),
        checkpoints_(simulation, options.folder) {
    if (frames_.any()) fields_ = std::make_unique<FieldRecorder>(simulation, options.folder + "/fields.e");
    if (is_explicit(integrator_.table())) stable_ = [this](double wanted) { return integrator_.stable_step(wanted); };
  }

  RunResult execute() {
    phases_before_ = phase_seconds();
    start_ = Teuchos::Time::wallTime();
    if (options_.restart.empty())
      begin();
    else
      go_on();
    try {
      while (result_.status == RunStatus::Completed && !control_.done(integrator_.time())) {
        if (interlude()) step();
      }
      end();
    } catch (const FileError& error) {
      throw FileError(with_position(error.what()));
    }
    return result_;
  }

 private:
  void begin();
  void begin_files();
  void go_on();
  void resume_files();
  void open_folder(bool keep_fields);
  bool interlude();
  void step();
  bool good_enough(double dt);
  void record(double before);
  void end();
  void checkpoint();
  std::string with_position(const std::string& message) const;
  void transfer(Record& record);
  void tell(const std::string& line) const {
    if (options_.tell && comm_->getRank() == 0) options_.tell(line);
  }
  std::string history_path() const { return options_.folder + "/history.csv"; }
  double wall() const { return Teuchos::Time::wallTime() - start_; }
  void fail(const std::string& reason) {
    result_.status = RunStatus::Diverged;
    result_.reason = reason;
  }

  Simulation& simulation_;
  const RunOptions& options_;
  const Comm& comm_;
  Integrator& integrator_;
  const Teuchos::ParameterList& output_;
  StepControlOptions times_;
  StepControl control_;
  StopCriteria stop_;
  History history_;
  std::unique_ptr<FieldRecorder> fields_;
  Recording rows_, frames_;
  Checkpoints checkpoints_;
  std::function<double(double)> stable_;

  RunResult result_;
  RowCounts counts_;
  bool recorded_ = true;      ///< has the present state a row?
  bool framed_ = true;        ///< and a frame?
  FieldLength field_length_;  ///< in the folder of the checkpoint that was loaded
  double start_ = 0;          ///< of the clock, less the seconds before a restart
  std::array<double, phase_names.size()> phases_before_{};
};

/// Makes the folder and effective.xml on rank 0; what an earlier run left is not this one's. Throws on all ranks alike.
void Run::open_folder(bool keep_fields) {
  on_first_rank(comm_, [&] {
    std::error_code code;
    std::filesystem::create_directories(options_.folder, code);
    if (code) throw FileError("the results folder cannot be used: " + options_.folder + ": " + code.message());
    for (const auto& entry : std::filesystem::directory_iterator(options_.folder)) {
      const std::string name = entry.path().filename().string();
      if (name != "summary.json" && (keep_fields || name.rfind("fields.e", 0) != 0)) continue;
      std::filesystem::remove(entry.path(), code);
      if (code) throw FileError(entry.path().string() + ": cannot be replaced: " + code.message());
    }
    write_scene_file(simulation_.parameters(), options_.folder + "/effective.xml");
  });
}

void Run::begin() {
  begin_files();
  stop_.reason(simulation_.model(), integrator_.state());  // the criteria's memory of the beginning
}

/// New files, which begin with the present state.
void Run::begin_files() {
  open_folder(false);
  const long earlier = checkpoints_.begin();
  if (earlier >= 0 && checkpoints_.on())
    tell(fmt::format("{} has checkpoints of an earlier run, up to step {}: the first of this run takes their place.",
                     options_.folder, earlier));
  history_.create(history_path());
  if (fields_) {
    fields_->create();
    fields_->record();
  }
  history_.record(counts_);
  counts_.newton_iterations = 0;
  counts_.linear_iterations = 0;
  recorded_ = framed_ = true;
}

void Run::go_on() {
  Restart restart(simulation_, options_.restart);
  restart.load([this](Record& record) { transfer(record); });
  ++result_.restarts;
  if (restart.is_in(options_.folder))
    resume_files();
  else
    begin_files();
  tell(fmt::format("Goes on from {}: t = {:.6g} T0, step {}.", restart.path(), integrator_.time(), result_.steps));
  for (const std::string& note : restart.notes()) tell(note);
  result_.reason = stop_.reason(simulation_.model(), integrator_.state());
  if (!result_.reason.empty()) result_.status = RunStatus::Stopped;
}

/// What is there is gone on with; nothing is changed before all of it is found to fit.
void Run::resume_files() {
  const bool same_fields = fields_ && field_length_.frames > 0;
  history_.verify(history_path());
  if (same_fields) fields_->verify(field_length_);
  open_folder(same_fields || !fields_);
  checkpoints_.resume(result_.steps);  // the link first: killed from here on, it leads to what is there
  history_.resume(history_path());
  if (same_fields) return fields_->resume(field_length_);
  if (!fields_) return;
  fields_->create();
  fields_->record();
  framed_ = true;
}

/// Between steps: checkpoints that are due, and signals. False where the run is over.
bool Run::interlude() {
  if (checkpoints_.due(result_.steps)) checkpoint();
  if (!options_.interrupted && !checkpoints_.on()) return true;
  int mine[2] = {options_.interrupted && options_.interrupted() ? 1 : 0, checkpoints_.due_by_clock() ? 1 : 0};
  int any[2] = {mine[0], mine[1]};
  if (comm_->getSize() > 1) Teuchos::reduceAll(*comm_, Teuchos::REDUCE_MAX, 2, mine, any);
  if (any[0] != 0) {
    result_.status = RunStatus::Interrupted;
    result_.reason = "interrupted by a signal";
    return false;
  }
  if (any[1] != 0) checkpoint();
  return true;
}

void Run::step() {
  const double before = integrator_.time();
  const double dt = control_.next(before, stable_);
  if (!(dt >= control_.least()) && control_.next(before) >= control_.least())
    return fail(fmt::format("the stable step, {:.3g} T0, is below the least allowed, {:.3g}", dt, control_.least()));
  const StepResult step = integrator_.attempt(dt);
  counts_.newton_iterations += step.newton_iterations;
  counts_.linear_iterations += step.linear_iterations;
  result_.linear_iterations += step.linear_iterations;
  result_.newton_iterations += step.newton_iterations;
  counts_.wall_seconds = wall();
  if (!step.converged) {
    ++result_.rejected_steps;
    if (!control_.cut(dt)) fail(step.reason);
    return;
  }
  if (times_.adaptive.on && !good_enough(dt)) {
    ++result_.rejected_steps;
    if (control_.exhausted(result_.reason)) result_.status = RunStatus::Diverged;
    return;
  }
  integrator_.accept();
  control_.succeeded();
  ++result_.steps;
  counts_.step = result_.steps;
  counts_.time_step = dt;
  result_.reason = stop_.reason(simulation_.model(), integrator_.state());
  if (!result_.reason.empty()) result_.status = RunStatus::Stopped;
  record(before);
}

/// Does the attempted step keep what an adaptive run asks? Tells the control, and sets the number of points in time.
bool Run::good_enough(double dt) {
  const AdaptiveOptions& asked = times_.adaptive;
  StepJudgement judgement;
  if (asked.tolerance > 0) judgement.error = integrator_.error();
  if (asked.gap_ratio > 0 || asked.time_points) judgement.gap_ratio = integrator_.gap_ratio();
  const int used = integrator_.table().interaction_points;
  if (asked.time_points && used > 0) {
    const int needed = time_points(judgement.gap_ratio);
    integrator_.set_interaction_points(needed);
    if (needed > used) return false;  // the same step again
  }
  return control_.accepts(dt, judgement);
}

void Run::record(double before) {
  recorded_ = rows_.due(result_.steps, before, integrator_.time());
  if (recorded_) {
    history_.record(counts_);
    counts_.newton_iterations = 0;
    counts_.linear_iterations = 0;
  } else {
    history_.pass();
  }
  framed_ = frames_.due(result_.steps, before, integrator_.time());
  if (fields_ && framed_) fields_->record();
  if (options_.watch && comm_->getRank() == 0)
    options_.watch(
        {integrator_.time(), times_.final_time, result_.steps, result_.newton_iterations, counts_.wall_seconds});
}

void Run::end() {
  // Before the last state's row and frame, where these come only because it is the last: a restart has no use for them.
  std::string problem;
  try {
    if (checkpoints_.on()) checkpoint();
  } catch (const FileError& error) {  // on all ranks; there may be room for a row and the summary
    problem = error.what();
  }
  if (!recorded_) history_.record(counts_);
  if (fields_ && !framed_) fields_->record();
  history_.flush();
  result_.end_time = integrator_.time();
  result_.wall_seconds = wall();
  result_.max_energy_error = history_.max_energy_error();
  result_.max_forces = history_.max_forces();
  result_.checkpoint = checkpoints_.newest();
  const auto phases_now = phase_seconds();
  for (std::size_t i = 0; i < phases_now.size(); ++i) result_.phase_seconds[i] += phases_now[i] - phases_before_[i];
  write_summary(simulation_, result_, options_.folder + "/summary.json");
  if (!problem.empty()) throw FileError(problem);
}

/// A message of a file that cannot be written, with what a person needs to go on.
std::string Run::with_position(const std::string& message) const {
  const std::string newest = checkpoints_.newest();
  return fmt::format(
      "{} (t = {:.6g} T0, step {}{}). {}", message, integrator_.time(), result_.steps,
      result_.reason.empty() ? "" : ": " + result_.reason,
      newest.empty() ? "There is no checkpoint to go on from" : "The newest checkpoint to go on from is " + newest);
}

void Run::checkpoint() {
  // What a restart goes on with is on the disk before the checkpoint that counts on it.
  history_.sync();
  if (fields_) fields_->sync();
  checkpoints_.write(result_.steps, [this](Record& record) { transfer(record); });
}

void Run::transfer(Record& record) {
  const Record::Section section(record, "run");
  double seconds = wall();
  const auto phases_now = phase_seconds();
  record.number("steps", result_.steps);
  record.number("rejected steps", result_.rejected_steps);
  record.number("newton iterations", result_.newton_iterations);
  record.number("linear iterations", result_.linear_iterations);
  record.number("restarts", result_.restarts);
  record.number("wall seconds", seconds);
  for (std::size_t i = 0; i < phase_names.size(); ++i) {
    double phase = result_.phase_seconds[i] + phases_now[i] - phases_before_[i];
    record.number((std::string("seconds ") + phase_names[i]).c_str(), phase);
    if (record.loading()) result_.phase_seconds[i] = phase;
  }
  record.number("time step", counts_.time_step);
  record.number("newton iterations since the row", counts_.newton_iterations);
  record.number("linear iterations since the row", counts_.linear_iterations);
  record.number("recorded", recorded_);
  record.number("framed", framed_);
  if (fields_ && !record.loading()) field_length_ = fields_->length();
  record.number("frames", field_length_.frames);
  std::vector<double> bytes{field_length_.bytes};
  if (!record.loading() || record.same_partition()) record.share("bytes of frames", bytes);
  if (record.loading()) field_length_.bytes = bytes.empty() ? 0 : bytes[0];
  if (record.loading()) {
    start_ -= seconds;
    counts_.step = result_.steps;
    counts_.wall_seconds = seconds;
  }
  integrator_.transfer(record);
  history_.transfer(record);
  stop_.transfer(record);
  // Other steps or another scheme begin with their own.
  if (!record.loading() || record.same_scene()) control_.transfer(record);
}

}  // namespace

RunResult run(Simulation& simulation, const RunOptions& options) { return Run(simulation, options).execute(); }

}  // namespace ixos

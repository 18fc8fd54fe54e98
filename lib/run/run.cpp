#include "run/run.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/memory_record.hpp"
#include "run/checkpoints.hpp"
#include "run/energy_watch.hpp"
#include "run/handover.hpp"
#include "run/replaced_results.hpp"
#include "run/restart.hpp"
#include "run/run_clock.hpp"
#include "run/run_files.hpp"
#include "run/run_measures.hpp"
#include "run/summary.hpp"
#include "scene/examine/steep_laws.hpp"
#include "scene/examine/supports.hpp"
#include "scene/examine/warnings.hpp"
#include "scene/output/output_fields.hpp"
#include "time/step_judge.hpp"

namespace ixos {
namespace {

/// The record of what watches a run, between two meshes.
class WatchRecord final : public MemoryRecord {
 public:
  using MemoryRecord::MemoryRecord;
  bool same_scene() const override { return true; }
  bool same_solution() const override { return true; }
  bool same_partition() const override { return false; }
};

/// One run, from its beginning or a checkpoint to its end.
class Run {
 public:
  Run(Simulation& simulation, const RunOptions& options)
      : simulation_(simulation),
        options_(options),
        comm_(simulation.model().space().comm()),
        integrator_(simulation.integrator()),
        times_(simulation.step_control()),
        control_(times_),
        stop_(simulation.stop_criteria()),
        checkpoints_(simulation, options.folder),
        files_(simulation, options.folder, options.scene_file),
        watch_(simulation),
        measures_(simulation),
        follower_(simulation) {
    if (options_.iterate && comm_->getRank() == 0)
      integrator_.watch(
          [this](const NewtonIterate& iterate) { options_.iterate(progress(clock_.seconds(), true, iterate)); });
    if (is_explicit(integrator_.table())) stable_ = [this](double wanted) { return integrator_.stable_step(wanted); };
  }

  ~Run() { integrator_.watch({}); }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void start() {
    clock_.reset();
    if (options_.restart.empty())
      begin();
    else
      go_on();
    begin_to_count();
  }
  /// Continues the run of another simulation: takes its result, its clock and its rows.
  void take_over(Run& before);
  /// Does the same for the same scene on another mesh: watches and criteria go on, too.
  void take_over_mesh(Run& before);
  /// Returns whether advance() returned the same scene on another mesh.
  bool has_changed_mesh() const { return on_other_mesh_ != nullptr; }
  /// Takes steps to the end and returns null, or to an exchange and returns the next simulation.
  std::shared_ptr<Simulation> advance();
  const RunResult& result() const { return result_; }

 private:
  std::shared_ptr<Simulation> exchanged() const;
  bool is_over() const { return result_.status != RunStatus::Completed || stage_is_over(); }
  bool stage_is_over() const { return !stage_ends_.empty() || control_.done(integrator_.time()); }
  std::shared_ptr<Simulation> next_stage();
  void add_findings(const std::vector<Warning>& findings);
  void begin();
  void begin_files();
  void go_on();
  void resume_files();
  void begin_to_count() {
    first_time_ = integrator_.time();
    first_seconds_ = clock_.seconds();
  }
  void look_at_criteria();
  void warn_of_jump();
  void measure_row();
  void follow(const std::function<std::shared_ptr<Simulation>()>& look);
  void transfer_watches(Record& record);
  bool interlude();
  void step();
  void end();
  Progress progress(double wall_seconds, bool within_step = false, const NewtonIterate& iterate = {}) const;
  void observe(double wall_seconds);
  void checkpoint();
  bool watch_energy();
  void go_back();
  std::string hints(const StepResult& step) const;
  std::string with_position(const std::string& message) const;
  void transfer(Record& record);
  void log(const std::string& line) const {
    if (options_.log && comm_->getRank() == 0) options_.log(line);
  }
  void warn(const std::string& line) const {
    if (options_.warn && comm_->getRank() == 0) options_.warn(line);
  }
  void fail(const std::string& reason, std::vector<Remedy> what_may_help = {}) {
    result_.status = RunStatus::Diverged;
    result_.reason = reason;
    result_.remedies = std::move(what_may_help);
  }
  void stop(const std::string& reason) {
    if (reason.empty() || result_.status != RunStatus::Completed) return;
    result_.status = RunStatus::Stopped;
    result_.reason = reason;
  }

  Simulation& simulation_;
  const RunOptions& options_;
  const Comm& comm_;
  Integrator& integrator_;
  const StepControlOptions& times_;
  StepControl control_;
  StopCriteria stop_;
  Checkpoints checkpoints_;
  RunFiles files_;
  EnergyWatch watch_;
  RunMeasures measures_;
  MeshFollower follower_;
  std::shared_ptr<Simulation> on_other_mesh_;  ///< with which the run goes on; null: none
  RunClock clock_;
  std::string resumed_from_;                   ///< the checkpoint that the watch went back to
  double attempted_ = 0;                       ///< length of the last step
  double first_time_ = 0, first_seconds_ = 0;  ///< where this process, in this simulation, began
  std::string stage_ends_;                     ///< the reason why the stage, which is not the last one, is over
  std::function<double(double)> stable_;

  RunResult result_;
};

std::shared_ptr<Simulation> Run::advance() {
  try {
    while (!is_over()) {
      if (!interlude()) continue;
      const long before = result_.steps;
      step();
      if (on_other_mesh_) return on_other_mesh_;
      if (result_.status != RunStatus::Completed || !stage_ends_.empty() || result_.steps != before + 1) continue;
      if (!is_over())
        if (auto next = exchanged()) return next;
      // At the Final Time, too, so that a restart with a later one takes the steps that a single run would have taken.
      if (!follower_.on()) continue;
      follow([this] { return follower_.adapted(result_.steps, files_.history().largest_energy()); });
      if (on_other_mesh_) return on_other_mesh_;
    }
    if (auto next = next_stage()) return next;
    end();
  } catch (const FileError& error) {
    throw FileError(with_position(error.what()));
  }
  return nullptr;
}

/// Returns the simulation of the next stage, in the state of this one; null if there is none, or it cannot begin.
std::shared_ptr<Simulation> Run::next_stage() {
  if (result_.status != RunStatus::Completed || !simulation_.has_next_stage()) return nullptr;
  if (files_.end_stage()) measure_row();
  const Stages& stages = simulation_.stages();
  const std::size_t number = simulation_.stage();
  const double time = integrator_.time(), begin = stage_ends_.empty() ? times_.final_time : time;
  log(fmt::format("Stage {} ended at t = {:.6g} T0, step {}{}{}.", stages.name(number), time, result_.steps,
                  stage_ends_.empty() ? "" : ": ", stage_ends_));
  try {
    std::shared_ptr<Simulation> next = simulation_.next_stage(begin);
    hand_over(simulation_, *next);
    result_.stages.push_back({stages.name(number), time, result_.steps, stage_ends_, begin});
    return next;
  } catch (const InputError& error) {
    fail(fmt::format("the stage {} cannot begin: {}", stages.name(number + 1), error.what()));
  }
  return nullptr;
}

/// Returns the simulation that the caller wants in place of this one, or null.
std::shared_ptr<Simulation> Run::exchanged() const {
  if (!options_.exchange) return nullptr;
  std::shared_ptr<Simulation> next;
  together(comm_, [&] { next = options_.exchange(simulation_); });
  int mine[2] = {next ? 1 : 0, next ? 0 : 1};
  int any[2] = {mine[0], mine[1]};
  if (comm_->getSize() > 1) Teuchos::reduceAll(*comm_, Teuchos::REDUCE_MAX, 2, mine, any);
  if (any[0] == 0) return nullptr;
  if (any[1] != 0) throw std::logic_error("RunOptions::exchange returned a simulation on some ranks only");
  if (simulation_.stages().any() || next->stages().any())
    throw InputError("a scene with Stages cannot be exchanged during its run, nor for another one");
  if (simulation_.adaptation().on() || next->adaptation().on())
    throw InputError("a scene with Mesh/Adapt cannot be exchanged during its run, nor for another one");
  const double now = integrator_.time(), then = next->integrator().time();
  if (then != now)
    throw InputError(
        fmt::format("the next simulation of the run stands at t = {} T0, but the run at {} T0", then, now));
  return next;
}

/// Notes the simulation on another mesh that a function of the follower returns. Ends the run if that mesh cannot be
/// made.
void Run::follow(const std::function<std::shared_ptr<Simulation>()>& look) {
  try {
    on_other_mesh_ = look();
  } catch (const InputError& error) {
    return fail(fmt::format("the mesh cannot follow the front: {}", error.what()));
  }
  constexpr const char* name = "mesh follows the front";
  const auto is_told = [&](const Warning& warning) { return warning.name == name; };
  if (const std::string problem = follower_.take_problem();
      !problem.empty() && std::none_of(result_.warnings.begin(), result_.warnings.end(), is_told)) {
    warn(problem);
    result_.warnings.push_back({name, problem});
  }
}

/// Transfers what a change of the mesh leaves as it is: criteria, watches, measures and step control.
void Run::transfer_watches(Record& record) {
  stop_.transfer(record);
  watch_.transfer(record);
  measures_.transfer(record, files_.history());
  control_.transfer(record);
}

void Run::take_over_mesh(Run& before) {
  result_ = before.result_;
  clock_ = before.clock_;
  follower_.go_on_from(before.follower_);
  try {
    files_.go_on_from(before.files_, true);
  } catch (const FileError& error) {
    throw FileError(before.with_position(error.what()));
  }
  files_.history().set_adapted(follower_.changes().energy.total());
  checkpoints_.go_on_from(before.checkpoints_);
  resumed_from_ = checkpoints_.newest();
  MemoryRecord::Values values;
  WatchRecord saving(values, 1), loading(values, 0);
  before.transfer_watches(saving);
  transfer_watches(loading);
  first_time_ = before.first_time_;
  first_seconds_ = before.first_seconds_;
}

void Run::take_over(Run& before) {
  simulation_.resumes();
  result_ = before.result_;
  clock_ = before.clock_;
  add_findings(run_warnings(before.measures_.finish(before.files_.history())));
  follower_.go_on_from(before.follower_);
  try {
    files_.go_on_from(before.files_, false);
  } catch (const FileError& error) {
    throw FileError(before.with_position(error.what()));
  }
  files_.history().set_adapted(follower_.changes().energy.total());
  checkpoints_.go_on_from(before.checkpoints_);
  resumed_from_ = checkpoints_.newest();  // of another simulation: the watch does not go back there
  measures_.row(files_.history());
  stop_.reason(simulation_.model(), integrator_.state());  // the criteria's memory of the beginning
  begin_to_count();
  const bool is_stage = simulation_.stage() > before.simulation_.stage();
  if (!is_stage)
    return log(fmt::format("The run continues with another simulation from t = {:.6g} T0, step {}.", integrator_.time(),
                           result_.steps));
  log(fmt::format("Stage {} begins: {}, time step {} T0 to t = {} T0.", simulation_.stages().name(simulation_.stage()),
                  simulation_.time_integrator().scheme, times_.time_step, times_.final_time));
  warn_of_jump();
}

/// A later finding of the same name knows more of the run.
void Run::add_findings(const std::vector<Warning>& findings) {
  for (const Warning& finding : findings) {
    std::vector<Warning>& all = result_.findings;
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Warning& old) { return old.name == finding.name; }),
              all.end());
    all.push_back(finding);
  }
}

void Run::begin() {
  begin_files();
  measures_.row(files_.history());
  stop_.reason(simulation_.model(), integrator_.state());  // the criteria's memory of the beginning
}

/// New files, which begin with the present state.
void Run::begin_files() {
  const ReplacedResults replaced = replaced_results(simulation_, options_.folder, options_.overwrite);
  if (!replaced.note.empty()) log(replaced.note);
  files_.open_folder(false);
  const long earlier = checkpoints_.begin(replaced.of_another);
  if (earlier >= 0 && checkpoints_.on())
    log(fmt::format(
        "{} has checkpoints of an earlier run, up to step {}. The first checkpoint of this run replaces them.",
        options_.folder, earlier));
  files_.create();
  watch_energy();
}

void Run::go_on() {
  simulation_.resumes();
  Restart restart(simulation_, options_.restart);
  restart.load([this](Record& record) { transfer(record); });
  ++result_.restarts;
  if (restart.is_in(options_.folder))
    resume_files();
  else
    begin_files();
  log(fmt::format("Resumes from {}: t = {:.6g} T0, step {}.", restart.path(), integrator_.time(), result_.steps));
  for (const std::string& note : restart.notes()) log(note);
  warn_of_jump();
  look_at_criteria();
}

/// A criterion that holds ends the stage.
void Run::look_at_criteria() {
  const std::string met = stop_.reason(simulation_.model(), integrator_.state());
  const bool begins = !result_.stages.empty() && result_.stages.back().steps == result_.steps;
  if (begins) return;  // as in a run without a restart, which takes a step before it asks
  if (simulation_.has_next_stage())
    stage_ends_ = met;
  else
    stop(met);
}

/// Warns if supports set in at the restart with a velocity that the body does not have.
void Run::warn_of_jump() {
  if (simulation_.model().mass() == nullptr) return;
  std::string jump =
      velocity_jump(simulation_.characteristic_numbers(), integrator_.resumed_jump(), integrator_.time());
  if (jump.empty()) return;
  jump += ", or set Velocity After Static to Rate if the checkpoint is one of Static";
  warn(jump);
  result_.warnings.push_back({"jump at the restart", jump});
}

/// Measures the last row, and tells of the first jumps to another equilibrium. The end of the run counts them all.
void Run::measure_row() {
  constexpr long told = 3;
  measures_.row(files_.history());
  const Jump& jump = files_.history().jump();
  if (!(jump.released > 0) || files_.history().jumps().count > told) return;
  log(fmt::format(
      "The body jumped to another equilibrium, one of perhaps several, between t = {:.6g} and {:.6g} T0, and "
      "released {:.3g} {}.",
      jump.from, jump.to, jump.released, unit_in(simulation_.model().mesh().body_dimension(), "E0 L0^D")));
}

/// Verifies the existing files, then continues them. Changes nothing if one does not match the checkpoint.
void Run::resume_files() {
  files_.verify();
  files_.open_folder(true);
  checkpoints_.resume(result_.steps);  // the link first: killed from here on, it leads to what is there
  files_.resume();
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
  if (!(dt >= control_.least()) && control_.next(before) >= control_.least()) {
    std::vector<Remedy> shorter;
    if (times_.minimum_step > 0)
      shorter = {{"shorter steps", fmt::format("Time Integrator/Time Step Control/Minimum Time Step={:.3g}", dt / 10)}};
    return fail(fmt::format("the stable step, {:.3g} T0, is shorter than the shortest one allowed, {:.3g} T0", dt,
                            control_.least()),
                std::move(shorter));
  }
  if (!(before + dt > before)) return fail(fmt::format("a step of {:.3g} T0 is lost in rounding", dt));
  attempted_ = dt;
  std::optional<StepControl> unjudged;  // a step that begins anew on another mesh was not judged
  if (follower_.on()) unjudged = control_;
  const StepResult step = integrator_.attempt(dt);
  result_.linear_iterations += step.linear_iterations;
  result_.newton_iterations += step.newton_iterations;
  const double seconds = clock_.seconds();
  files_.count(step, seconds);
  if (!step.converged) {
    ++result_.rejected_steps;
    if (step.crossed) measures_.crossed();
    if (!control_.cut(dt)) fail(step.reason + hints(step), remedies(simulation_, step.ran_out));
    return;
  }
  if (times_.adaptive.on && !judge_step(integrator_, times_.adaptive, dt, control_)) {
    ++result_.rejected_steps;
    std::string why;
    if (control_.exhausted(why)) fail(why, remedies(simulation_, false));
    return;
  }
  if (follower_.on()) {
    follow([this] { return follower_.refined(); });
    if (on_other_mesh_ || is_over()) {
      control_ = *unjudged;
      return;
    }
    follower_.accept();
  }
  if (watch_.on()) watch_.step(integrator_);
  integrator_.accept();
  control_.succeeded();
  ++result_.steps;
  look_at_criteria();
  files_.record(result_.steps, dt, before);
  measures_.step(result_.steps, dt);
  if (files_.recorded()) measure_row();
  if (!watch_energy()) observe(seconds);
}

/// Returns what of the scene may explain that the step failed, for its reason; empty if there is nothing.
std::string Run::hints(const StepResult& step) const {
  if (step.crossed) return "";
  std::string text;
  for (const Warning& warning : simulation_.warnings())
    if (warning.name == support_warning && text.empty()) text = "; " + warning.message;
  if (const std::string steep = steep_law_hint(simulation_.interactions()); !steep.empty()) text += "; " + steep;
  return text;
}

/// Returns where the run stands.
Progress Run::progress(double wall_seconds, bool within_step, const NewtonIterate& iterate) const {
  const double now = integrator_.time(), end = simulation_.planned_end();
  const double went = now - first_time_;
  const double left = went > 0 ? (wall_seconds - first_seconds_) * (end - now) / went : 0;
  return {now, end, result_.steps, result_.newton_iterations, wall_seconds, left, attempted_, within_step, iterate};
}

/// Shows the accepted step to the caller.
void Run::observe(double wall_seconds) {
  const Progress here = progress(wall_seconds);
  if (options_.watch && comm_->getRank() == 0) options_.watch(here);
  if (!options_.observe) return;
  std::string text;
  together<std::runtime_error>(comm_, [&] { text = options_.observe(here); });
  stop(first_problem(comm_, text));
}

/// Looks at the row of the present state, if it has one. Returns whether the state is then an earlier one.
bool Run::watch_energy() {
  if (!watch_.on() || !files_.recorded()) return false;
  const History& history = files_.history();
  // Memory may be damaged on one rank only; what follows is collective.
  const std::string wrong =
      first_problem(comm_, watch_.look(result_.steps, history.balance(), history.largest_energy()));
  if (wrong.empty()) return false;
  const bool resumes = watch_.action() == WatchAction::Resume && !checkpoints_.newest().empty() &&
                       checkpoints_.newest() != resumed_from_;
  if (result_.warnings.empty() || resumes) {
    warn(wrong);
    result_.warnings.push_back({"energy watch", wrong});
  }
  if (resumes)
    go_back();
  else if (watch_.action() != WatchAction::Warn)
    fail(wrong);
  return resumes;
}

/// Resumes from the newest checkpoint; a second time only from a later one.
void Run::go_back() {
  resumed_from_ = checkpoints_.newest();
  clock_.reset();
  const std::vector<Warning> warnings = result_.warnings;  // the checkpoint has none of those after it
  std::string problem;
  try {
    Restart restart(simulation_, resumed_from_);
    restart.load([this](Record& record) { transfer(record); });
    resume_files();
  } catch (const InputError& error) {
    problem = std::string("the run cannot go back to its checkpoint: ") + error.what();
  }
  result_.warnings = warnings;
  if (!problem.empty()) return fail(problem);
  ++result_.restarts;
  result_.status = RunStatus::Completed;  // a stop criterion may have held in the damaged state
  stage_ends_.clear();
  result_.reason.clear();
  log(fmt::format("Resumes from {}: t = {:.6g} T0, step {}.", resumed_from_, integrator_.time(), result_.steps));
}

void Run::end() {
  // Before the last state's row and frame, where these come only because it is the last: a restart has no use for them.
  std::string problem;
  try {
    if (checkpoints_.on()) checkpoint();
  } catch (const FileError& error) {  // on all ranks; there may be room for a row and the summary
    problem = error.what();
  }
  const bool has_row = files_.recorded();
  files_.finish();
  if (!has_row) measure_row();
  result_.end_time = integrator_.time();
  result_.wall_seconds = clock_.seconds();
  result_.max_energy_error = files_.history().max_energy_error();
  result_.largest_energy = files_.history().largest_energy();
  result_.max_forces = files_.history().max_forces();
  result_.contacts = files_.history().contacts().times();
  result_.checkpoint = checkpoints_.newest();
  result_.jumps = files_.history().jumps();
  result_.mesh_changes = follower_.changes();
  result_.phase_seconds = clock_.phases();
  add_findings(run_warnings(measures_.finish(files_.history())));
  write_summary(simulation_, result_, options_.folder + "/summary.json");
  if (!problem.empty()) throw FileError(problem);
}

/// A message of a file that cannot be written, with what a person needs to go on.
std::string Run::with_position(const std::string& message) const {
  const std::string newest = checkpoints_.newest();
  return fmt::format("{} (t = {:.6g} T0, step {}{}). {}", message, integrator_.time(), result_.steps,
                     result_.reason.empty() ? "" : ": " + result_.reason,
                     newest.empty() ? "No checkpoint was written" : "To resume, use the newest checkpoint: " + newest);
}

void Run::checkpoint() {
  // A restart continues these files, so they must be on the disk before the checkpoint.
  files_.sync();
  checkpoints_.write(result_.steps, [this](Record& record) { transfer(record); });
}

void Run::transfer(Record& record) {
  if (!record.has_section("run"))
    throw InputError("a program wrote this file with write_checkpoint(): run() cannot resume from it");
  ixos::transfer(record, options_.states);
  const Record::Section section(record, "run");
  record.number("steps", result_.steps);
  record.number("rejected steps", result_.rejected_steps);
  record.number("newton iterations", result_.newton_iterations);
  record.number("linear iterations", result_.linear_iterations);
  record.number("restarts", result_.restarts);
  ixos::transfer(record, result_.warnings);
  ixos::transfer(record, result_.stages);
  if (record.loading() ? record.has_section("findings") : !result_.stages.empty()) {  // of earlier stages
    const Record::Section earlier(record, "findings");
    ixos::transfer(record, result_.findings);
  }
  const double seconds = clock_.transfer(record);
  files_.transfer(record, result_.steps, seconds);
  integrator_.transfer(record);
  files_.history().transfer(record);
  stop_.transfer(record);
  watch_.transfer(record);
  measures_.transfer(record, files_.history());
  follower_.transfer(record);
  if (record.loading()) files_.history().set_adapted(follower_.changes().energy.total());
  // Other steps or another scheme begin with their own.
  if (!record.loading() || record.same_scene()) control_.transfer(record);
}

}  // namespace

RunResult run(Simulation& simulation, const RunOptions& options) {
  std::shared_ptr<Simulation> other;  // the present one, unless it is the caller's
  const auto tell = [&](const std::shared_ptr<Simulation>& stage) {
    if (options.stage) together(stage->model().space().comm(), [&] { options.stage(stage); });
  };
  other = options.restart.empty() ? on_first_mesh(simulation) : simulation_of_checkpoint(simulation, options.restart);
  auto present = std::make_unique<Run>(other ? *other : simulation, options);
  present->start();
  if (other) tell(other);
  while (std::shared_ptr<Simulation> next = present->advance()) {
    auto later = std::make_unique<Run>(*next, options);
    const bool on_other_mesh = present->has_changed_mesh();
    if (on_other_mesh)
      later->take_over_mesh(*present);
    else
      later->take_over(*present);
    if (on_other_mesh || next->stage() > 0) tell(next);
    present = std::move(later);
    other = std::move(next);
  }
  return present->result();
}

}  // namespace ixos

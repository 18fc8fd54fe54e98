/// Running a scene to its end, with results on disk.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/phase_timer.hpp"
#include "base/warning.hpp"
#include "checkpoint/program_state.hpp"
#include "run/contact_events.hpp"
#include "run/jump_watch.hpp"
#include "run/mesh_follower.hpp"
#include "run/remedies.hpp"
#include "run/stage_ends.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Where a run stands, for whoever watches it.
struct Progress {
  double time = 0;        ///< of the last accepted step
  double final_time = 0;  ///< of the last stage
  long step = 0;
  long newton_iterations = 0;  ///< since the start
  double wall_seconds = 0;
  double seconds_left = 0;  ///< if the rest goes as fast as this process went so far; 0: unknown
  double time_step = 0;     ///< of the step that was accepted, or is under way
  bool within_step = false;
  NewtonIterate newton{};  ///< of the step under way
};

struct RunOptions {
  std::string folder;                            ///< results go here; made where it does not exist
  std::string scene_file;                        ///< the scene's path, for the records of fields.e; may be empty
  std::string restart;                           ///< a checkpoint to go on from; may be empty
  bool overwrite = false;                        ///< replace results of another scene, see replaced_results()
  std::function<void(const std::string&)> log;   ///< called with lines for a person, on rank 0; may be empty
  std::function<void(const std::string&)> warn;  ///< the same of warnings
  std::function<void(const Progress&)> watch;    ///< called after every step on rank 0; may be empty
  /// Called for each iterate of Newton's method on rank 0, with the step under way. It must not throw. May be empty.
  std::function<void(const Progress&)> iterate;
  std::function<bool()> interrupted;  ///< asked before every step; set on all ranks or on none
  /// Called on every rank after each accepted step, when its row is recorded: a step that is rejected is not seen. It
  /// may read all that the simulation's const functions return and Integrator::acceleration(), in collective calls too.
  /// It must not change the simulation. If it returns a text on any rank, the run ends there with RunStatus::Stopped
  /// and that reason. After the energy watch went back to a checkpoint (WatchAction::Resume), the steps from there are
  /// observed again; the damaged step itself is not. If it throws on any rank, run() throws on all ranks, with the
  /// message of the first of them (see together() for the type), and writes no last checkpoint. May be empty.
  std::function<std::string(const Progress&)> observe;
  /// Called on every rank after each accepted step that does not end the run, when its row is recorded. It returns the
  /// simulation with which the run continues, of another mesh or scheme or with other conditions; null to keep the
  /// present one. The other one must stand at the time of the present one: Integrator::resume() and moved() bring its
  /// state there. It runs to its own final time, by its own step control and stop criteria. Its rows follow in
  /// history.csv, so its columns must be the same, but for released_energy, which the file keeps or lacks. Its frames
  /// begin a new file: fields-2.e and so on. effective.xml stays, that of the next simulation is effective-2.xml. The
  /// run throws InputError if times or columns differ; if the function throws, or returns null on some ranks only, it
  /// throws on all ranks. A run that repeats this one in the same folder needs `overwrite`. May be empty.
  std::function<std::shared_ptr<Simulation>(Simulation& present)> exchange;
  /// Called on every rank with the simulation of the next stage of the scene, which has its state, before its steps; at
  /// a restart in a later stage with that of the checkpoint. A run whose mesh follows the front calls it with the
  /// simulation on each further mesh. The run and the caller share it. May be empty.
  std::function<void(const std::shared_ptr<Simulation>&)> stage;
  /// The state of the caller, for example of an observer or of a motion that it sets: the checkpoints of the run hold
  /// it, and a restart reads it. A checkpoint with other states is refused with InputError.
  std::vector<ProgramState> states;
};

/// Stopped: a stop criterion of the last stage holds, or the observer ended the run.
enum class RunStatus { Completed, Stopped, Diverged, Interrupted };

struct RunResult {
  RunStatus status = RunStatus::Completed;
  std::string reason;
  std::vector<Remedy> remedies{};  ///< of a step that failed
  long steps = 0;
  long rejected_steps = 0;  ///< that failed, and were cut where that is allowed
  double end_time = 0;
  long newton_iterations = 0;
  long linear_iterations = 0;
  long restarts = 0;
  double wall_seconds = 0;                                 ///< of the time loop, output included
  double max_energy_error = 0;                             ///< see History::max_energy_error
  double largest_energy = 0;                               ///< see History::largest_energy
  std::vector<std::pair<std::string, double>> max_forces;  ///< see History::max_forces
  std::vector<ContactTimes> contacts;                      ///< see History::contacts
  JumpSums jumps{};                                        ///< to other equilibria, of a quasi-static run
  MeshChanges mesh_changes{};                              ///< of a mesh that follows the front
  std::vector<StageEnd> stages{};                          ///< those that have ended; none of a scene without stages
  PhaseSeconds phase_seconds{};                            ///< of rank 0
  std::string checkpoint;                                  ///< the newest one's path, or nothing
  std::vector<Warning> warnings;                           ///< that RunOptions::warn was told
  std::vector<Warning> findings;                           ///< after the end, for the caller to tell
};

/// Runs from the simulation's present state, or from a checkpoint, to its final time; writes effective.xml,
/// history.csv, summary.json, and fields.e and checkpoints if the scene asks for them. A restart resumes all that
/// RunResult counts, clocks included. A scene with stages goes through them, or on from that of the checkpoint: the
/// caller's simulation stays where its own stage ended, see RunOptions::stage. If the checkpoint is in the same folder,
/// the run also continues history.csv and fields.e, without the rows and frames that came after the checkpoint.
///
/// A step that fails, and may not be cut, ends the run with RunStatus::Diverged; a signal with Interrupted. However it
/// ends, the last good state is checkpointed and the rows up to there are on disk. Throws FileError where something
/// cannot be written, InputError for a checkpoint or results that cannot be gone on from, or for results in the folder
/// that must not be replaced: then nothing has changed. Collective.
RunResult run(Simulation& simulation, const RunOptions& options);

}  // namespace ixos

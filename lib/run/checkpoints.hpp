/// The checkpoints of a run, in its folder: checkpoint-<step>.h5 and the link checkpoint.h5 to the newest.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/record.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Writes checkpoints and keeps the last few.
class Checkpoints {
 public:
  /// Writes to this folder, as often as the simulation's CheckpointOptions say. The simulation must outlive the object.
  Checkpoints(const Simulation& simulation, const std::string& folder);

  bool on() const { return options_.keep > 0; }
  /// Is one due by the number of steps?
  bool due(long step) const {
    return on() && options_.interval > 0 && step > 0 && step != last_step_ && step % options_.interval == 0;
  }
  /// Is one due by this rank's clock?
  bool due_by_clock() const;
  /// Writes one, unless this step has one already; `transfer` names the run's state, twice, first
  /// to learn its size. Then those that are not among the
  /// last ones are deleted, other runs' in the same folder too. Throws FileError; what was there is there still.
  /// Collective.
  void write(long step, const std::function<void(Record&)>& transfer);
  /// At a fresh start: checkpoint.h5 does not link to an earlier run's any more. With `remove`, deletes the checkpoints
  /// of earlier runs; throws FileError if it cannot. Otherwise they stay until write() deletes them. Returns the newest
  /// step of those that stay, or -1. Collective.
  long begin(bool remove);
  /// Goes on with the checkpoints of another simulation of the same run, and with its clock.
  void go_on_from(const Checkpoints& before);
  /// After a restart: the checkpoint of that step and those before it, in the same folder, count as this run's, and
  /// checkpoint.h5 links to it. Collective.
  void resume(long step);
  /// The newest one's path, or nothing.
  std::string newest() const;

 private:
  std::string path(long step) const;
  void tidy() const;

  const Simulation& simulation_;
  std::string folder_;
  const CheckpointOptions& options_;
  long last_step_ = -1;
  double last_time_;         ///< of the clock [s]
  std::vector<long> steps_;  ///< of those that are kept
};

/// Names the build, the scene and the mesh in a record that is written. Restart compares them.
void write_identity(Record& record, const Simulation& simulation);

/// Returns the version of Ixos, the width of vectors and the compiler. Another build may round differently.
std::string build_name();

/// Reads the build that a record names. Returns a sentence for the user if this is another one, else an empty string.
std::string other_build(Record& record);

/// Calls load(), and puts the path of the checkpoint before the message of an InputError that does not begin with it.
void load_placed(const std::string& path, const std::function<void()>& load);

/// The steps of the checkpoints in a folder, whatever their state, ascending.
std::vector<long> checkpoint_steps(const std::string& folder);

/// The path of a folder's checkpoint of a step.
std::string checkpoint_path(const std::string& folder, long step);

}  // namespace ixos

/// Going on from a checkpoint.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "checkpoint/checkpoint_file.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// A checkpoint that was found whole and fits a simulation.
class Restart {
 public:
  /// `path` is a checkpoint's, or that of a folder, whose newest sound one counts. Throws InputError with the file's
  /// name: where it is damaged or no checkpoint (then with the newest sound one before it, if there is one), of another
  /// mesh, or of a scene whose changes a restart cannot make. Collective.
  Restart(const Simulation& simulation, const std::string& path);

  /// Loads the state: what does not fit throws InputError with the file's name. Collective.
  void load(const std::function<void(Record&)>& transfer);
  const std::string& path() const { return path_; }  ///< links resolved
  bool is_in(const std::string& folder) const;       ///< does the checkpoint stand in that folder?
  /// What a person should know: what changed, and whether the run goes on bit for bit.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void find(const std::string& path);
  void compare_scenes(const Simulation& simulation);
  void note_differences(const Simulation& simulation);

  std::string path_;
  bool same_scene_ = true, same_solution_ = true;
  std::unique_ptr<CheckpointReader> reader_;
  std::vector<std::string> notes_;
};

}  // namespace ixos

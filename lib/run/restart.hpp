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
  /// `path` names a checkpoint, or a folder, whose newest sound checkpoint is used. Throws InputError with the file's
  /// name if the file is damaged or no checkpoint (the message then names the newest sound checkpoint before it), if it
  /// belongs to another mesh, or if a restart cannot make the changes of the scene. Collective.
  Restart(const Simulation& simulation, const std::string& path);

  /// Loads the state: what does not fit throws InputError with the file's name. Collective.
  void load(const std::function<void(Record&)>& transfer);
  const std::string& path() const { return path_; }  ///< links resolved
  bool is_in(const std::string& folder) const;       ///< does the checkpoint stand in that folder?
  /// Returns notes for the user: the changes of the scene, and whether the run continues bit for bit.
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

/// Returns the simulation of the stage in which a checkpoint was written, or of the mesh, if it follows the front,
/// without a state; null if that is `simulation`. Throws InputError if the path is no checkpoint, or is one of a stage
/// or a mesh that the scene does not have. Collective.
std::shared_ptr<Simulation> simulation_of_checkpoint(const Simulation& simulation, const std::string& path);

}  // namespace ixos

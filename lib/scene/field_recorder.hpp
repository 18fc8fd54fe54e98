/// fields.e: what a run shows of its state.
#pragma once
#include <memory>
#include <string>

#include "io/field_file.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Frames of displacement, velocity, acceleration, interaction traction (nodal), first stress invariant over E, J,
/// energy density (cells) and energies (global). Collective.
class FieldRecorder {
 public:
  /// With frames to `keep` it goes on with the file that is there. Throws FileError, and InputError where that is not
  /// this scene's.
  FieldRecorder(Simulation& simulation, const std::string& path, const FieldLength& keep = {});
  void record();
  FieldLength length() const { return file_->length(); }
  void sync();  ///< has the disk keep them

 private:
  Simulation& simulation_;
  std::unique_ptr<FieldFile> file_;
};

}  // namespace ixos

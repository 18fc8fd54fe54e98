/// fields.e: the recorded fields of a run.
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
  FieldRecorder(Simulation& simulation, const std::string& path);
  void create();                               ///< throws FileError
  void verify(const FieldLength& keep) const;  ///< see FieldFile; throws InputError
  void resume(const FieldLength& keep);
  void record();
  FieldLength length() const { return file_->length(); }
  void sync();   ///< has the disk keep the frames; throws FileError
  void close();  ///< after the last frame; throws FileError

 private:
  Simulation& simulation_;
  const Comm& comm_;
  std::unique_ptr<FieldFile> file_;
};

}  // namespace ixos

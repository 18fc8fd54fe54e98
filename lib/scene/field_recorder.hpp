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
  /// Throws FileError.
  FieldRecorder(Simulation& simulation, const std::string& path);
  void record();

 private:
  Simulation& simulation_;
  std::unique_ptr<FieldFile> file_;
};

}  // namespace ixos

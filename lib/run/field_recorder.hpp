/// fields.e: the recorded fields of a run.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/field_file.hpp"
#include "scene/output/output_fields.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Frames of the fields that the list "Output" chooses, and of the energies (global). Collective.
class FieldRecorder {
 public:
  /// `scene_file`: the path of the scene, for the file's records; may be empty.
  FieldRecorder(Simulation& simulation, const std::string& path, const std::string& scene_file = "");
  void create();                               ///< throws FileError
  void verify(const FieldLength& keep) const;  ///< see FieldFile; throws InputError
  void resume(const FieldLength& keep);
  void record();
  /// Returns whether the frames of the other one have the same fields in the same format.
  bool has_fields_of(const FieldRecorder& other) const;
  FieldLength length() const { return file_->length(); }
  void sync();   ///< has the disk keep the frames; throws FileError
  void close();  ///< after the last frame; throws FileError

 private:
  Simulation& simulation_;
  const Comm& comm_;
  std::vector<OutputField> fields_;
  std::unique_ptr<FieldFile> file_;
};

}  // namespace ixos

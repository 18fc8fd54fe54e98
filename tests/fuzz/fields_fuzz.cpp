// A field file that a restart goes on with, of either format: the file's own decides.
#include "base/error.hpp"
#include "input.hpp"
#include "run/field_recorder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const std::string path = fuzz::scratch_folder() + "/fields.e";
  const std::string bytes = fuzz::text(data, size);
  Simulation& simulation = fuzz::simulation("Central Difference", bytes.rfind("\x89HDF", 0) == 0 ? "HDF5" : "Exodus");
  // Where the length is known a frame is appended to this file, else the first is copied to a new one.
  for (double length : {static_cast<double>(size), 0.0}) {
    fuzz::write_file(path, bytes);
    try {
      FieldRecorder recorder(simulation, path);
      recorder.verify({1, length});
      recorder.resume({1, length});
      recorder.record();
    } catch (const InputError& error) {
      fuzz::expect_message(error);
    } catch (const FileError& error) {
      fuzz::expect_message(error);
    }
  }
  return 0;
}

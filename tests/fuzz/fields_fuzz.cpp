// A field file that a restart would go on with.
#include "base/error.hpp"
#include "input.hpp"
#include "scene/field_recorder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const std::string path = fuzz::scratch_folder() + "/fields.e";
  Simulation& simulation = fuzz::simulation("Central Difference");
  FieldRecorder recorder(simulation, path);
  fuzz::write_file(path, fuzz::text(data, size));
  const FieldLength length{1, 0};
  try {
    recorder.verify(length);
    recorder.resume(length);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  } catch (const FileError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}

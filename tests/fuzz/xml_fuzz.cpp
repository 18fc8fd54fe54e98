// Parameter lists in XML: what was read is written and read again.
#include "base/error.hpp"
#include "input.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  try {
    const Teuchos::ParameterList list = read_scene_text(fuzz::text(data, size), "input");
    fuzz::expect(scene_changes(list, read_scene_text(scene_text(list), "again")).empty(),
                 "a list changes when it is written and read");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}

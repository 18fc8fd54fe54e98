// --set: an assignment on each line, applied to a small scene.
#include "base/error.hpp"
#include "input.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const Teuchos::ParameterList small = read_scene_text(fuzz::small_scene(), "the small scene");
  Teuchos::ParameterList scene(small);
  try {
    for (const std::string& line : fuzz::pieces(fuzz::text(data, size), "\n", 4))
      if (!line.empty()) set_parameter(scene, scene_parameters(), line);
    const Teuchos::ParameterList complete = complete_scene(scene);
    const Teuchos::ParameterList again = read_scene_text(scene_text(complete), "again");
    fuzz::expect(scene_changes(complete, again).empty(), "a scene changes when it is written and read");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}

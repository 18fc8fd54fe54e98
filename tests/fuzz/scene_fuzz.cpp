// Scenes: XML to the point where ixos --check stops.
#include "base/error.hpp"
#include "input.hpp"
#include "mesh/generators/spatula.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

#include <Teuchos_Array.hpp>

namespace {

using Teuchos::ParameterList;

/// At most, roughly: what takes long to build is not built.
double cells(const ParameterList& mesh) {
  const auto type = mesh.get<std::string>("Type");
  if (type == "Exodus" || type == "Gmsh") return 1e9;  // exodus_fuzz.cpp, gmsh_fuzz.cpp
  if (type == "Given") return 0;                       // there is no program to give one
  if (type == "Disk") {
    const double n = mesh.sublist("Disk").get<int>("Core Divisions");
    return n * n + 4 * n * mesh.sublist("Disk").get<int>("Rings");
  }
  if (type == "Spatula") {
    const ParameterList& list = mesh.sublist("Spatula");
    const double n = list.get<int>("Core Cells") + 4.0 * list.get<int>("Rings");
    return n * n * (list.get<int>("Core Layers") + 2 * list.get<int>("Rings")) * 10 +
           n * (list.get<int>("Core Layers") + 2 * list.get<int>("Rings")) * list.get<int>("Stations") +
           list.get<int>("Target Cells");
  }
  double product = 1;
  for (int n : mesh.sublist("Box").get<Teuchos::Array<int>>("Divisions")) product *= n;
  return product;
}

/// Whatever the user said is there: nothing is left out in silence.
void expect_all(const ParameterList& user, const ParameterList& complete) {
  for (const auto& [name, entry] : ixos::entries(user)) {
    ixos::fuzz::expect(complete.isParameter(name), "a part of the scene is left out");
    if (entry.isList()) expect_all(user.sublist(name), complete.sublist(name));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  try {
    const ParameterList user = read_scene_text(fuzz::text(data, size), "input");
    const ParameterList complete = complete_scene(user);
    expect_all(user, complete);
    const ParameterList again = validated(read_scene_text(scene_text(complete), "again"), scene_parameters());
    fuzz::expect(scene_changes(complete, again).empty(), "a scene changes when it is written and read");
    if (cells(complete.sublist("Mesh")) > 200) return 0;
    Simulation simulation(user, fuzz::comm());
    simulation.stop_criteria();
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}

#include "scene/scene_mesh.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/enrich.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/soundness.hpp"
#include "mesh/spatula.hpp"
#include "scene/list_access.hpp"

namespace ixos {
namespace {

/// Copies an array of exactly `count` elements; an empty one leaves `target` unchanged.
template <class T, std::size_t N>
void copy(const Teuchos::ParameterList& list, const char* name, int count, std::array<T, N>& target) {
  const auto& values = list.get<Teuchos::Array<T>>(name);
  if (values.size() == 0) return;
  if (values.size() != count)
    throw InputError(fmt::format("Mesh/{}/{} has {} elements, not {}", list.name(), name, values.size(), count));
  std::copy(values.begin(), values.end(), target.begin());
}

Mesh disk_mesh(Teuchos::ParameterList list) {
  list.setName("Disk");
  DiskShape shape;
  shape.diameter = list.get<double>("Diameter");
  copy(list, "Center", 2, shape.center);
  shape.core_divisions = list.get<int>("Core Divisions");
  shape.rings = list.get<int>("Rings");
  shape.core_half_side = list.get<double>("Core Half Side");
  return disk(shape);
}

Mesh box_mesh(Teuchos::ParameterList list) {
  list.setName("Box");
  BoxShape shape;
  shape.dimension = list.get<int>("Dimension");
  copy(list, "Lower", shape.dimension, shape.lower);
  copy(list, "Lengths", shape.dimension, shape.lengths);
  copy(list, "Divisions", shape.dimension, shape.divisions);
  return box(shape);
}

Mesh spatula_mesh(const Teuchos::ParameterList& list) {
  SpatulaShape shape;
  shape.pad_length = list.get<double>("Pad Length");
  shape.neck_width = list.get<double>("Neck Width");
  shape.tip_width = list.get<double>("Tip Width");
  shape.widening_length = list.get<double>("Widening Length");
  shape.tip_length = list.get<double>("Tip Length");
  shape.rear_thickness = list.get<double>("Rear Thickness");
  shape.tip_thickness = list.get<double>("Tip Thickness");
  shape.transition_length = list.get<double>("Transition Length");
  shape.fillet_radius = list.get<double>("Fillet Radius");
  shape.shaft_diameter = list.get<double>("Shaft Diameter");
  shape.shaft_length = list.get<double>("Shaft Length");
  shape.inclination = list.get<double>("Inclination");
  shape.gap = list.get<double>("Gap");
  shape.core_cells = list.get<int>("Core Cells");
  shape.core_layers = list.get<int>("Core Layers");
  shape.rings = list.get<int>("Rings");
  shape.tip_rows = list.get<int>("Tip Rows");
  shape.stations = list.get<int>("Stations");
  shape.target_cells = list.get<int>("Target Cells");
  shape.growth = list.get<double>("Growth");
  shape.layer_ratio = list.get<double>("Layer Ratio");
  return spatula(shape);
}

Mesh exodus_mesh(const Teuchos::ParameterList& list) {
  const std::string path = list.get<std::string>("File");
  Mesh mesh = read_exodus_mesh(path);
  try {
    refuse_repeated_cells(mesh);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  const int wanted = list.get<int>("Dimension");
  if (wanted != 0 && wanted != mesh.dimension)
    throw InputError(fmt::format("Mesh/Exodus/File: {} is a mesh of {} dimensions, but the scene wants {}", path,
                                 mesh.dimension, wanted));
  return mesh;
}

void add_sets(const Teuchos::ParameterList& list, Mesh& mesh) {
  for (const std::string& name : sublists(list)) {
    const Teuchos::ParameterList& own = list.sublist(name);
    const auto bound = [&](const char* key) {
      const auto& values = own.get<Teuchos::Array<double>>(key);
      return std::vector<double>(values.begin(), values.end());
    };
    const Region region{bound("Lower"), bound("Upper")};
    at("Mesh/Sets/" + name, [&] {
      if (own.get<std::string>("Kind") == "Sides")
        add_side_set(mesh, name, own.get<std::string>("From"), region);
      else
        add_node_set(mesh, name, own.get<std::string>("From"), region);
    });
  }
}

Mesh generate_or_read(const Teuchos::ParameterList& list) {
  const auto type = list.get<std::string>("Type");
  if (type == "Exodus") return exodus_mesh(list.sublist("Exodus"));
  if (type == "Spatula") return spatula_mesh(list.sublist("Spatula"));
  return type == "Disk" ? disk_mesh(list.sublist("Disk")) : box_mesh(list.sublist("Box"));
}

}  // namespace

Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder) {
  if (list.get<std::string>("Type") == "Exodus") {
    std::string& path = list.sublist("Exodus").get<std::string>("File");
    const auto beside = std::filesystem::path(scene_folder) / path;
    path = std::filesystem::absolute(std::filesystem::exists(beside) ? beside : std::filesystem::path(path))
               .lexically_normal()
               .string();
  }
  try {
    Mesh mesh = generate_or_read(list);
    check_cells(mesh);
    add_sets(list.sublist("Sets"), mesh);
    return mesh;
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind("Mesh", 0) == 0 ? what : "Mesh: " + what);
  }
}

void enrich_surfaces(const Teuchos::ParameterList& interactions, Mesh& mesh) {
  std::map<std::string, std::pair<std::string, int>> known;
  for (const std::string& name : sublists(interactions)) {
    const Teuchos::ParameterList& own = interactions.sublist(name);
    const auto set = own.get<std::string>("Side Set");
    const auto element = own.get<std::string>("Contact Element");
    const int points = own.get<int>("Bulk Points");
    const std::string path = "Interactions/" + name + "/Contact Element";
    const auto [before, added] = known.insert({set, {element, points}});
    if (!added) {
      if (before->second != std::make_pair(element, points))
        throw InputError(fmt::format("{}: another interaction wants {} on the side set \"{}\", or other Bulk Points",
                                     path, before->second.first, set));
      continue;
    }
    const std::map<std::string, ContactElement> elements{{"Q1C1", ContactElement::Q1C1},
                                                         {"Q1C2", ContactElement::Q1C2},
                                                         {"Q1C3", ContactElement::Q1C3},
                                                         {"Q1C4", ContactElement::Q1C4},
                                                         {"Q1CH", ContactElement::Q1CH}};
    at("Interactions/" + name + "/Side Set", [&] { return side_set_named(mesh, set); });
    at(path, [&] { enrich(mesh, set, elements.at(element), points); });
  }
  check_cells(mesh);
}

}  // namespace ixos

#include "scene/scene_mesh.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"

namespace ixos {
namespace {

/// Copies an array of exactly `count` elements; an empty one leaves `target` alone.
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

Mesh exodus_mesh(const Teuchos::ParameterList& list) {
  const std::string path = list.get<std::string>("File");
  Mesh mesh = read_exodus_mesh(path);
  const int wanted = list.get<int>("Dimension");
  if (wanted != 0 && wanted != mesh.dimension)
    throw InputError(fmt::format("Mesh/Exodus/File: {} is a mesh of {} dimensions, but the scene wants {}", path,
                                 mesh.dimension, wanted));
  return mesh;
}

Mesh generate_or_read(const Teuchos::ParameterList& list) {
  const auto type = list.get<std::string>("Type");
  if (type == "Exodus") return exodus_mesh(list.sublist("Exodus"));
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
    return mesh;
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind("Mesh", 0) == 0 ? what : "Mesh: " + what);
  }
}

}  // namespace ixos

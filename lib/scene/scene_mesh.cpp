#include "scene/scene_mesh.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>

#include "base/error.hpp"
#include "mesh/generators.hpp"

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

}  // namespace

Mesh scene_mesh(const Teuchos::ParameterList& list) {
  const auto type = list.get<std::string>("Type");
  try {
    return type == "Disk" ? disk_mesh(list.sublist("Disk")) : box_mesh(list.sublist("Box"));
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind("Mesh", 0) == 0 ? what : "Mesh: " + what);
  }
}

}  // namespace ixos

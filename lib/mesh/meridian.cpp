#include "mesh/meridian.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace ixos {
namespace {

/// `is_place`: whether the node has a radius.
template <class Places>
double largest(const std::vector<double>& coordinates, const Places& is_place) {
  double radius = 0;
  for (std::size_t node = 0; 2 * node < coordinates.size(); ++node)
    if (is_place(node)) radius = std::max(radius, coordinates[2 * node]);
  return radius;
}

template <class Mesh, class Places, class Number>
void check(const Mesh& mesh, double largest_radius, const Places& is_place, const Number& number) {
  if (!mesh.axisymmetric) return;
  if (mesh.dimension != 2)
    throw InputError(fmt::format("an axisymmetric mesh has 2 dimensions, the radius x and the axis y; this mesh has {}",
                                 mesh.dimension));
  const double tolerance = axis_tolerance * largest_radius;
  for (std::size_t node = 0; 2 * node < mesh.coordinates.size(); ++node)
    if (const double x = mesh.coordinates[2 * node]; is_place(node) && x < -tolerance)
      throw InputError(
          fmt::format("node {} at ({:.6g}, {:.6g}) is beyond the axis: the x coordinate of an axisymmetric mesh is the "
                      "radius, which must be at least 0",
                      number(node), x, mesh.coordinates[2 * node + 1]));
}

}  // namespace

void check_meridian(const Mesh& mesh) {
  check(
      mesh, largest_radius(mesh), [&](std::size_t node) { return !mesh.is_derivative(static_cast<int>(node)); },
      [](std::size_t node) { return static_cast<long long>(node) + 1; });
}

void check_meridian(const LocalMesh& mesh) {
  check(
      mesh, mesh.largest_radius, [&](std::size_t node) { return !mesh.is_derivative(node); },
      [&](std::size_t node) { return mesh.message_number(node); });
}

double largest_radius(const Mesh& mesh) {
  if (!mesh.axisymmetric || mesh.dimension != 2) return 0;
  return largest(mesh.coordinates, [&](std::size_t node) { return !mesh.is_derivative(static_cast<int>(node)); });
}

double largest_radius(const DistributedMesh& mesh) {
  if (!mesh.axisymmetric || mesh.dimension != 2) return 0;
  return largest(mesh.coordinates, [](std::size_t) { return true; });
}

std::vector<bool> nodes_on_axis(const LocalMesh& mesh) {
  std::vector<bool> on_axis;
  if (!mesh.axisymmetric) return on_axis;
  const double radius = axis_tolerance * mesh.largest_radius;
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
    on_axis.push_back(!mesh.is_derivative(node) && mesh.coordinates[2 * node] <= radius);
  return on_axis;
}

}  // namespace ixos

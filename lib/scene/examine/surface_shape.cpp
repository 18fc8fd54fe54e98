#include "scene/examine/surface_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mesh/bounds.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<Vec<3>> side_points(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  const int* nodes = &block.nodes[cell_entry(side.cell, nodes_per_cell(block.type))];
  std::vector<Vec<3>> points;
  for (int a : side_nodes(is_quadratic(block.type) ? block.type : corner_type(block.type), side.side))
    points.push_back(node_place(mesh, nodes[a]));
  return points;
}

double extent_along(const Mesh& mesh, const std::vector<int>& parts, int part, const Vec<3>& direction) {
  Bounds span;
  for (int node = 0; node < mesh.nodes(); ++node)
    if (parts[static_cast<std::size_t>(node)] == part && !mesh.is_derivative(node))
      span.add({inner(node_place(mesh, node), direction), 0, 0});
  return span.extent(0);
}

double curvature_of(const Mesh& mesh, const SideSet& set, const Vec<3>& apex, const Vec<3>& normal) {
  constexpr double steep = 0.2, least_turn = 0.01, scatter = 0.25;  // of dheight/dr, of the curvature
  std::set<int> nodes = nodes_of(mesh, set);
  for (const Tie& tie : mesh.ties) nodes.erase(tie.node);
  std::vector<double> curvatures;
  double farthest = 0;
  for (const int node : nodes) {
    if (mesh.plain_nodes >= 0 && node >= mesh.plain_nodes) continue;
    const Vec<3> way = node_place(mesh, node) - apex;
    const double height = inner(way, normal), along = std::sqrt(std::max(0.0, inner(way, way) - height * height));
    if (!(along > 0) || 2 * std::abs(height) > steep * along) continue;
    curvatures.push_back(2 * height / (along * along));
    farthest = std::max(farthest, along);
  }
  if (curvatures.size() < 3) return 0;
  std::sort(curvatures.begin(), curvatures.end());
  const std::size_t n = curvatures.size();
  const double middle = curvatures[n / 2];
  const bool is_round = middle * farthest > least_turn && curvatures[n / 10] > (1 - scatter) * middle &&
                        curvatures[n - 1 - n / 10] < (1 + scatter) * middle;
  return is_round ? middle : 0;
}

double height_of(const Mesh& mesh, const SideSet& set, const Vec<3>& direction) {
  Bounds span;
  for (const Side& side : set.sides)
    for (const Vec<3>& point : side_points(mesh, side)) span.add({inner(point, direction), 0, 0});
  return span.extent(0);
}

double extent_of(const Mesh& mesh, const SideSet& set, const Vec<3>& normal) {
  std::size_t along = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(normal[i]) > std::abs(normal[along])) along = i;
  if (mesh.axisymmetric && along == 1) {
    Bounds box;
    for (const Side& side : set.sides)
      for (const Vec<3>& point : side_points(mesh, side)) box.add(point);
    return box.upper[0];
  }
  double extent = infinity;
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.dimension); ++i) {
    if (i == along) continue;
    Vec<3> axis{};
    axis[i] = 1;
    const Vec<3> across = axis - normal[i] * normal;
    extent = std::min(extent, height_of(mesh, set, 1 / length(across) * across));
  }
  return extent;
}

SurfaceNormal normal_at(const Mesh& mesh, const SideSet& set, int node) {
  Vec<3> sum{};
  int sides = 0;
  for (const Side& side : set.sides) {
    const std::vector<int> nodes = nodes_of_side(mesh, side);
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
    sum = sum + outward_normal(mesh, side);
    ++sides;
  }
  return {1 / length(sum) * sum, sides < mesh.dimension};
}

}  // namespace ixos

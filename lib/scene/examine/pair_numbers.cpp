#include "scene/examine/pair_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/facing_nodes.hpp"
#include "mesh/node_place.hpp"
#include "scene/examine/surface_shape.hpp"

namespace ixos {

void add_pair(const Mesh& mesh, const std::vector<int>& parts, const PairSurface& own, const PairSurface& other,
              SurfaceNumbers& numbers) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const FacingNodes facing = facing_nodes(mesh, own.set.name, other.set.name, infinity);
  const auto way = [&](const std::pair<int, int>& pair) {
    return node_place(mesh, pair.first) - node_place(mesh, pair.second);
  };
  const auto nearest = std::min_element(facing.pairs.begin(), facing.pairs.end(),
                                        [&](const auto& a, const auto& b) { return length(way(a)) < length(way(b)); });
  if (nearest == facing.pairs.end()) return;
  const Vec<3> sum = normal_at(mesh, other.set, nearest->second) - normal_at(mesh, own.set, nearest->first);
  if (length(sum) < 1) return;  // of 2 if they face each other
  const Vec<3> normal = 1 / length(sum) * sum;
  numbers.normal = normal;
  numbers.face_length = std::max(mean_face_length(mesh, own.set), mean_face_length(mesh, other.set));
  numbers.least_gap = infinity;
  numbers.largest_gap = -infinity;
  for (const std::pair<int, int>& pair : facing.pairs) {
    const double gap = inner(way(pair), normal);
    const Vec<3> aside = way(pair) - gap * normal;
    if (length(aside) > numbers.face_length) continue;  // one surface is wider than the other
    numbers.least_gap = std::min(numbers.least_gap, gap);
    numbers.largest_gap = std::max(numbers.largest_gap, gap);
  }
  numbers.extent = std::min(extent_of(mesh, own.set, normal), extent_of(mesh, other.set, normal));
  numbers.thickness =
      std::min(extent_along(mesh, parts, own.part, normal), extent_along(mesh, parts, other.part, normal));
  const double modulus = 1 / (1 / own.body.plane_modulus + 1 / other.body.plane_modulus);
  numbers.elastic_length = numbers.work / modulus;
  numbers.cohesive_zone = cohesive_zone(modulus, numbers.work, numbers.peak_traction, numbers.thickness);
  const auto curvature = [&](const PairSurface& surface, int node, const Vec<3>& inwards) {
    return surface.curvature > 0 ? surface.curvature : curvature_of(mesh, surface.set, node_place(mesh, node), inwards);
  };
  const double both = curvature(own, nearest->first, normal) + curvature(other, nearest->second, -1.0 * normal);
  if (both > 0) add_tabor(1 / both, modulus, numbers);
}

}  // namespace ixos

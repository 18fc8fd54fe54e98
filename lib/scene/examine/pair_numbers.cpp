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
  if (own.part == other.part) return;
  const FacingNodes facing = facing_nodes(mesh, own.set.name, other.set.name, std::numeric_limits<double>::infinity());
  const auto way = [&](const std::pair<int, int>& pair) {
    return node_place(mesh, pair.first) - node_place(mesh, pair.second);
  };
  const auto nearest = std::min_element(facing.pairs.begin(), facing.pairs.end(),
                                        [&](const auto& a, const auto& b) { return length(way(a)) < length(way(b)); });
  if (nearest == facing.pairs.end()) return;
  const SurfaceNormal mine = normal_at(mesh, own.set, nearest->first);
  const SurfaceNormal its = normal_at(mesh, other.set, nearest->second);
  const Vec<3> sum = its.direction - mine.direction;
  if (!(length(sum) >= 1.8)) return;  // 2 if they face each other
  numbers.normal = 1 / length(sum) * sum;
  numbers.face_length = std::max(median_face_length(mesh, own.set), median_face_length(mesh, other.set));
  numbers.least_gap = inner(way(*nearest), numbers.normal);
  numbers.largest_gap =
      numbers.least_gap + height_of(mesh, own.set, numbers.normal) + height_of(mesh, other.set, numbers.normal);
  numbers.extent = std::min(extent_of(mesh, own.set, numbers.normal), extent_of(mesh, other.set, numbers.normal));
  const auto softness = [&](const PairSurface& surface) {
    const double thickness = extent_along(mesh, parts, surface.part, numbers.normal);
    return 1 / (surface.body.plane_modulus * thickness * thickness * thickness);
  };
  const double modulus = 1 / (1 / own.body.plane_modulus + 1 / other.body.plane_modulus);
  numbers.thickness = 1 / std::cbrt(modulus * (softness(own) + softness(other)));
  numbers.elastic_length = numbers.work * (1 / own.body.modulus + 1 / other.body.modulus);
  numbers.cohesive_zone = cohesive_zone(modulus, numbers.work, numbers.peak_traction, numbers.thickness);
  // Each about its own normal, since the nearest nodes are a little beside the nearest places where nodes do not match.
  // On a rim, as that of half a body, the mean of the sides leans: there both surfaces have one normal.
  const bool is_on_rim = mine.is_on_rim || its.is_on_rim;
  const auto curvature = [&](const PairSurface& surface, int node, const Vec<3>& inwards) {
    if (surface.curvature > 0) return surface.curvature;
    return curvature_of(mesh, surface.set, node_place(mesh, node), inwards);
  };
  const double first = curvature(own, nearest->first, is_on_rim ? numbers.normal : -1.0 * mine.direction);
  const double second = curvature(other, nearest->second, -1.0 * (is_on_rim ? numbers.normal : its.direction));
  if (first > 0 && second > 0) add_tabor(1 / (first + second), modulus, numbers);
}

}  // namespace ixos

#include "mesh/cut_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mesh/cell_sides.hpp"
#include "mesh/region.hpp"

namespace ixos {
namespace {

/// The part that neighbouring sides share: two corners, ascending; in 2D one, twice.
using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Returns the outward normal of length 1.
std::array<double, 3> unit_normal(const Mesh& mesh, const Side& side) {
  std::array<double, 3> normal = outward_normal(mesh, side);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& component : normal) component /= length;
  return normal;
}

/// Returns the sine of the angle between a side and an axis.
double lean(const Mesh& mesh, const Side& side, std::size_t axis) { return std::abs(unit_normal(mesh, side)[axis]); }

bool is_flat(const Mesh& mesh, const SideSet& set) {
  const std::array<double, 3> first = unit_normal(mesh, set.sides.front());
  return std::all_of(set.sides.begin(), set.sides.end(), [&](const Side& side) {
    const std::array<double, 3> own = unit_normal(mesh, side);
    return std::hypot(own[0] - first[0], own[1] - first[1], own[2] - first[2]) < 1e-6;
  });
}

/// Returns the edges of a side, in 2D its corners.
std::vector<Edge> edges_of(const Mesh& mesh, const Side& side) {
  const SideCorners corners = corners_of(mesh, side);
  if (mesh.dimension == 2) return {edge_of(corners[0], corners[0]), edge_of(corners[1], corners[1])};
  std::vector<Edge> edges;
  const std::size_t count = count_of(corners);
  for (std::size_t k = 0; k < count; ++k) edges.push_back(edge_of(corners[k], corners[(k + 1) % count]));
  return edges;
}

/// Returns whether the side set meets the plane of these nodes as it would meet a plane of symmetry.
bool bends_away(const Mesh& mesh, const SideSet& set, std::size_t axis, const std::vector<bool>& in_plane) {
  constexpr double steepest = 0.342;  // the sine of 20 degrees
  const auto touches = [&](const Edge& edge) {
    return in_plane[static_cast<std::size_t>(edge.first)] || in_plane[static_cast<std::size_t>(edge.second)];
  };
  const auto lies = [&](const Edge& edge) {
    return in_plane[static_cast<std::size_t>(edge.first)] && in_plane[static_cast<std::size_t>(edge.second)];
  };
  std::map<Edge, const Side*> rim;  // sides with one edge in the plane, by the edge off it
  std::vector<const Side*> others;
  for (const Side& side : set.sides) {
    const std::vector<Edge> edges = edges_of(mesh, side);
    const auto off = std::find_if_not(edges.begin(), edges.end(), touches);
    if (std::none_of(edges.begin(), edges.end(), touches))
      others.push_back(&side);
    else if (off != edges.end() && std::count_if(edges.begin(), edges.end(), lies) == 1)
      rim[*off] = &side;
  }
  double first = 0, second = 0, largest = 0;
  int pairs = 0;
  for (const Side* side : others)
    for (const Edge& edge : edges_of(mesh, *side)) {
      const auto neighbour = rim.find(edge);
      if (neighbour == rim.end()) continue;
      const double own = lean(mesh, *neighbour->second, axis);
      largest = std::max(largest, own);
      first += own;
      second += lean(mesh, *side, axis);
      ++pairs;
    }
  return pairs > 0 && largest <= steepest && second >= 1e-3 * pairs && second >= 1.9 * first;
}

}  // namespace

std::vector<CutPlane> cut_planes(const Mesh& mesh, const SideSet& set, const std::vector<int>& parts) {
  std::vector<CutPlane> planes;
  if (set.sides.empty() || is_flat(mesh, set)) return planes;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const int part = parts[static_cast<std::size_t>(corners_of(mesh, set.sides.front())[0])];
  const double tolerance = place_tolerance(mesh);
  for (std::size_t axis = mesh.axisymmetric ? 1 : 0; axis < d; ++axis) {
    const auto visit = [&](const auto& function) {
      for (int node = 0; node < mesh.nodes(); ++node)
        if (parts[static_cast<std::size_t>(node)] == part && !mesh.is_derivative(node))
          function(node, mesh.coordinates[static_cast<std::size_t>(node) * d + axis]);
    };
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    visit([&](int, double x) {
      lowest = std::min(lowest, x);
      highest = std::max(highest, x);
    });
    for (const double place : {lowest, highest}) {
      CutPlane plane{axis, std::abs(place) <= tolerance ? 0 : place, {}};
      std::vector<bool> in_plane(static_cast<std::size_t>(mesh.nodes()), false);
      visit([&](int node, double x) {
        if (std::abs(x - place) > tolerance) return;
        in_plane[static_cast<std::size_t>(node)] = true;
        plane.nodes.push_back(node);
      });
      if (bends_away(mesh, set, axis, in_plane)) planes.push_back(std::move(plane));
    }
  }
  return planes;
}

}  // namespace ixos

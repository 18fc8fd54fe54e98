#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/error.hpp"
#include "mesh/generators/entry.hpp"
#include "mesh/generators/shapes.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

using GridPoint = std::array<int, 3>;

void check(const BallShape& shape) {
  if (!(shape.diameter > 0)) throw InputError(fmt::format("diameter {} must be positive", shape.diameter));
  if (shape.core_divisions < 1)
    throw InputError(fmt::format("core divisions {} must be at least 1", shape.core_divisions));
  if (shape.rings < 1) throw InputError(fmt::format("rings {} must be at least 1", shape.rings));
  if (!(shape.core_half_side > 0 && shape.core_half_side < 0.55))
    throw InputError(fmt::format("core half side {} must lie between 0 and 0.55", shape.core_half_side));
  const double n = shape.core_divisions, nodes = std::pow(n + 1, 3) + (6 * n * n + 2) * shape.rings;
  if (nodes > 5e7)
    throw InputError(fmt::format("core divisions {} and rings {} make {:.3g} nodes; at most 5e7 are allowed",
                                 shape.core_divisions, shape.rings, nodes));
}

/// Returns the faces of the cube's grid of n cells a side, four points each, counter-clockwise seen from outside.
std::vector<std::array<GridPoint, 4>> faces_of_cube(int n) {
  std::vector<std::array<GridPoint, 4>> faces;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, n})
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          // The axes after this one, in an order that makes a right-handed system with the outward normal.
          const std::size_t u = (axis + (end == 0 ? 2 : 1)) % 3, v = (axis + (end == 0 ? 1 : 2)) % 3;
          std::array<GridPoint, 4> face;
          for (std::size_t c = 0; c < 4; ++c) {
            face[c][axis] = end;
            face[c][u] = i + (c == 1 || c == 2 ? 1 : 0);
            face[c][v] = j + (c >= 2 ? 1 : 0);
          }
          faces.push_back(face);
        }
  return faces;
}

struct Parameters : BallShape {
  std::vector<double> place{0.0, 0.0, 0.0};  ///< of the centre
};

}  // namespace

Mesh ball(const BallShape& shape) {
  check(shape);
  const int n = shape.core_divisions;
  const double radius = shape.diameter / 2, half = shape.core_half_side * radius;
  const auto share = [n](int i) { return 2.0 * i / n - 1; };
  Mesh mesh;
  mesh.dimension = 3;
  const auto add_node = [&](const std::array<double, 3>& x) {
    for (std::size_t i = 0; i < 3; ++i) mesh.coordinates.push_back(shape.center[i] + x[i]);
  };
  const auto core_node = [n](const GridPoint& p) { return (p[2] * (n + 1) + p[1]) * (n + 1) + p[0]; };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) add_node({half * share(i), half * share(j), half * share(k)});
  const std::vector<std::array<GridPoint, 4>> faces = faces_of_cube(n);
  std::map<GridPoint, int> on_cube;  // number among the cube's surface nodes
  std::vector<GridPoint> points;
  for (const auto& face : faces)
    for (const GridPoint& p : face)
      if (on_cube.insert({p, static_cast<int>(points.size())}).second) points.push_back(p);
  for (int ring = 1; ring <= shape.rings; ++ring) {
    const double s = static_cast<double>(ring) / shape.rings;
    for (const GridPoint& p : points) {
      // Lines of equal angles on the sphere (Ronchi, Iacono and Paolucci 1996).
      std::array<double, 3> direction, x;
      for (std::size_t i = 0; i < 3; ++i) direction[i] = std::tan(M_PI / 4 * share(p[i]));
      const double size = std::hypot(direction[0], direction[1], direction[2]);
      for (std::size_t i = 0; i < 3; ++i) x[i] = (1 - s) * half * share(p[i]) + s * radius * direction[i] / size;
      add_node(x);
    }
  }
  const int core_nodes = (n + 1) * (n + 1) * (n + 1), layer = static_cast<int>(points.size());
  const auto ring_node = [&](int ring, const GridPoint& p) {
    return ring == 0 ? core_node(p) : core_nodes + (ring - 1) * layer + on_cube.at(p);
  };
  ElementBlock body{"body", CellType::Hex8, {}};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (const int top : {0, 1})
          for (const auto& [a, b] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            body.nodes.push_back(core_node({i + a, j + b, k + top}));
  SideSet surface{"surface", {}};
  for (int ring = 0; ring < shape.rings; ++ring)
    for (const auto& face : faces) {
      if (ring + 1 == shape.rings) surface.sides.push_back({0, body.cells(), 5});
      for (const int outer : {0, 1})
        for (const GridPoint& p : face) body.nodes.push_back(ring_node(ring + outer, p));
    }
  NodeSet outside{"surface", {}};
  for (const GridPoint& p : points) outside.nodes.push_back(ring_node(shape.rings, p));
  mesh.blocks.push_back(std::move(body));
  mesh.side_sets.push_back(std::move(surface));
  mesh.node_sets.push_back(std::move(outside));
  return mesh;
}

MeshEntry ball_mesh() {
  Options<Parameters> options;
  options.add("Diameter", &Parameters::diameter, "Diameter of the ball [L0].", greater_than(0))
      .add("Center", &Parameters::place, "Coordinates x, y and z of the centre [L0].", any_number())
      .add("Core Divisions", &Parameters::core_divisions, "Number of cells along an edge of the core, a cube.",
           between(1, 1000))
      .add("Rings", &Parameters::rings, "Number of layers of cells around the core.", between(1, 1000))
      .add("Core Half Side", &Parameters::core_half_side,
           "Half the edge length of the core, divided by the radius of the ball [-].", greater_and_less_than(0, 0.55));
  return {{"Ball",
           "A ball of hexahedra: a cube as the core, and layers around it whose surface is a sphere. It has the block "
           "\"body\" and the side and node set \"surface\". With the Cell Order 2 the added nodes are on straight "
           "edges.",
           "", options.list(),
           [options](const SceneNode& node) {
             Parameters shape = options.read(node);
             copy_values(node, "Center", shape.place, 3, shape.center);
             return ball(shape);
           }},
          3};
}

}  // namespace ixos

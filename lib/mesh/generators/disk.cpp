#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/entry.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/normalize.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

void check(const DiskShape& shape) {
  if (!(shape.diameter > 0)) throw InputError(fmt::format("diameter {} must be positive", shape.diameter));
  if (shape.core_divisions < 2 || shape.core_divisions % 2 != 0)
    throw InputError(fmt::format("core divisions {} must be even and at least 2", shape.core_divisions));
  if (shape.rings < 1) throw InputError(fmt::format("rings {} must be at least 1", shape.rings));
  if (!(shape.core_half_side > 0 && shape.core_half_side < 0.7))
    throw InputError(fmt::format("core half side {} must lie between 0 and 0.7", shape.core_half_side));
  if (shape.cell_order != 1 && shape.cell_order != 2)
    throw InputError(fmt::format("cell order {} must be 1 or 2", shape.cell_order));
  const double nodes =
      (shape.core_divisions + 1.0) * (shape.core_divisions + 1.0) + 4.0 * shape.core_divisions * shape.rings;
  if (nodes > 5e7)
    throw InputError(fmt::format("core divisions {} and rings {} make {:.3g} nodes; at most 5e7 are allowed",
                                 shape.core_divisions, shape.rings, nodes));
}

/// Returns the grid indices of the core's boundary nodes, counter-clockwise from the corner at 225 degrees.
std::vector<std::array<int, 2>> core_boundary(int n) {
  std::vector<std::array<int, 2>> nodes;
  nodes.reserve(4 * static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) nodes.push_back({i, 0});
  for (int j = 0; j < n; ++j) nodes.push_back({n, j});
  for (int i = n; i > 0; --i) nodes.push_back({i, n});
  for (int j = n; j > 0; --j) nodes.push_back({0, j});
  return nodes;
}

double angle_at(double k, int around) { return M_PI * (-0.75 + 2.0 * k / around); }

/// Turns the cells into quadratic ones. The middles between two nodes of a ring stand where a node of a mesh of twice
/// as many cells would: a node is the mean, with the weights 1 - s and s, of one on the core's straight sides and one
/// on the circle, and the circle's arc is higher than its chord.
void curve_rings(const DiskShape& shape, Mesh& mesh) {
  raise_order(mesh);
  const int around = 4 * shape.core_divisions;
  const double height = shape.diameter / 2 * (1 - std::cos(M_PI / around));
  int cell = shape.core_divisions * shape.core_divisions;
  for (int ring = 0; ring < shape.rings; ++ring)
    for (int k = 0; k < around; ++k, ++cell) {
      const double angle = angle_at(k + 0.5, around);
      // A cell's second edge is on the ring's outer side; the inner side is the next ring's outer one, or straight.
      for (const auto& [a, steps] : {std::pair{5, ring + 1.0}, std::pair{8, ring + 0.5}}) {
        const double shift = steps / shape.rings * height;
        double* x = &mesh.coordinates[2 * static_cast<std::size_t>(mesh.blocks[0].nodes[cell_entry(cell, 9, a)])];
        x[0] += shift * std::cos(angle);
        x[1] += shift * std::sin(angle);
      }
    }
}

/// Removes the cells to the left of the centre, and the nodes that no other cell has.
void halve(double center, double radius, Mesh& mesh) {
  const auto x = [&](int node) -> double& { return mesh.coordinates[2 * static_cast<std::size_t>(node)]; };
  for (int node = 0; node < mesh.nodes(); ++node)
    if (std::abs(x(node) - center) < 1e-9 * radius) x(node) = center;  // sines and cosines are rounded
  const int n = nodes_per_cell(mesh.blocks[0].type);
  std::vector<int> cell_number, nodes;
  for (int cell = 0; cell < mesh.blocks[0].cells(); ++cell) {
    const int* old = &mesh.blocks[0].nodes[cell_entry(cell, n)];
    const bool kept = std::all_of(old, old + n, [&](int node) { return x(node) >= center; });
    cell_number.push_back(kept ? static_cast<int>(nodes.size()) / n : -1);
    if (kept) nodes.insert(nodes.end(), old, old + n);
  }
  mesh.blocks[0].nodes = std::move(nodes);
  std::vector<Side> sides;
  for (Side side : mesh.side_sets[0].sides) {
    side.cell = cell_number[static_cast<std::size_t>(side.cell)];
    if (side.cell >= 0) sides.push_back(side);
  }
  mesh.side_sets[0].sides = std::move(sides);
  drop_unused_nodes(mesh);
  mesh.notes.clear();  // nobody gave the mesh these nodes
  NodeSet axis{"axis", {}};
  for (int node = 0; node < mesh.nodes(); ++node)
    if (x(node) == center) axis.nodes.push_back(node);
  mesh.node_sets.push_back(std::move(axis));
}

struct Parameters : DiskShape {
  std::vector<double> place{0.0, 0.0};  ///< of the centre
};

}  // namespace

Mesh disk(const DiskShape& shape) {
  check(shape);
  const int n = shape.core_divisions;
  const int around = 4 * n;
  const double radius = shape.diameter / 2;
  const double half = shape.core_half_side * radius;
  const auto core_node = [n](int i, int j) { return j * (n + 1) + i; };
  const auto boundary = core_boundary(n);

  Mesh mesh;
  mesh.dimension = 2;
  const auto add_node = [&mesh, &shape](double x, double y) {
    mesh.coordinates.push_back(shape.center[0] + x);
    mesh.coordinates.push_back(shape.center[1] + y);
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) add_node(half * (2.0 * i / n - 1), half * (2.0 * j / n - 1));
  for (int ring = 1; ring <= shape.rings; ++ring) {
    const double s = static_cast<double>(ring) / shape.rings;
    for (int k = 0; k < around; ++k) {
      const auto [i, j] = boundary[static_cast<std::size_t>(k)];
      const double angle = angle_at(k, around);
      add_node((1 - s) * half * (2.0 * i / n - 1) + s * radius * std::cos(angle),
               (1 - s) * half * (2.0 * j / n - 1) + s * radius * std::sin(angle));
    }
  }

  const auto ring_node = [&](int ring, int k) {
    k %= around;
    const auto [i, j] = boundary[static_cast<std::size_t>(k)];
    return ring == 0 ? core_node(i, j) : (n + 1) * (n + 1) + (ring - 1) * around + k;
  };
  ElementBlock body{"body", CellType::Quad4, {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (int node : {core_node(i, j), core_node(i + 1, j), core_node(i + 1, j + 1), core_node(i, j + 1)})
        body.nodes.push_back(node);
  SideSet surface{"surface", {}};
  NodeSet rim{"surface", {}};
  for (int ring = 0; ring < shape.rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      if (ring + 1 == shape.rings) {
        surface.sides.push_back({0, body.cells(), 1});
        rim.nodes.push_back(ring_node(ring + 1, k));
      }
      for (int node : {ring_node(ring, k), ring_node(ring + 1, k), ring_node(ring + 1, k + 1), ring_node(ring, k + 1)})
        body.nodes.push_back(node);
    }
  }
  mesh.blocks.push_back(std::move(body));
  mesh.side_sets.push_back(std::move(surface));
  mesh.node_sets.push_back(std::move(rim));
  mesh.node_sets.push_back({"center", {core_node(n / 2, n / 2)}});
  if (shape.cell_order == 2) curve_rings(shape, mesh);
  if (shape.half) halve(shape.center[0], radius, mesh);
  return mesh;
}

MeshEntry disk_mesh() {
  Options<Parameters> options;
  options.add("Diameter", &Parameters::diameter, "Diameter of the disk [L0].", greater_than(0))
      .add("Center", &Parameters::place, "Coordinates x and y of the centre [L0].", any_number())
      .add("Core Divisions", &Parameters::core_divisions,
           "Number of cells along a side of the square core. It must be even.", between(2, 10000))
      .add("Rings", &Parameters::rings, "Number of layers of cells around the core.", between(1, 10000))
      .add("Core Half Side", &Parameters::core_half_side,
           "Half the side length of the core, divided by the radius of the disk [-].", greater_and_less_than(0, 0.7))
      .add("Half", &Parameters::half,
           "Keep only the half of the disk to the right of its centre: with the Geometry Axisymmetric, a ball.");
  const auto make = [options](const SceneNode& node, int cell_order) {
    Parameters shape = options.read(node);
    copy_values(node, "Center", shape.place, 2, shape.center);
    shape.cell_order = cell_order;
    return disk(shape);
  };
  return {{"Disk",
           "A disk of quadrilaterals, meshed as an O-grid. It has the block \"body\", the side and node set "
           "\"surface\", and the node set \"center\"; a half disk also has the node set \"axis\".",
           "", options.list(), [make](const SceneNode& node) { return make(node, 1); }},
          2,
          [make](const SceneNode& node) { return make(node, 2); }};
}

}  // namespace ixos

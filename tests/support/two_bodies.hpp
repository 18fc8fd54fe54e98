/// Two bodies in one mesh.
#pragma once
#include <cmath>
#include <string>

#include "mesh/generators/shapes.hpp"
#include "mesh/mesh.hpp"
#include "mesh/partition.hpp"
#include "model/surface_pair.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"

namespace ixos::test {

/// Appends another mesh; its blocks and sets get the prefix. All blocks of a model_of() must be "body".
inline void append(Mesh& mesh, const Mesh& other, const std::string& prefix) {
  const int first_node = mesh.nodes(), first_block = static_cast<int>(mesh.blocks.size());
  mesh.dimension = other.dimension;
  mesh.coordinates.insert(mesh.coordinates.end(), other.coordinates.begin(), other.coordinates.end());
  for (ElementBlock block : other.blocks) {
    for (int& node : block.nodes) node += first_node;
    block.name = prefix + block.name;
    mesh.blocks.push_back(block);
  }
  for (SideSet set : other.side_sets) {
    for (Side& side : set.sides) side.block += first_block;
    set.name = prefix + set.name;
    mesh.side_sets.push_back(set);
  }
  for (NodeSet set : other.node_sets) {
    for (int& node : set.nodes) node += first_node;
    set.name = prefix + set.name;
    mesh.node_sets.push_back(set);
  }
}

/// Two disks of this radius, the first at the origin, the second at `center`.
inline Mesh two_disks(double radius, std::array<double, 2> center, int core = 4, int rings = 2) {
  Mesh mesh;
  DiskShape shape;
  shape.diameter = 2 * radius;
  shape.core_divisions = core;
  shape.rings = rings;
  append(mesh, disk(shape), "a_");
  shape.center = center;
  append(mesh, disk(shape), "b_");
  return mesh;
}

/// A ring of `cells` by `layers` quadrilaterals. Its side set "surface" is the outer boundary.
inline Mesh ring(double outer, double inner, std::array<double, 2> center, int cells, int layers) {
  Mesh mesh;
  ElementBlock body{"body", CellType::Quad4, {}};
  SideSet surface{"surface", {}};
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j <= layers; ++j) {
      const double angle = 2 * M_PI * i / cells, r = inner + (outer - inner) * j / layers;
      mesh.coordinates.insert(mesh.coordinates.end(),
                              {center[0] + r * std::cos(angle), center[1] + r * std::sin(angle)});
    }
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < layers; ++j) {
      const int own = i * (layers + 1) + j, next = (i + 1) % cells * (layers + 1) + j;
      if (j + 1 == layers) surface.sides.push_back({0, body.cells(), 1});  // from own + 1 to next + 1
      body.nodes.insert(body.nodes.end(), {own, own + 1, next + 1, next});
    }
  mesh.blocks.push_back(std::move(body));
  mesh.side_sets.push_back(std::move(surface));
  return mesh;
}

/// Two rings, as two_disks().
inline Mesh two_rings(double outer, double inner, std::array<double, 2> center, int cells, int layers) {
  Mesh mesh;
  append(mesh, ring(outer, inner, {0, 0}, cells, layers), "a_");
  append(mesh, ring(outer, inner, center, cells, layers), "b_");
  return mesh;
}

/// A block of 2 by 1 (side sets "upper_...") above one of 2.3 by 1 whose top is y = 0 ("lower_..."). The sides that
/// face each other have different lengths.
inline Mesh two_blocks(double gap, int upper_cells = 5, int lower_cells = 4) {
  Mesh mesh;
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {2.3, 1, 0};
  shape.divisions = {lower_cells, 2, 1};
  shape.lower = {-0.2, -1, 0};
  append(mesh, box(shape), "lower_");
  shape.lengths = {2, 1, 0};
  shape.divisions = {upper_cells, 2, 1};
  shape.lower = {0, gap, 0};
  append(mesh, box(shape), "upper_");
  return mesh;
}

/// Two balls, as two_disks().
inline Mesh two_balls(double radius, std::array<double, 3> center, int core = 2, int rings = 1) {
  Mesh mesh;
  BallShape shape;
  shape.diameter = 2 * radius;
  shape.core_divisions = core;
  shape.rings = rings;
  append(mesh, ball(shape), "a_");
  shape.center = center;
  append(mesh, ball(shape), "b_");
  return mesh;
}

/// As two_blocks(), in space: 2 by 1.5 by 1 above 2.3 by 1.8 by 1 with the top z = 0.
inline Mesh two_boxes(double gap, int upper_cells = 3, int lower_cells = 2) {
  Mesh mesh;
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {2.3, 1.8, 1};
  shape.divisions = {lower_cells, lower_cells, 1};
  shape.lower = {-0.2, -0.1, -1};
  append(mesh, box(shape), "lower_");
  shape.lengths = {2, 1.5, 1};
  shape.divisions = {upper_cells, upper_cells, 1};
  shape.lower = {0, 0, gap};
  append(mesh, box(shape), "upper_");
  return mesh;
}

/// Returns a model of all blocks, neo-Hookean with E = 1, nu = 0.3 and density 1, whose ranks have these side sets
/// whole.
inline std::unique_ptr<Model> model_of_bodies(const Mesh& mesh, const std::vector<std::string>& whole,
                                              Inertia inertia = Inertia::None) {
  std::vector<Material> materials;
  for (const ElementBlock& block : mesh.blocks) {
    if (!materials.empty() && materials.back().block == block.name) continue;  // enriched cells of the same body
    materials.push_back(elastic(neo_hooke, 0.3));
    materials.back().block = block.name;
  }
  const Comm comm = world();
  const int ranks = comm->getSize();
  return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks, whole), comm,
                                 materials, inertia);
}

}  // namespace ixos::test

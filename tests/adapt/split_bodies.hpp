/// Split meshes for tests.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "adapt/split_mesh.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/contact_element.hpp"
#include "support/simplices.hpp"

namespace ixos::test {

/// A box of 3 by 2 (by 2) L0 with cells of 1 L0, of which some are split; its bottom has the contact element. Kinds: 0,
/// none; 1, those in a corner twice; 2, others once; 3, along x alone.
inline SplitMesh split_box(int dimension, ContactElement element, int kind) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 2};
  shape.divisions = {3, 2, 2};
  Mesh mesh = box(shape);
  const int order = is_of_quadratic_cells(element) ? 2 : 1;
  if (order == 2) raise_order(mesh);
  const Mesh base = mesh;
  RefinedRegion region;
  region.levels = kind == 1 ? 2 : 1;
  region.lower.assign(static_cast<std::size_t>(dimension), kind == 2 ? 1.2 : -1.0);
  region.upper.assign(static_cast<std::size_t>(dimension), kind == 2 ? 9 : 0.4);
  if (kind == 3) region.directions = "x";
  SplitTree tree = kind == 0 ? split(mesh, CellSplits(), order) : refine(mesh, {{"region", region}}, order);
  enrich(mesh, "bottom", element);
  return {base, mesh, std::move(tree)};
}

/// That box of other cells, see split_cells(), distorted, of which some are split. Kinds: 0, none; 1, those in a corner
/// twice; 2, others once; 3, a part of the corner once.
inline SplitMesh split_simplices(const std::string& cells, int order, bool bubbles, int kind) {
  BoxShape shape;
  shape.dimension = cells.find("triangles") != std::string::npos ? 2 : 3;
  shape.lower = {-1.5, 0, 0};  // kinds change at x = 0
  shape.lengths = {3, 2, 2};
  shape.divisions = {cells.find("hexahedra") == 0 ? 9 : 3, 2, 2};
  Mesh mesh = split_cells(box(shape), cells);
  // The mass of distorted hexahedra is not integrated exactly.
  if (cells.find("hexahedra") == std::string::npos) distort(mesh, 0.1);
  if (order == 2) raise_order(mesh);
  const Mesh base = mesh;
  RefinedRegion region;
  region.levels = kind == 1 ? 2 : 1;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  region.lower.assign(d, kind == 2 ? 1.2 : -1.0);
  region.upper.assign(d, kind == 2 ? 9 : kind == 1 ? 0.4 : 0.1);
  region.lower[0] -= 1.5;
  region.upper[0] -= 1.5;
  SplitTree tree = kind == 0 ? split(mesh, CellSplits(), order) : refine(mesh, {{"region", region}}, order);
  if (bubbles) add_bubbles(mesh);
  return {base, mesh, std::move(tree)};
}

/// Cells, their order, and whether they have bubbles.
struct SimplexKind {
  std::string cells;
  int order = 1;
  bool bubbles = false;
};
inline const std::vector<SimplexKind>& simplex_kinds() {
  static const std::vector<SimplexKind> all{
      {"triangles", 1},           {"triangles", 2},           {"triangles", 2, true},
      {"quads and triangles", 1}, {"quads and triangles", 2}, {"tetrahedra", 1},
      {"tetrahedra", 2},          {"tetrahedra", 2, true},    {"hexahedra to tetrahedra", 1}};
  return all;
}

}  // namespace ixos::test

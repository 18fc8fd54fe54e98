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

}  // namespace ixos::test

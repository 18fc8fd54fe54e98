#include "adapt/wished_splits.hpp"

#include <algorithm>
#include <array>

#include "fem/corner_bits.hpp"
#include "mesh/splitting/cell_tree.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Returns whether a cell is to be split. A new split has a lead at the front: the next steps move it.
bool is_above(const Signs& signs, const TreeCell& cell, const AdaptOptions& options, bool is_split) {
  const double lead = (1 + options.keep) / 2;
  for (const Front& front : signs.fronts)
    if (front.change(cell) > (is_split ? options.keep : lead) * options.part) return true;
  return signs.bulk && options.strain > 0 && signs.bulk->jump(cell) > (is_split ? options.keep : 1) * options.strain;
}

/// Returns the halvings that parts of a cell of the unsplit mesh may have along each axis.
std::array<int, 3> allowed(const AdaptOptions& options, const Mesh& base, const TreeCell& part) {
  if (part.shape != TreeShape::Box) return {part.shape == TreeShape::Simplex ? options.levels : 0, 0, 0};
  const ElementBlock& block = base.blocks[at(part.block)];
  TreeCell whole = part;
  for (int bits = 0; bits < 1 << base.dimension; ++bits)
    whole.corners[at(bits)] = block.nodes[cell_entry(part.root, nodes_per_cell(block.type), corner_bits(bits))];
  std::array<int, 3> most{};
  for (int axis = 0; axis < base.dimension; ++axis)
    if (is_along(direction_of(base, whole, axis), options.directions)) most[at(axis)] = options.levels;
  return most;
}

bool may_be_halved(const TreeCell& cell, const std::array<int, 3>& most) {
  if (cell.shape == TreeShape::Simplex) return cell.halvings[0] < cell.dimension() * most[0];
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cell.halvings[axis] < most[axis]) return true;
  return false;
}

}  // namespace

std::set<int> coarse_leaves(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options) {
  std::set<int> coarse;
  for (const Front& front : signs.fronts)
    for (const int leaf : front.leaves()) {
      const TreeCell& cell = mesh.tree().cell(leaf);
      if (!(front.change(cell) > options.part)) continue;
      if (may_be_halved(cell, allowed(options, mesh.base(), cell))) coarse.insert(leaf);
    }
  return coarse;
}

CellSplits wished_splits(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options,
                         const std::vector<NamedRegion>& regions, bool keep_all) {
  Mesh trial = mesh.base();
  CellTree tree(trial);
  std::vector<RegionSearch> searches;
  searches.reserve(regions.size());
  for (const NamedRegion& region : regions) searches.emplace_back(trial, region.region);
  const CellSplits before = mesh.tree().splits();
  const auto wish = [&](const TreeCell& cell) -> std::vector<int> {
    std::vector<int> axes = tree.wanted_axes(cell, searches);
    if (!axes.empty()) return axes;
    const int split_before = before.axis(cell);
    if (keep_all && split_before >= 0) return {split_before};
    axes = tree.axes_to_halve(cell, allowed(options, mesh.base(), cell));
    if (axes.empty() || !is_above(signs, cell, options, split_before >= 0)) return {};
    return axes;
  };
  if (keep_all) tree.keep_levels(mesh.tree());
  const bool in_all = options.directions.empty() && std::all_of(searches.begin(), searches.end(),
                                                                [](const auto& search) { return search.splits_all(); });
  tree.split(wish, in_all, most_refined_cells);
  return tree.trees().splits();
}

}  // namespace ixos

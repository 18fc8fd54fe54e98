#include "adapt/wished_splits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/splitting/cell_tree.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool is_above(const Signs& signs, const TreeCell& cell, const AdaptOptions& options, double share) {
  for (const Front& front : signs.fronts)
    if (front.change(cell) > share * options.part) return true;
  return signs.bulk && options.strain > 0 && signs.bulk->jump(cell) > share * options.strain;
}

/// Returns the halvings that a cell may have along each axis.
template <class Direction>
std::array<int, 3> allowed(const AdaptOptions& options, int dimension, const Direction& direction) {
  std::array<int, 3> most{};
  for (int axis = 0; axis < dimension; ++axis) {
    const std::array<double, 3> along = direction(axis);
    const auto largest =
        std::max_element(along.begin(), along.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const bool splits =
        options.directions.empty() || options.directions.find("xyz"[largest - along.begin()]) != std::string::npos;
    if (splits) most[at(axis)] = options.levels;
  }
  return most;
}

bool may_be_halved(const TreeCell& cell, const std::array<int, 3>& most) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cell.halvings[axis] < most[axis]) return true;
  return false;
}

}  // namespace

bool has_coarse_cells(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options) {
  for (const TreeCell& cell : mesh.tree().cells()) {
    if (cell.first_child >= 0) continue;
    const auto most =
        allowed(options, mesh.mesh().dimension, [&](int axis) { return direction_of(mesh.mesh(), cell, axis); });
    if (may_be_halved(cell, most) && is_above(signs, cell, options, 1)) return true;
  }
  return false;
}

CellSplits wished_splits(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options,
                         const std::vector<NamedRegion>& regions, bool keep_all) {
  Mesh trial = mesh.base();
  CellTree tree(trial);
  std::vector<RegionSearch> searches;
  for (const NamedRegion& region : regions) searches.emplace_back(trial, region.region);
  const CellSplits before = mesh.tree().splits();
  const auto wish = [&](const TreeCell& cell) -> std::vector<int> {
    if (const std::vector<int> axes = tree.wanted_axes(cell, searches); !axes.empty()) return axes;
    const int split_before = before.axis(cell);
    if (keep_all && split_before >= 0) return {split_before};
    const auto most = allowed(options, trial.dimension, [&](int axis) { return direction_of(trial, cell, axis); });
    std::vector<int> axes = tree.axes_to_halve(cell, most);
    if (axes.empty() || !is_above(signs, cell, options, split_before >= 0 ? options.keep : 1)) return {};
    return axes;
  };
  tree.split(wish, options.directions.empty(), most_refined_cells);
  return tree.trees().splits();
}

}  // namespace ixos

#include "mesh/splitting/cell_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"
#include "fem/corner_element.hpp"
#include "fem/with_element.hpp"
#include "mesh/enrichment/contact_nodes.hpp"
#include "mesh/region.hpp"

namespace ixos {
namespace {

/// Returns the point of a cell at those reference coordinates.
std::vector<double> point_in(const Mesh& mesh, const ElementBlock& block, int cell,
                             const std::array<double, 3>& place) {
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension;
    std::array<double, D> xi;
    std::copy_n(place.begin(), D, xi.begin());
    std::array<double, Element::nodes> value;
    std::array<std::array<double, D>, Element::nodes> gradient;
    Element::evaluate(xi, value, gradient);
    std::vector<double> point(D, 0.0);
    for (std::size_t a = 0; a < value.size(); ++a) {
      const auto node = static_cast<std::size_t>(block.nodes[cell_entry(cell, Element::nodes, static_cast<int>(a))]);
      for (std::size_t i = 0; i < D; ++i) point[i] += value[a] * mesh.coordinates[node * D + i];
    }
    return point;
  });
}

}  // namespace

const std::vector<CellMiddle>& cell_middles(int dimension) {
  static const auto all = [](int d) {
    const auto& corners = corners_of_nodes(d);
    std::map<std::set<int>, int> node_with;  // by the bits of its corners
    for (std::size_t a = 0; a < corners.size(); ++a) {
      std::set<int> bits;
      for (const int corner : corners[a]) bits.insert(corner_bits(corner));
      node_with[bits] = static_cast<int>(a);
    }
    std::vector<CellMiddle> found;
    for (std::size_t size = 2; size <= std::size_t{1} << d; size *= 2)
      for (const auto& [bits, node] : node_with)
        for (int axis = 0; bits.size() == size && axis < d; ++axis) {
          std::set<int> low, high;
          std::array<double, 3> place{};
          for (const int b : bits) {
            ((b >> axis & 1) != 0 ? high : low).insert(b);
            for (int k = 0; k < d; ++k)
              place[static_cast<std::size_t>(k)] += (b >> k & 1) / static_cast<double>(bits.size());
          }
          if (low.size() == high.size()) found.push_back({node, node_with.at(low), node_with.at(high), place});
        }
    return found;
  };
  static const auto quad = all(2), hex = all(3);
  return dimension == 2 ? quad : hex;
}

std::array<double, 3> direction_of(const Mesh& mesh, const TreeCell& cell, int axis) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::array<double, 3> sum{};
  for (int bits = 0; bits < 1 << mesh.dimension; ++bits) {
    const auto node = static_cast<std::size_t>(cell.corners[static_cast<std::size_t>(bits)]);
    for (std::size_t i = 0; i < d; ++i) sum[i] += ((bits >> axis & 1) != 0 ? 1 : -1) * mesh.coordinates[node * d + i];
  }
  return sum;
}

CellTree::CellTree(Mesh& mesh)
    : mesh_(mesh),
      blocks_(mesh.blocks),
      coordinates_(mesh.coordinates.size()),
      middles_(mesh.nodes()),
      longest_(mesh),
      edges_(at(mesh.dimension)) {
  for (int axis = 0; axis < mesh.dimension; ++axis)
    for (int bits = 0; bits < 1 << mesh.dimension; ++bits)
      if ((bits >> axis & 1) == 0) edges_[at(axis)].push_back({bits, bits | 1 << axis});
  for (const ElementBlock& block : blocks_) {
    first_root_.push_back(roots_);
    roots_ += block.cells();
  }
  add_roots();
  bound_levels();
}

void CellTree::add_roots() {
  corner_.assign(mesh_.coordinates.size() / at(mesh_.dimension), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = blocks_[b];
    const CellInfo &info = cell_info(block.type), &corners = cell_info(corner_type(block.type));
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* const nodes = &block.nodes[cell_entry(cell, info.nodes)];
      TreeCell own{static_cast<int>(b), cell, tree_shape(info.shape), static_cast<std::int8_t>(corners.nodes)};
      if (own.shape == TreeShape::Box) {
        own.lower = {-1, -1, -1};
        own.upper = {1, 1, 1};
      }
      for (int corner = 0; corner < corners.nodes; ++corner)
        own.corners[at(corner)] = nodes[own.shape == TreeShape::Box ? corner_bits(corner) : corner];
      for (int corner = 0; corner < corners.nodes; ++corner) corner_[at(own.corners[at(corner)])] = 1;
      if (own.shape == TreeShape::Simplex) {
        for (std::size_t k = 1; k < at(corners.nodes); ++k) own.vertices[k][k - 1] = 1;
        own.marks = longest_.marks(own);
      }
      cells_.push_back(own);
      if (!is_quadratic(block.type)) continue;
      if (own.shape == TreeShape::Box) {
        for (const CellMiddle& middle : cell_middles(mesh_.dimension))
          middles_.set(nodes[middle.low], nodes[middle.high], nodes[middle.node]);
      } else {
        for (std::size_t a = 0; a < info.node_corners.size(); ++a)
          if (const NodeCorners& ends = info.node_corners[a]; ends.size() == 2)
            middles_.set(nodes[ends[0]], nodes[ends[1]], nodes[a]);
      }
    }
  }
}

std::vector<int> CellTree::leaves() const {
  std::vector<int> result;
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (!cells_[k].is_split()) result.push_back(static_cast<int>(k));
  return result;
}

int CellTree::middle(const TreeCell& leaf, int a, int b, const RootPlace& place) {
  const int found = middles_.find(a, b);
  if (found >= 0) return found;
  add_node(mesh_, point_in(mesh_, blocks_[at(leaf.block)], leaf.root, place), -1);
  corner_.push_back(0);
  return middles_.add(a, b);
}

void CellTree::bisect(int cell, int axis) {
  const TreeCell whole = cells_[at(cell)];
  TreeCell low = whole, high = whole;
  const double half = (whole.lower[at(axis)] + whole.upper[at(axis)]) / 2;
  low.upper[at(axis)] = high.lower[at(axis)] = half;
  ++low.halvings[at(axis)];
  ++high.halvings[at(axis)];
  for (const auto& [left, right] : edges_[at(axis)]) {
    const int node =
        middle(whole, whole.corners[at(left)], whole.corners[at(right)], whole.middle_place({left, right}));
    corner_[at(node)] = 1;
    low.corners[at(right)] = high.corners[at(left)] = node;
  }
  cells_[at(cell)].first_child = static_cast<int>(cells_.size());
  cells_.push_back(low);
  cells_.push_back(high);
}

void CellTree::bisect_simplex(int cell) {
  const TreeCell whole = cells_[at(cell)];
  if (whole.halvings[0] == most_bisections)
    throw InputError(
        fmt::format("triangles and tetrahedra are bisected at most {} times; use fewer levels", most_bisections));
  const int low = whole.marks.refinement[0], high = whole.marks.refinement[1];
  const int node = middle(whole, whole.corners[at(low)], whole.corners[at(high)], whole.middle_place({low, high}));
  corner_[at(node)] = 1;
  cells_[at(cell)].first_child = static_cast<int>(cells_.size());
  for (const int end : {0, 1}) cells_.push_back(simplex_part(whole, end, node));
}

/// Halves a leaf along several axes at once; bisects a simplex.
void CellTree::halve(int cell, const std::vector<int>& axes) {
  if (cells_[at(cell)].shape == TreeShape::Simplex) return bisect_simplex(cell);
  std::vector<int> parts{cell};
  for (const int axis : axes) {
    std::vector<int> next;
    for (const int part : parts) {
      bisect(part, axis);
      next.push_back(cells_[at(part)].first_child);
      next.push_back(cells_[at(part)].first_child + 1);
    }
    parts = std::move(next);
  }
}

CornerBox CellTree::box_of(const TreeCell& cell) const {
  return box_around(mesh_, {cell.corners.begin(), cell.corners.begin() + cell.count});
}

/// Returns the halvings that a region asks of a cell that meets it, along each axis.
std::array<int, 3> CellTree::asked_halvings(const TreeCell& cell, const RegionSearch& region) const {
  std::array<int, 3> asked{};
  if (cell.shape == TreeShape::Whole) return asked;
  if (cell.shape == TreeShape::Simplex) return {region.levels(), 0, 0};
  for (int axis = 0; axis < mesh_.dimension; ++axis)
    if (region.splits_along(direction_of(mesh_, cell, axis))) asked[at(axis)] = region.levels();
  return asked;
}

std::vector<int> CellTree::axes_to_halve(const TreeCell& cell, const std::array<int, 3>& wanted) const {
  std::vector<int> axes;
  if (cell.shape == TreeShape::Whole) return axes;
  if (cell.shape == TreeShape::Simplex) {
    if (cell.halvings[0] < mesh_.dimension * wanted[0]) axes.push_back(0);
    return axes;
  }
  int fewest = 1 << 20;
  for (int axis = 0; axis < mesh_.dimension; ++axis)
    if (cell.halvings[at(axis)] < wanted[at(axis)]) fewest = std::min(fewest, cell.halvings[at(axis)]);
  for (int axis = 0; axis < mesh_.dimension; ++axis)
    if (cell.halvings[at(axis)] < wanted[at(axis)] && cell.halvings[at(axis)] == fewest) axes.push_back(axis);
  return axes;
}

std::vector<int> CellTree::wanted_axes(const TreeCell& cell, const std::vector<RegionSearch>& regions) {
  met_.resize(regions.size(), 0);
  const CornerBox box = box_of(cell);
  std::array<int, 3> wanted{};
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (!regions[r].meets(box)) continue;
    met_[r] = 1;
    const std::array<int, 3> asked = asked_halvings(cell, regions[r]);
    for (std::size_t axis = 0; axis < 3; ++axis) wanted[axis] = std::max(wanted[axis], asked[axis]);
  }
  return axes_to_halve(cell, wanted);
}

double CellTree::forecast(const RegionSearch& region, std::size_t sample) {
  std::vector<int> open = leaves();
  double all = static_cast<double>(open.size()), weight = 1;  // cells for which one of the sample stands
  while (!open.empty()) {
    std::vector<std::pair<int, std::vector<int>>> wanted;  // cells and axes
    for (const int leaf : open) {
      const TreeCell& cell = cells_[at(leaf)];
      if (!may_be_split(cell) || !region.meets(box_of(cell))) continue;
      std::vector<int> axes = axes_to_halve(cell, asked_halvings(cell, region));
      if (!axes.empty()) wanted.emplace_back(leaf, std::move(axes));
    }
    open.clear();
    const std::size_t stride = wanted.size() / sample + 1, kept = (wanted.size() + stride - 1) / stride;
    if (kept > 0) weight *= static_cast<double>(wanted.size()) / static_cast<double>(kept);
    for (std::size_t k = 0; k < wanted.size(); k += stride) {
      const auto& [leaf, axes] = wanted[k];
      const auto first = static_cast<int>(cells_.size());
      halve(leaf, axes);
      all += weight * ((1 << axes.size()) - 1);
      for (int part = first; part < static_cast<int>(cells_.size()); ++part)
        if (!cells_[at(part)].is_split()) open.push_back(part);
    }
  }
  return all;
}

void CellTree::refuse_more_than(long long most) const {
  if (static_cast<long long>(cells_.size()) > 2 * most)
    throw InputError(fmt::format("the refined mesh has more than {} cells; use fewer levels or smaller regions", most));
}

/// Splits once. Returns whether no cell would have to be split that stays whole.
bool CellTree::grow(const Wish& wish, bool in_all_directions, long long most) {
  bounded_.assign(at(roots_), 0);
  std::vector<int> open = leaves();
  while (!open.empty()) {
    const int cell = open.back();
    open.pop_back();
    const std::vector<int> axes = wish(cells_[at(cell)]);
    if (axes.empty()) continue;
    if (const TreeCell& own = cells_[at(cell)]; !may_be_split(own)) {
      bounded_[at(root(own.block, own.root))] = 1;
      continue;
    }
    const auto first = static_cast<int>(cells_.size());
    halve(cell, axes);
    for (int part = first; part < static_cast<int>(cells_.size()); ++part)
      if (!cells_[at(part)].is_split()) open.push_back(part);
    refuse_more_than(most);
  }
  torn_.clear();
  while (balance(in_all_directions) && torn_.empty()) refuse_more_than(most);
  return torn_.empty();
}

void CellTree::undo() {
  mesh_.coordinates.resize(coordinates_);
  middles_ = MiddleNodes(mesh_.nodes());
  cells_.clear();
  add_roots();
}

void CellTree::split(const Wish& wish, bool in_all_directions, long long most) {
  while (!grow(wish, in_all_directions, most)) {
    lower_bounds();
    undo();
  }
}

void CellTree::split(const std::vector<RegionSearch>& regions, const std::vector<std::string>& names, long long most) {
  met_.assign(regions.size(), 0);  // also of regions that no cell is compared with
  const bool in_all =
      std::all_of(regions.begin(), regions.end(), [](const auto& region) { return region.splits_all(); });
  split([&](const TreeCell& cell) { return wanted_axes(cell, regions); }, in_all, most);
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (met_[r] == 0)
      throw InputError(
          fmt::format("{}: no cell of the mesh meets the region; the mesh spans {}", names[r], span_in_words(mesh_)));
}

}  // namespace ixos

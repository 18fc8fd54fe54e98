#include "adapt/split_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Places = std::vector<std::optional<std::array<double, 3>>>;

/// Finds the points at which one shape function is 1 and all others vanish, of those that divide a side in up to four
/// parts.
Places places_of(CellType type) {
  constexpr int parts = 12;  // halves, thirds and quarters
  Places places(at(nodes_per_cell(type)));
  with_element(type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension;
    std::array<double, Element::nodes> value;
    std::array<std::array<double, D>, Element::nodes> gradient;
    std::array<double, D> xi;
    const int count = D == 2 ? (parts + 1) * (parts + 1) : (parts + 1) * (parts + 1) * 3;
    for (int k = 0; k < count; ++k) {
      xi[0] = -1 + 2.0 * (k % (parts + 1)) / parts;
      xi[1] = -1 + 2.0 * (k / (parts + 1) % (parts + 1)) / parts;
      if constexpr (D == 3) {
        const int layer = k / ((parts + 1) * (parts + 1));
        xi[2] = layer - 1;
      }
      Element::evaluate(xi, value, gradient);
      double others = 0;
      for (const double own : value) others += std::abs(own);
      for (std::size_t a = 0; a < value.size(); ++a) {
        if (std::abs(value[a] - 1) > 1e-9 || others > 1 + 1e-9) continue;
        std::array<double, 3> place{};
        std::copy(xi.begin(), xi.end(), place.begin());
        places[a] = place;
      }
    }
  });
  return places;
}

using Corners = std::set<int>;

}  // namespace

std::optional<std::array<double, 3>> reference_place(CellType type, std::size_t node) {
  static std::map<CellType, Places> known;
  auto found = known.find(type);
  if (found == known.end()) found = known.emplace(type, places_of(type)).first;
  return found->second[node];
}

SplitMesh::SplitMesh(Mesh base, Mesh mesh, SplitTree tree)
    : base_(std::move(base)), mesh_(std::move(mesh)), tree_(std::move(tree)) {
  find_cells();
  find_places();
}

/// A cell may be turned and in another block than its leaf: enrich() does that. Its corners tell which it is.
void SplitMesh::find_cells() {
  const int corners = 1 << mesh_.dimension;
  std::map<Corners, int> leaf_with;
  const std::vector<TreeCell>& all = tree_.cells();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].first_child < 0)
      leaf_with[Corners(all[k].corners.begin(), all[k].corners.begin() + corners)] = static_cast<int>(k);
  cells_.resize(all.size());
  for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
    const ElementBlock& block = mesh_.blocks[b];
    leaves_.emplace_back();
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* const nodes = &block.nodes[cell_entry(cell, nodes_per_cell(block.type))];
      const auto found = leaf_with.find(Corners(nodes, nodes + corners));
      if (found == leaf_with.end()) throw std::logic_error("a cell of the mesh is no leaf of its trees");
      leaves_.back().push_back(found->second);
      cells_[at(found->second)] = {static_cast<int>(b), cell};
    }
  }
}

int SplitMesh::leaf_of(const Cell& cell) const { return leaves_[at(cell.block)][at(cell.cell)]; }

int SplitMesh::face_of(const Cell& cell, int side) const {
  const ElementBlock& block = mesh_.blocks[at(cell.block)];
  const TreeCell& leaf = tree_.cell(leaf_of(cell));
  Corners own;
  for (const int corner : side_nodes(corner_type(block.type), side))
    own.insert(block.nodes[cell_entry(cell.cell, nodes_per_cell(block.type), corner)]);
  for (int face = 0; face < 2 * mesh_.dimension; ++face) {
    Corners of_face;
    for (int bits = 0; bits < 1 << mesh_.dimension; ++bits)
      if ((bits >> (face / 2) & 1) == face % 2) of_face.insert(leaf.corners[at(bits)]);
    if (of_face == own) return face;
  }
  throw std::logic_error("a side of the mesh is no face of its leaf");
}

SplitMesh::Axes SplitMesh::axes_of(const Cell& cell) const {
  const ElementBlock& block = mesh_.blocks[at(cell.block)];
  const TreeCell& leaf = tree_.cell(leaf_of(cell));
  const int* const nodes = &block.nodes[cell_entry(cell.cell, nodes_per_cell(block.type))];
  const auto corner = [&](int bits) {
    const int node = nodes[corner_bits(bits)];
    const auto found = std::find(leaf.corners.begin(), leaf.corners.begin() + (1 << mesh_.dimension), node);
    const auto own = static_cast<int>(found - leaf.corners.begin());
    std::array<double, 3> place{};
    for (int k = 0; k < mesh_.dimension; ++k) place[at(k)] = ((own >> k & 1) != 0 ? leaf.upper : leaf.lower)[at(k)];
    return place;
  };
  Axes axes;
  axes.origin = corner(0);
  for (int k = 0; k < mesh_.dimension; ++k) {
    const std::array<double, 3> next = corner(1 << k);
    for (int root = 0; root < mesh_.dimension; ++root)
      if (next[at(root)] != axes.origin[at(root)]) {
        axes.axis[at(k)] = root;
        axes.length[at(k)] = next[at(root)] - axes.origin[at(root)];
      }
  }
  return axes;
}

RootPoint SplitMesh::root_point(const Cell& cell, const std::array<double, 3>& xi) const {
  const TreeCell& leaf = tree_.cell(leaf_of(cell));
  const Axes axes = axes_of(cell);
  RootPoint point{leaf.block, leaf.root, axes.origin};
  for (int k = 0; k < mesh_.dimension; ++k) point.at[at(axes.axis[at(k)])] += (xi[at(k)] + 1) / 2 * axes.length[at(k)];
  return point;
}

std::array<double, 3> SplitMesh::reference_point(const Cell& cell, const RootPoint& point) const {
  const Axes axes = axes_of(cell);
  std::array<double, 3> xi{};
  for (int k = 0; k < mesh_.dimension; ++k) {
    const std::size_t root = at(axes.axis[at(k)]);
    xi[at(k)] = 2 * (point.at[root] - axes.origin[root]) / axes.length[at(k)] - 1;
  }
  return xi;
}

/// A node that an enriched side does not have, since its edge is tied, is a corner in its cell's list: corners and the
/// nodes of plain cells have their places first.
void SplitMesh::find_places() {
  places_.resize(at(mesh_.nodes()));
  for (const bool plain : {true, false})
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const ElementBlock& block = mesh_.blocks[b];
      const int n = nodes_per_cell(block.type), own = nodes_per_cell(plain_type(block.type));
      for (int cell = 0; cell < block.cells(); ++cell)
        for (int a = plain ? 0 : own; a < (plain ? own : n); ++a) {
          std::optional<RootPoint>& place = places_[at(block.nodes[cell_entry(cell, n, a)])];
          if (place) continue;
          if (const auto xi = reference_place(block.type, at(a))) place = root_point({static_cast<int>(b), cell}, *xi);
        }
    }
}

}  // namespace ixos

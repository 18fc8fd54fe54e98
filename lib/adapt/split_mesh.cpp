#include "adapt/split_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Places = std::vector<std::optional<std::array<double, 3>>>;

/// Whether an element knows the places of its nodes.
template <class Element, class = void>
struct HasPlaces : std::false_type {};
template <class Element>
struct HasPlaces<Element, std::void_t<decltype(Element::place(0))>> : std::true_type {};

/// Finds the points of a quadrilateral or a hexahedron at which one shape function is 1 and all others vanish, of those
/// that divide a side in up to four parts.
template <class Element>
Places places_in_grid() {
  constexpr int parts = 12;  // halves, thirds and quarters
  Places places(Element::nodes);
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
  return places;
}

Places places_of(CellType type) {
  return with_element(type, [](auto tag) {
    using Element = typename decltype(tag)::type;
    if constexpr (HasPlaces<Element>::value) {
      Places places;
      for (std::size_t a = 0; a < Element::nodes; ++a) {
        std::array<double, 3> place{};
        const auto own = Element::place(a);
        std::copy(own.begin(), own.end(), place.begin());
        places.emplace_back(place);
      }
      return places;
    } else {
      return places_in_grid<Element>();
    }
  });
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
  std::map<Corners, int> leaf_with;
  const std::vector<TreeCell>& all = tree_.cells();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].is_split())
      leaf_with[Corners(all[k].corners.begin(), all[k].corners.begin() + all[k].count)] = static_cast<int>(k);
  cells_.resize(all.size());
  for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
    const ElementBlock& block = mesh_.blocks[b];
    const int corners = nodes_per_cell(corner_type(block.type));
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
  if (leaf.shape == TreeShape::Whole) return side;
  Corners own;
  for (const int corner : side_nodes(corner_type(block.type), side))
    own.insert(block.nodes[cell_entry(cell.cell, nodes_per_cell(block.type), corner)]);
  for (int face = 0; face < leaf.faces(); ++face) {
    Corners of_face;
    for (const int corner : leaf.corners_on(face)) of_face.insert(leaf.corners[at(corner)]);
    if (of_face == own) return face;
  }
  if (leaf.shape == TreeShape::Simplex) return leaf.faces();
  throw std::logic_error("a side of the mesh is no face of its leaf");
}

SplitMesh::Axes SplitMesh::axes_of(const Cell& cell) const {
  const ElementBlock& block = mesh_.blocks[at(cell.block)];
  const TreeCell& leaf = tree_.cell(leaf_of(cell));
  Axes axes;
  axes.along = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (leaf.shape == TreeShape::Whole) return axes;
  const bool is_box = leaf.shape == TreeShape::Box;
  if (is_box) {
    axes.first = -1;
    axes.length = 2;
  }
  const int* const nodes = &block.nodes[cell_entry(cell.cell, nodes_per_cell(block.type))];
  const auto place = [&](int corner) {
    const auto found = std::find(leaf.corners.begin(), leaf.corners.begin() + leaf.count, nodes[corner]);
    return leaf.place(static_cast<int>(found - leaf.corners.begin()));
  };
  axes.origin = place(0);
  for (int k = 0; k < mesh_.dimension; ++k) {
    const RootPlace end = place(is_box ? corner_bits(1 << k) : k + 1);
    for (std::size_t i = 0; i < 3; ++i) axes.along[at(k)][i] = end[i] - axes.origin[i];
  }
  return axes;
}

RootPoint SplitMesh::root_point(const Cell& cell, const std::array<double, 3>& xi) const {
  const TreeCell& leaf = tree_.cell(leaf_of(cell));
  const Axes axes = axes_of(cell);
  RootPoint point{leaf.block, leaf.root, axes.origin};
  for (std::size_t k = 0; k < at(mesh_.dimension); ++k)
    for (std::size_t i = 0; i < 3; ++i) point.at[i] += (xi[k] - axes.first) / axes.length * axes.along[k][i];
  return point;
}

std::array<double, 3> SplitMesh::reference_point(const Cell& cell, const RootPoint& point) const {
  const Axes axes = axes_of(cell);
  Small<double, 3> columns;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) columns[i][k] = axes.along[k][i];
  const Small<double, 3> inverse = ixos::inverse(columns, determinant(columns));
  std::array<double, 3> xi{};
  for (std::size_t k = 0; k < at(mesh_.dimension); ++k) {
    double share = 0;
    for (std::size_t i = 0; i < 3; ++i) share += inverse[k][i] * (point.at[i] - axes.origin[i]);
    xi[k] = axes.first + axes.length * share;
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

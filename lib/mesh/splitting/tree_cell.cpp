#include "mesh/splitting/tree_cell.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/small_matrix.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Edge = MarkedEdges::Edge;

bool has(const Edge& edge, int corner) { return edge[0] == corner || edge[1] == corner; }

Edge edge_between(int a, int b) { return {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)}; }

/// Returns a point's shares of the corners of a simplex with those vertices.
std::array<double, 4> shares(const std::array<RootPlace, 4>& vertices, int dimension, const RootPlace& point) {
  const auto solve = [&](auto size) {
    constexpr std::size_t D = decltype(size)::value;
    Small<double, D> edges;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k) edges[i][k] = vertices[k + 1][i] - vertices[0][i];
    const Small<double, D> inverse = ixos::inverse(edges, determinant(edges));
    std::array<double, 4> share{1, 0, 0, 0};
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t i = 0; i < D; ++i) share[k + 1] += inverse[k][i] * (point[i] - vertices[0][i]);
      share[0] -= share[k + 1];
    }
    return share;
  };
  if (dimension == 2) return solve(std::integral_constant<std::size_t, 2>());
  return solve(std::integral_constant<std::size_t, 3>());
}

}  // namespace

TreeShape tree_shape(ReferenceShape shape) {
  switch (shape) {
    case ReferenceShape::Quadrilateral:
    case ReferenceShape::Hexahedron:
      return TreeShape::Box;
    case ReferenceShape::Triangle:
    case ReferenceShape::Tetrahedron:
      return TreeShape::Simplex;
    default:
      return TreeShape::Whole;
  }
}

MarkedEdges MarkedEdges::of_part(int end, int corners) const {
  const int kept = refinement[at(end)], middle = refinement[at(1 - end)];  // the middle takes the other end's place
  MarkedEdges part;
  if (corners == 3) {
    part.refinement = edge_between(kept, 3 - kept - middle);
    return part;
  }
  std::array<int, 2> others{};  // the corners that are not on the edge
  for (int corner = 0, k = 0; corner < 4; ++corner)
    if (!has(refinement, corner)) others[at(k++)] = corner;
  // The marked edges of the two faces that stay whole, from an end each; both meet if all lie in one plane.
  const Edge own = faces[at(middle)], other = faces[at(kept)];
  const auto apex = [&](int corner) { return has(own, corner) && has(other, corner); };
  const bool from_ends = has(own, kept) && has(other, middle);
  const int shared = apex(others[0]) ? others[0] : apex(others[1]) ? others[1] : -1;
  const bool planar = from_ends && shared >= 0;
  part.refinement = part.faces[at(middle)] = own;
  part.faces[at(others[0])] = edge_between(kept, others[1]);
  part.faces[at(others[1])] = edge_between(kept, others[0]);
  part.faces[at(kept)] = planar && flagged ? edge_between(middle, shared) : edge_between(others[0], others[1]);
  part.flagged = planar && !flagged;
  return part;
}

RootPlace TreeCell::place(int corner) const {
  if (shape == TreeShape::Simplex) return vertices[at(corner)];
  RootPlace place{};
  for (int k = 0; k < dimension(); ++k) place[at(k)] = ((corner >> k & 1) != 0 ? upper : lower)[at(k)];
  return place;
}

RootPlace TreeCell::middle_place(const std::vector<int>& some) const {
  RootPlace middle{};
  for (const int corner : some) {
    const RootPlace own = place(corner);
    for (std::size_t i = 0; i < 3; ++i) middle[i] += own[i] / static_cast<double>(some.size());
  }
  return middle;
}

double TreeCell::depth(const RootPlace& point) const {
  if (shape == TreeShape::Whole) return 0;
  if (shape == TreeShape::Simplex) {
    const std::array<double, 4> share = shares(vertices, dimension(), point);
    return *std::min_element(share.begin(), share.begin() + count);
  }
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < at(dimension()); ++k) least = std::min({least, point[k] - lower[k], upper[k] - point[k]});
  return least;
}

bool TreeCell::contains(const TreeCell& other) const {
  if (shape == TreeShape::Whole) return true;
  if (shape == TreeShape::Simplex) {
    const int further = other.halvings[0] - halvings[0];
    return further >= 0 && other.path >> further == path;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (other.lower[k] < lower[k] || other.upper[k] > upper[k]) return false;
  return true;
}

bool TreeCell::is_same_part(const TreeCell& other) const {
  if (block != other.block || root != other.root) return false;
  return shape == TreeShape::Box ? lower == other.lower && upper == other.upper
                                 : halvings == other.halvings && path == other.path;
}

std::vector<int> TreeCell::corners_on(int face) const {
  std::vector<int> on;
  for (int corner = 0; corner < count; ++corner)
    if (shape == TreeShape::Simplex ? barycentric(vertices[at(corner)], dimension())[at(face)] == 0
                                    : (corner >> (face / 2) & 1) == face % 2)
      on.push_back(corner);
  return on;
}

bool TreeCell::touches(int face) const {
  if (shape == TreeShape::Whole) return false;
  if (shape == TreeShape::Simplex) return corners_on(face).size() == at(dimension());
  return face % 2 == 0 ? lower[at(face / 2)] == -1 : upper[at(face / 2)] == 1;
}

std::array<double, 4> barycentric(const RootPlace& point, int dimension) {
  std::array<double, 4> result{1, 0, 0, 0};
  for (std::size_t i = 0; i < at(dimension); ++i) {
    result[i + 1] = point[i];
    result[0] -= point[i];
  }
  return result;
}

TreeCell simplex_part(const TreeCell& whole, int end, int middle) {
  TreeCell part = whole;
  const int moved = whole.marks.refinement[at(1 - end)];
  part.corners[at(moved)] = middle;
  part.vertices[at(moved)] = whole.middle_place({whole.marks.refinement[0], whole.marks.refinement[1]});
  part.marks = whole.marks.of_part(end, whole.count);
  ++part.halvings[0];
  part.path = whole.path << 1U | static_cast<std::uint64_t>(end);
  part.first_child = -1;
  return part;
}

}  // namespace ixos

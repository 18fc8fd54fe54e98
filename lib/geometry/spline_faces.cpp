#include "geometry/spline_faces.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

std::size_t at(int number) { return static_cast<std::size_t>(number); }

void add(const NodeWeights& part, double factor, NodeWeights& sum) {
  for (std::size_t k = 0; k < part.nodes.size(); ++k) sum.add(part.nodes[k], factor * part.weights[k]);
}

void add_once(std::vector<int>& values, int value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

}  // namespace

SplineFaces::SplineFaces(const SideGrid& grid) : grid_(grid) {
  for (int f = 0; f < static_cast<int>(grid.faces().size()); ++f)
    for (const int node : grid.faces()[at(f)]) {
      if (at(node) >= vertices_.size()) vertices_.resize(at(node) + 1);
      Vertex& vertex = vertices_[at(node)];
      vertex.faces.push_back(f);
      for (const int end : ends(f, node)) {
        add_once(vertex.ends, end);
        if (grid.is_crease(node, end)) add_once(vertex.creases, end);
      }
    }
  for (std::size_t node = 0; node < vertices_.size(); ++node) {
    Vertex& vertex = vertices_[node];
    vertex.goes_on =
        vertex.creases.size() == 2 && grid.continuation(static_cast<int>(node), vertex.creases[0]) == vertex.creases[1];
    controls_.push_back(vertex.faces.empty() ? NodeWeights() : control_of(static_cast<int>(node)));
  }
}

/// Returns the other ends of a face's edges at one of its corners.
std::array<int, 2> SplineFaces::ends(int face, int node) const {
  const SideGrid::Face& c = grid_.faces()[at(face)];
  const auto here = static_cast<std::size_t>(std::find(c.begin(), c.end(), node) - c.begin());
  return {c[(here + 1) % 4], c[(here + 3) % 4]};
}

/// Nodes where creases end, meet at an angle, or are more than two stay where they are.
NodeWeights SplineFaces::control_of(int node) const {
  const Vertex& vertex = vertices_[at(node)];
  const bool smooth = vertex.creases.empty();
  const auto n = static_cast<double>(vertex.faces.size());
  const double share = smooth ? (6 + 2 * std::cos(2 * M_PI / n)) / (n * (n + 5)) : vertex.goes_on ? 1.0 / 6 : 0;
  const std::vector<int>& around = smooth ? vertex.ends : vertex.creases;
  NodeWeights result;
  result.add(node, 1 + share * static_cast<double>(around.size()));
  if (share > 0)
    for (const int end : around) result.add(end, -share);
  return result;
}

/// Returns the number n of faces that counts in the control point inside the face. At a crease it is twice that of the
/// face's side, and 4 at least, as if the surface went on straight beyond it.
std::size_t SplineFaces::valence(int face, int node) const {
  const Vertex& vertex = vertices_[at(node)];
  if (vertex.creases.size() < 2) return vertex.faces.size();
  std::size_t count = 1;
  for (const int first : ends(face, node)) {
    int at_face = face, edge = first;
    while (!grid_.is_crease(node, edge)) {
      at_face = grid_.across(at_face, node, edge);
      ++count;
      const std::array<int, 2> both = ends(at_face, node);
      edge = both[0] == edge ? both[1] : both[0];
    }
  }
  return std::max<std::size_t>(4, 2 * count);
}

/// Adds factor times the control point inside the face next to one of its corners.
void SplineFaces::add_inner(int face, int node, double factor, NodeWeights& sum) const {
  const auto n = static_cast<double>(valence(face, node));
  const double share = factor / (n + 5);
  add(controls_[at(node)], n * share, sum);
  for (const int end : ends(face, node)) add(controls_[at(end)], 2 * share, sum);
  add(controls_[at(grid_.opposite(face, node))], share, sum);
}

/// Returns the control point on an edge next to one of its ends.
NodeWeights SplineFaces::edge(int face, int node, int end) const {
  NodeWeights result;
  if (grid_.is_crease(node, end)) {
    add(controls_[at(node)], 2.0 / 3, result);
    add(controls_[at(end)], 1.0 / 3, result);
  } else {
    add_inner(face, node, 0.5, result);
    add_inner(grid_.across(face, node, end), node, 0.5, result);
  }
  return result;
}

NodeWeights SplineFaces::corner(int node) const {
  const Vertex& vertex = vertices_[at(node)];
  NodeWeights result;
  if (vertex.creases.empty()) {
    for (const int face : vertex.faces) add_inner(face, node, 1 / static_cast<double>(vertex.faces.size()), result);
  } else if (vertex.goes_on) {
    add(controls_[at(node)], 2.0 / 3, result);
    for (const int end : vertex.creases) add(controls_[at(end)], 1.0 / 6, result);
  } else {
    add(controls_[at(node)], 1, result);
  }
  return result;
}

std::array<NodeWeights, 16> SplineFaces::controls(int face) const {
  // By corner: those at the other ends of its edges along the first and the second parameter.
  constexpr std::array<std::array<std::size_t, 2>, 4> along{{{1, 3}, {0, 2}, {3, 1}, {2, 0}}};
  const SideGrid::Face& c = grid_.faces()[at(face)];
  std::array<NodeWeights, 16> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t i = k == 1 || k == 2 ? 3 : 0, j = k >= 2 ? 3 : 0;
    const std::size_t inner_i = i == 0 ? 1 : 2, inner_j = j == 0 ? 1 : 2;
    result[4 * j + i] = corner(c[k]);
    result[4 * j + inner_i] = edge(face, c[k], c[along[k][0]]);
    result[4 * inner_j + i] = edge(face, c[k], c[along[k][1]]);
    add_inner(face, c[k], 1, result[4 * inner_j + inner_i]);
  }
  return result;
}

}  // namespace ixos

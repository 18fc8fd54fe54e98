/// The nodes that contact elements add to a mesh: parts of enrich().
#pragma once
#include <set>
#include <utility>
#include <vector>

#include "mesh/added_nodes.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// The nodes of an enriched side beyond its corners.
struct ExtraNodes {
  std::vector<int> nodes;                ///< in the order of the side's element
  std::vector<double> derivative_scale;  ///< see ElementBlock
  unsigned tied = 0;                     ///< see ElementBlock
};

using Edge = std::pair<int, int>;

/// Returns one key for both directions of an edge.
Edge edge_key(int a, int b);

/// Returns the length of the straight line between an edge's nodes [L0]; the direction of the edge does not matter.
double length(const Mesh& mesh, const Edge& edge);

/// Returns the edges of a set of faces that also belong to a hexahedron without a face of the set there, by edge_key(),
/// those with hanging nodes, coarse and fine, and those on periodic sides: they keep the field of plain cells, which
/// ties make continuous.
std::set<Edge> tied_edges(const Mesh& mesh, const SideSet& set);

/// Adds the nodes of Lagrange sides of that order (2 to 4), equally spaced on edges and faces, and returns them side by
/// side of the set. Edges of tied_edges() get no nodes, but their bit in `tied`.
std::vector<ExtraNodes> add_lagrange_nodes(Mesh& mesh, const SideSet& set, int order);

/// Adds the nodes at the quarters of quadratic sides, which Q2C4 needs, on the sides' quadratic curves and faces, and
/// returns them side by side of the set: those of the edges, in 3D then those inside the face, row by row. Edges of
/// tied_edges() get no nodes, but their bit in `tied`.
std::vector<ExtraNodes> add_quarter_nodes(Mesh& mesh, const SideSet& set);

/// Adds the derivative nodes of Hermite sides of quadrilaterals, one for each node of the set, and returns them side by
/// side of the set.
std::vector<ExtraNodes> add_hermite_nodes(Mesh& mesh, const SideSet& set);

/// Adds the derivative nodes of Hermite faces of hexahedra, three for each node of the set, and returns them face by
/// face of the set. Edges of tied_edges() need none along them, and set their bit in `tied`. Throws InputError if the
/// faces are no regular grid: other than four around a node inside the set, or more than three around one of its rim.
std::vector<ExtraNodes> add_hermite_face_nodes(Mesh& mesh, const SideSet& set);

}  // namespace ixos

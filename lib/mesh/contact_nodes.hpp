/// The nodes that contact elements add to a mesh: parts of enrich().
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// What an enriched side has beyond its corners.
struct ExtraNodes {
  std::vector<int> nodes;                ///< in the order of the side's element
  std::vector<double> derivative_scale;  ///< see ElementBlock
  unsigned tied = 0;                     ///< see ElementBlock
};

/// The corners of a side of a plain cell, counter-clockwise seen from outside.
std::vector<int> side_corners(const Mesh& mesh, const Side& side);

/// A new node at the mesh's end; `derivative_of` as in Mesh.
int add_node(Mesh& mesh, const std::vector<double>& x, int derivative_of);

/// The places of nodes between others.
struct Between {
  std::vector<int> corners;
  std::vector<int> nodes;
};

/// Gives each node set that holds all of the corners the nodes between them.
void complete_node_sets(Mesh& mesh, const std::vector<Between>& added);

/// Nodes of Lagrange sides of that order (2 to 4), equally spaced on edges and faces; side by side of the set. An edge
/// that also belongs to a hexahedron without a face of the set there is tied: no nodes, and the bit in `tied`.
std::vector<ExtraNodes> add_lagrange_nodes(Mesh& mesh, const SideSet& set, int order);

/// Derivative nodes of Hermite sides of quadrilaterals, one for each node of the set; side by side of the set.
std::vector<ExtraNodes> add_hermite_nodes(Mesh& mesh, const SideSet& set);

}  // namespace ixos

/// Is a mesh of hexahedra with enriched faces one continuous body?
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos::test {

using Place = std::array<double, 3>;

/// Where a node's coordinate stands in the mesh's.
inline std::size_t at_node(int node, std::size_t d) { return 3 * static_cast<std::size_t>(node) + d; }

const int* cell_nodes(const ElementBlock& block, int cell);

/// The value of a nodal field in a cell at a reference point.
double value_in(const ElementBlock& block, int cell, const Place& xi, const std::vector<double>& field);

/// Every cell at a face or an edge must have the same field there.
void expect_conforming(const Mesh& mesh, const std::string& what);

/// That; the element of each side is the trace of its cell; and every new node is used, and none is there twice.
void expect_sound(Mesh& mesh, const std::string& what);

}  // namespace ixos::test

/// Is a mesh of hexahedra with enriched faces one continuous body?
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/mesh.hpp"

namespace ixos::test {

using Place = std::array<double, 3>;

/// Where a node's coordinate stands in the mesh's.
inline std::size_t at_node(int node, std::size_t d) { return 3 * static_cast<std::size_t>(node) + d; }

const int* cell_nodes(const ElementBlock& block, int cell);

/// The value of a nodal field in a cell at a reference point.
double value_in(const ElementBlock& block, int cell, const Place& xi, const std::vector<double>& field);

/// Values without any order, by node.
std::vector<double> random_field(const Mesh& mesh);

/// The reference point of a cell that lies between some of its corners, by global node and weight.
Place between(const ElementBlock& block, int cell, const std::map<int, double>& weights);

/// The cells, by block and number, that have a face or an edge, by its sorted corners.
using Cells = std::map<std::vector<int>, std::vector<std::pair<std::size_t, int>>>;

Cells faces_and_edges(const Mesh& mesh);

/// The map from reference to body must be that of the plain hexahedron.
void expect_plain_map(const Mesh& mesh, const ElementBlock& block);

/// Every cell at a face or an edge must have the same field there.
void expect_conforming(const Mesh& mesh, const std::string& what);

/// That; the element of each side is the trace of its cell; and every new node is used, and none is there twice.
void expect_sound(Mesh& mesh, const std::string& what);

/// That of a brick with a patch of these elements on one of its sides: patches of all shapes.
void expect_patches_conform(ContactElement element);

/// That of a brick with three sets: these elements beside Q1C4 on one side, and Q1C3 on another.
void expect_sets_conform(ContactElement element);

}  // namespace ixos::test

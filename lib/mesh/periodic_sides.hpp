/// Sides of a mesh that are one: what leaves through the one comes in through the other.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// Ties the nodes of the side set `secondary` to those of `primary` that stand elsewhere by one translation, the same
/// for all: that between the middles of both sets' nodes. Nodes that follow nodes of `secondary` already stay so: those
/// of other periodic sides at their edges, and hanging ones, whose masters are tied. The reference places of both sides
/// stay apart.
///
/// `tolerance`: how far a node may be off its partner's place [L0]; 0: place_tolerance() of the mesh. Throws InputError
/// if a set does not exist, both have common nodes or other numbers of nodes, a node has no partner, whose place is
/// given, or one that another node has, a node follows nodes beyond `secondary`, the mesh is axisymmetric and the
/// translation not along its axis, and if the mesh is enriched.
void make_periodic(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance);

}  // namespace ixos

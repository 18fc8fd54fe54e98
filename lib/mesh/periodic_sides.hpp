/// Sides of a mesh that are one: what leaves through the one comes in through the other.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Nodes that follow others already, and the partners as which they must move.
using PeriodicNodes = std::vector<std::pair<int, int>>;

/// Ties the nodes of the side set `secondary` to those of `primary` that stand elsewhere by one translation, the same
/// for all: that between the middles of both sets' nodes. Nodes that are tied already stay so, and are returned with
/// their partners for require_periodic(): those of other periodic sides at their edges, those where tied parts meet,
/// and hanging ones. The reference places of both sides stay apart. Where several nodes stand at one place, the partner
/// is the one beside the neighbours' partners.
///
/// `tolerance`: how far a node may be off its partner's place [L0]; 0: place_tolerance() of the mesh. Throws InputError
/// if a set does not exist, both have common nodes or other numbers of nodes, a node has no partner, whose place is
/// given, or one that another node has, the mesh is axisymmetric and the translation not along its axis, and if the
/// mesh is enriched.
PeriodicNodes make_periodic(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance);

/// Throws InputError, with the place, if one of the nodes does not move as its partner once all ties are made.
void require_periodic(const Mesh& mesh, const PeriodicNodes& nodes);

}  // namespace ixos

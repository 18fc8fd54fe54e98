/// Enriched contact sides.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// The contact element of a side set: displacement along the side linear, of order 2, 3 or 4 (Lagrange), or cubic with
/// continuous derivative (Hermite).
enum class ContactElement { Q1C1, Q1C2, Q1C3, Q1C4, Q1CH };

/// Gives the sides of the set that contact element: their cells leave their block for one of the same name behind it,
/// with side 0 on the set, and extra nodes are added at the mesh's end, equally spaced along straight sides (Hermite:
/// one derivative node for each node of the set, whose direction is the mean of its sides': a kink is rounded). A node
/// set that holds both ends of a side gets the side's extra nodes. `points` are Gauss points along the side, 0 for the
/// element's own. Q1C1 changes nothing. Throws InputError where a cell is not a quadrilateral, has two sides in the
/// set, or is enriched already.
void enrich(Mesh& mesh, const std::string& side_set, ContactElement element, int points = 0);

}  // namespace ixos

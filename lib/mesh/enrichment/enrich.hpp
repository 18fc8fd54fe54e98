/// Enriched contact sides.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// The contact element of a side set: displacement along the side, in 3D in both directions, linear, of order 2, 3 or 4
/// (Lagrange), or cubic with continuous derivatives (Hermite); Q2C2 is the side of quadratic cells as it is,
/// Q2C4 theirs with order 4.
enum class ContactElement { Q1C1, Q1C2, Q1C3, Q1C4, Q1CH, Q2C2, Q2C4 };

/// Returns the contact element that sides of the set have if a program asks for `asked`: the same, but Q2C2 for Q1C1 on
/// quadratic cells. Throws InputError if linear cells should have Q2C2 or Q2C4, or quadratic ones Q1C2, Q1C3, Q1C4 or
/// Q1CH.
ContactElement fitting_element(const Mesh& mesh, const SideSet& set, ContactElement asked);

/// Gives the sides of the set that contact element: their cells leave their block for others of the same name behind
/// it, with contact_side() on the set, and extra nodes are added at the mesh's end, equally spaced along straight sides
/// and on bilinear faces, on quadratic ones at the quarters (Hermite: a derivative node for each node of the set, in 3D
/// two and one for the mixed derivative, whose direction is the mean of its sides': a kink is rounded). A node set that
/// holds both ends of an edge, or all corners of a face, gets the nodes between them. `points` are Gauss points along
/// the side, 0 for the element's own. Q1C1 and Q2C2 change nothing.
///
/// An edge of an enriched face that also belongs to a hexahedron without a face of the set there (at the rim of the
/// set, inside a body) is tied: it stays as in its plain cell and gets no nodes (ElementBlock::tied).
/// At a free rim it is enriched
/// as any other. Throws InputError if fitting_element() does, if a cell has two sides in the set or is enriched
/// already, and if the faces of a set with Q1CH are no regular grid: four around each node inside it, at most three
/// around one of its rim.
void enrich(Mesh& mesh, const std::string& side_set, ContactElement element, int points = 0);

}  // namespace ixos

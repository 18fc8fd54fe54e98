/// Surfaces of different meshes that move as one.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// Ties the nodes of the side set `secondary` to those of `primary`, which faces it: a mortar method with dual shape
/// functions (Wohlmuth 2000, SIAM J. Numer. Anal. 38; in space Popp, Gitterle, Gee, Wall 2010, Int. J. Numer. Methods
/// Eng. 83). With psi_i dual to the shape functions of the secondary sides, int psi_i N_j = delta_ij int N_i, the ties
/// are u_i = sum_k w_ik u_k, w_ik = int psi_i N_k / int N_i over the secondary surface: int psi_i (u - u_primary) = 0.
/// Sides are projected along the secondary side's normal and clipped by each other; each part has its own
/// points of quadrature. Where both surfaces end together, the boundary follows the boundary: mortar_weights(). Affine
/// motions pass from the one surface to the other, and constant stress comes back: exactly for straight sides of plane
/// surfaces, to rounding where the sides are parallelograms. A curved edge of a quadratic side counts as its chords. On
/// an axisymmetric mesh the integrals are those of the surface of revolution.
///
/// On curved surfaces the integrals are those over the projections. Rims within `tolerance` of each other count as one,
/// so that a rim moves onto the other. Sides at a rim may be covered but for a tenth.
///
/// Moves the tied nodes to where their masters put them. Primary nodes may be tied themselves, secondary ones not. Adds
/// the nodes of both sets to Mesh::nodes_of_tied_sides.
///
/// `tolerance`: how far the surfaces may be apart, and how far a node may move [L0]; 0: a twentieth of the longest
/// diagonal of the secondary side in question. Throws InputError if a set does not exist or is empty, both have common
/// nodes, secondary sides are triangles of six nodes or not twice as long as the tolerance, the primary sides do not
/// cover the secondary ones, once each, or are too far away, if a secondary node is tied already, and if the mesh is
/// enriched. Adds a note of how far nodes moved.
void tie_surfaces(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance);

}  // namespace ixos

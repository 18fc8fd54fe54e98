/// The weights of a mortar tie.
#pragma once
#include <functional>
#include <map>
#include <vector>

#include "mesh/mortar/facing_parts.hpp"

namespace ixos {

/// Two surfaces, or two curves.
struct MortarSurfaces {
  std::vector<Facet> secondary, primary;
  bool axisymmetric = false;
  std::function<double(const Facet&)> reach;  ///< how far a secondary facet may be from the primary ones [L0]
};

/// Returns what each secondary facet faces.
std::vector<FacingParts> all_facing_parts(const MortarSurfaces& surfaces);

/// Returns whether the parts cover a facet, once, but for the rounding of a file's coordinates. At the rim of a surface
/// a tenth may be missing: a round rim is a polygon, and other divisions make another one.
bool is_covered(const FacingParts& parts, bool at_rim);

/// Returns which facets are at the rim of their surface; none of a curve.
std::vector<bool> facets_at_rim(const std::vector<Facet>& facets);

/// By secondary node: the primary nodes that it follows, and their weights [-].
struct MortarWeights {
  std::map<int, std::map<int, double>> of_node;
  const Facet* failed = nullptr;  ///< a secondary facet that cannot be projected; the weights are then void
};

/// Returns the weights of each secondary node, see tie_surfaces(). `parts`: all_facing_parts(), which cover all facets.
///
/// Where the boundary of the secondary surface lies on that of the primary one, its nodes follow that boundary alone,
/// by the same method; where both have a corner, the corner. Then forces on the boundary stay there, and a condition
/// that holds both boundaries holds the tie. The dual functions of these nodes go to their neighbours inside in equal
/// shares: all functions still add up to 1 (compare Bernardi, Maday and Patera 1994). If a node has no such neighbour,
/// the whole boundary follows the surface.
MortarWeights mortar_weights(const MortarSurfaces& surfaces, const std::vector<FacingParts>& parts);

}  // namespace ixos

/// Meshes that are finer in chosen places.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/splitting/refined_region.hpp"

namespace ixos {

/// A region and its name in messages.
struct NamedRegion {
  std::string name;
  RefinedRegion region;
};

/// The most cells that refine() makes.
constexpr long long most_refined_cells = 10'000'000;

/// Splits cells of a mesh of quadrilaterals or hexahedra, all linear or all quadratic, until those in the regions have
/// the halvings that the regions ask for. Neighbours differ by one halving at most: their edges have at most one corner
/// of others, in the middle. A cell that is split for that reason alone is halved in all directions if all regions are.
/// The nodes of finer cells on edges and faces of coarser ones hang there: they get a Tie, which makes displacements
/// continuous. Side sets have the parts of their sides. A node set that has the nodes of the side set of its name keeps
/// having them; another one gets the new nodes in the middle of two nodes of the set.
///
/// `order`: that of the cells. 1 of a quadratic mesh leaves its corners: it gives the curved places of the new ones.
/// Throws InputError, with the name, if a region is none of the mesh or meets no cell, and if the mesh is enriched, has
/// ties, or would have more than most_refined_cells.
void refine(Mesh& mesh, const std::vector<NamedRegion>& regions, int order);

}  // namespace ixos

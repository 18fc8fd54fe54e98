/// Meshes that are finer in chosen places.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/splitting/cell_splits.hpp"
#include "mesh/splitting/refined_region.hpp"
#include "mesh/splitting/split_tree.hpp"

namespace ixos {

/// A region and its name in messages.
struct NamedRegion {
  std::string name;
  RefinedRegion region;
};

/// Returns whether the mesh has triangles or tetrahedra.
bool has_simplices(const Mesh& mesh);

/// The most cells that refine() makes.
constexpr long long most_refined_cells = 10'000'000;

/// Splits cells of a mesh, all linear or all quadratic, until those in the regions have the halvings that the regions
/// ask for. Prisms and pyramids stay as they are, and so do cells beside them.
///
/// Quadrilaterals and hexahedra are halved along their axes. Neighbours differ by one halving at most: their edges have
/// at most one corner of others, in the middle. A cell that is split for that reason alone is halved in all directions
/// if all regions are. The nodes of finer cells on edges and faces of coarser ones hang there: they get a Tie, which
/// makes displacements continuous. Triangles and tetrahedra are bisected, D times for a level, which divides their
/// volume as halved edges would, see MarkedEdges; their neighbours are bisected until none has a node of others, so
/// that nothing hangs.
///
/// Side sets have the parts of their sides. A node set that has the nodes of the side set of its name keeps having
/// them; another one gets the new nodes in the middle of two nodes of the set.
///
/// `order`: that of the cells. 1 of a quadratic mesh leaves its corners: it gives the curved places of the new ones.
/// Returns the trees of the cells, whose leaves are those of the mesh. Throws InputError, with the name, if a region is
/// none of the mesh, meets no cell, or has directions where there are simplices, and if the mesh is enriched, has ties,
/// has only prisms and pyramids, or would have more than most_refined_cells.
SplitTree refine(Mesh& mesh, const std::vector<NamedRegion>& regions, int order);

/// Does the same for the splits of another mesh that was made of the same cells. The numbers of the new nodes depend on
/// the splits alone.
SplitTree split(Mesh& mesh, const CellSplits& splits, int order);

/// How the cells of a scene's mesh are split.
struct Splitting {
  std::vector<NamedRegion> regions{};
  const CellSplits* splits = nullptr;  ///< in place of the regions
  /// If the mesh may change later, are set to the mesh before its cells are split, and to the trees of its cells; the
  /// numbers of nodes then depend on the splits alone, whatever asked for them.
  Mesh* base = nullptr;
  SplitTree* tree = nullptr;

  bool any() const { return !regions.empty() || tree != nullptr; }
};

/// Splits the cells as asked; changes nothing if nothing is. Throws InputError as refine() does.
void split(Mesh& mesh, const Splitting& splitting, int order);

}  // namespace ixos

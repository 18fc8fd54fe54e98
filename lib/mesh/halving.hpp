/// Coarse meshes of which finer ones come by halving all cells in each direction.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// The parents of a mesh's linear cells, four in the plane or eight in space to a parent. A node is a corner of
/// parents, or in the middle of an edge, a face or the inside of one; `corner` names the corners of that edge, face or
/// parent. Linear displacements of the parents move the node by their mean.
struct Halving {
  Mesh coarse;                           ///< the parents, in one block, without sets
  std::vector<int> fine_node;            ///< per node of `coarse`: the same node in the fine mesh, ascending
  std::vector<std::vector<int>> parent;  ///< per block and cell of the fine mesh: a cell of `coarse`
  std::vector<std::size_t> first_share;  ///< by fine node: where its corners begin; one more entry than nodes
  std::vector<int> corner;               ///< nodes of `coarse`, ascending for each fine node
};

/// Returns the parents of a mesh, whose places play no part: each inner node of a parent has four or eight cells, and
/// where two parents meet, their cells do. Null if there are none, if cells are not all linear quadrilaterals or
/// hexahedra, if the mesh is axisymmetric, or if enrich() changed it. Takes a time proportional to the cells.
std::optional<Halving> halve(const Mesh& mesh);

/// A rank's part of a Halving. The rank that owns a fine node owns its coarse one, in the same order. Besides the
/// parents around its own coarse nodes, the rank sees the parents of all its local fine cells.
struct LocalHalving {
  LocalMesh coarse;
  std::vector<int> number;               ///< by local fine node: its local coarse node; -1 if it is none
  std::vector<std::size_t> first_share;  ///< as in Halving, of local fine nodes
  std::vector<int> corner;               ///< local coarse nodes
};

/// Extracts rank `rank`'s part. `fine` must be the part that localize() extracts for the same owners.
LocalHalving localize(const Halving& halving, const std::vector<int>& node_owner, int rank, int ranks,
                      const LocalMesh& fine);

/// Sets `fine.halving` to rank `rank`'s part of the parents of a mesh's cells; leaves it null if there are none.
/// `fine`: as above.
void add_parents(const Mesh& mesh, const std::vector<int>& node_owner, int rank, int ranks, LocalMesh& fine);

}  // namespace ixos

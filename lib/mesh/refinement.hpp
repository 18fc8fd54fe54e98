/// Coarse meshes whose cells, halved in each direction, are those of a finer mesh.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// The coarse cells of a mesh's linear cells, four in the plane or eight in space to a coarse cell. A node is a corner
/// of coarse cells, or in the middle of an edge, a face or the inside of one; `corner` names the corners of that edge,
/// face or coarse cell. Linear displacements of the coarse cells move the node by their mean.
struct Refinement {
  Mesh coarse;                                ///< the coarse cells, in one block, without sets
  std::vector<int> fine_node;                 ///< per node of `coarse`: the same node in the fine mesh, ascending
  std::vector<std::vector<int>> coarse_cell;  ///< per block and cell of the fine mesh: a cell of `coarse`
  std::vector<std::size_t> first_share;       ///< by fine node: where its corners begin; one more entry than nodes
  std::vector<int> corner;                    ///< nodes of `coarse`, ascending for each fine node
};

/// Returns the coarse cells of a mesh, whose places play no part: each inner node of a coarse cell has four or eight
/// cells, and where two coarse cells meet, their cells do. Null if there are none, if cells are not all linear
/// quadrilaterals or hexahedra, if the mesh is axisymmetric, or if enrich() changed it. Takes a time proportional to
/// the cells.
std::optional<Refinement> find_refinement(const Mesh& mesh);

/// A rank's part of a Refinement. The rank that owns a fine node owns its coarse one, in the same order. Besides the
/// coarse cells around its own coarse nodes, the rank sees the coarse cells of all its local fine cells.
struct LocalRefinement {
  LocalMesh coarse;
  std::vector<int> number;               ///< by local fine node: its local coarse node; -1 if it is none
  std::vector<std::size_t> first_share;  ///< as in Refinement, of local fine nodes
  std::vector<int> corner;               ///< local coarse nodes
};

/// Extracts rank `rank`'s part. `fine` must be the part that localize() extracts for the same owners.
LocalRefinement localize(const Refinement& refinement, const std::vector<int>& node_owner, int rank, int ranks,
                         const LocalMesh& fine);

/// Sets `fine.refinement` to rank `rank`'s part of the coarse cells of a mesh's cells; leaves it null if there are
/// none. `fine`: as above.
void add_coarse_cells(const Mesh& mesh, const std::vector<int>& node_owner, int rank, int ranks, LocalMesh& fine);

}  // namespace ixos

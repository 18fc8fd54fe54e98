/// One rank's share of a mesh in the form that ParaView shows correctly.
#pragma once
#include <utility>
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// The description of the whole mesh in a file of one rank.
struct ExodusShare {
  int ranks = 1;
  long long global_nodes = 0;
  long long global_cells = 0;
  std::vector<int> global_block_cells;  ///< by block
  std::vector<int> node_ids;            ///< from 1, by node
  std::vector<int> cell_ids;            ///< from 1, by cell, block after block
};

/// The rank's own cells and their nodes as a separate mesh. An enriched cell becomes a row of bilinear quadrilaterals,
/// or rows of trilinear hexahedra, one for each piece of its contact side (four along a Hermite side), so that the
/// curved side shows; an enriched quadratic cell becomes two quadratic ones, in 3D two by two. Their nodes are fixed
/// combinations of the mesh's. Their blocks get separate names: "body_contact", "body_contact_2". No two blocks or sets
/// have one name, see make_names_distinct().
struct OutputMesh {
  OutputMesh(const LocalMesh& local, int ranks);

  /// Returns the value at each node of a field given by local node.
  std::vector<double> nodal(const std::vector<double>& field) const;
  /// Returns the value at each cell of a block of a field given by local cell.
  std::vector<double> cell(std::size_t block, const std::vector<double>& field) const;

  Mesh mesh;
  ExodusShare description;
  std::vector<std::vector<int>> cells;  ///< by block: local cell that each cell of the mesh is (a part of)

 private:
  using Combination = std::vector<std::pair<int, double>>;  ///< local nodes and weights
  int add_node(const LocalMesh& local, Combination combination, int id);
  int own_node(const LocalMesh& local, int node);
  void add_cell(const LocalMesh& local, const LocalBlock& block, int cell, int cell_offset, ElementBlock& here);
  void add_sets(const LocalMesh& local);

  std::vector<Combination> combinations_;     ///< by node of the mesh
  std::vector<int> number_;                   ///< by local node: its number here, or -1
  std::vector<std::vector<int>> first_cell_;  ///< by block and local cell: its first cell here, or -1
};

}  // namespace ixos

/// A rank's part of a mesh.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/mesh.hpp"
#include "mesh/node_ties.hpp"

namespace ixos {

struct LocalRefinement;

struct LocalSide {
  int block;
  int cell;  ///< local; of a whole side set and a cell that is not here: -1 - its number in the Mesh's block
  int side;  ///< of the cell, from 0
  std::vector<int> nodes;  ///< local node numbers, in the order of side_nodes
  bool owned;              ///< its cell is owned by this rank: energies and forces count it here
  int part = 0;            ///< which part of the side it is, see SplitSides
};

struct LocalBlock {
  std::string name;
  CellType type = CellType::Quad4;
  std::vector<int> nodes;                ///< local node numbers, cells x nodes per cell
  std::vector<char> owned;               ///< per cell: energies count it on this rank
  std::vector<double> derivative_scale;  ///< see ElementBlock
  int points = 0;                        ///< see ElementBlock
  unsigned tied = 0;                     ///< see ElementBlock
  bool high_rule = false;                ///< some cells are curved, or all are rings, see own_rule()
  std::vector<int> original_cells;       ///< per cell: its number in the block of the Mesh
  int global_cells = 0;                  ///< of the block, on all ranks
  int number = 0;                        ///< among the blocks of the Mesh
  int cells() const { return static_cast<int>(owned.size()); }
};

/// A rank's owned nodes, then one layer of ghosts: the other nodes of every cell that touches an owned node. A rank
/// assembles only the rows of its owned nodes, and needs no cell of another rank for that. The nodes of each rank have
/// consecutive global numbers. A cell belongs to the rank that owns its first node.
///
/// Tied nodes come last. They have no unknowns, and belong to the rank of their first master; a cell touches what its
/// tied nodes follow, and all that they follow is local.
struct LocalMesh {
  int dimension = 2;
  int owned_nodes = 0;
  std::vector<long long> global_ids;  ///< per local node; consecutive over the ranks, then tied nodes
  NodeTies ties;                      ///< of the last local nodes
  std::vector<int> original_ids;      ///< per local node; the number in the Mesh
  /// Per local node: the id that the program gave it in a DistributedMesh; empty for a part of a Mesh.
  std::vector<long long> program_ids;
  std::vector<double> coordinates;  ///< local nodes x dimension [L0]
  std::vector<char> derivative;     ///< empty, or per local node: it stands for a derivative, see Mesh::derivative_of
  std::vector<LocalBlock> blocks;   ///< all blocks of the mesh, possibly empty here
  std::vector<std::string> side_set_names;
  std::vector<std::vector<LocalSide>> side_sets;  ///< parallel to side_set_names
  /// Side sets by name of which this rank has all sides, in the order of the Mesh, and all nodes: those of which others
  /// were asked for in localize().
  std::map<std::string, std::vector<LocalSide>> whole_side_sets;
  std::vector<std::string> node_set_names;
  std::vector<std::vector<int>> node_sets;  ///< local node numbers, ghosts included
  int linear_nodes = -1;                    ///< see Mesh
  int plain_nodes = -1;                     ///< see Mesh
  bool axisymmetric = false;                ///< see Mesh
  double largest_radius = 0;                ///< of the nodes of all ranks, if the mesh is axisymmetric [L0]
  double level_width = 1e300;               ///< mean_level_width() of the whole mesh, if it was known
  long long global_nodes = 0;               ///< without those that are tied
  long long global_tied = 0;
  long long global_cells = 0;
  std::shared_ptr<const LocalRefinement> refinement;  ///< null, or the coarse cells for methods of several levels

  int nodes() const { return static_cast<int>(global_ids.size()); }
  bool is_tied(int node) const { return ties.is_tied(node); }
  /// Returns whether this rank counts the node, so that one rank does.
  bool owns(int node) const { return (is_tied(node) ? ties.begin(node)->master : node) < owned_nodes; }
  /// Returns whether the rank assembles forces on the node: it owns it, or one of its masters.
  bool has_row(int node) const;
  /// Returns the dimension of the body: 3 if it is one of revolution.
  int body_dimension() const { return axisymmetric ? 3 : dimension; }
  bool is_derivative(std::size_t node) const { return !derivative.empty() && derivative[node] != 0; }
  /// Returns the number that the program which gave the mesh has for the node: its id in a DistributedMesh, or its
  /// number in the Mesh, from 0.
  long long program_id(std::size_t node) const { return program_ids.empty() ? original_ids[node] : program_ids[node]; }
  /// Returns the number of the node in messages: the program's id, or the number in the Mesh from 1, as files count.
  long long message_number(std::size_t node) const {
    return program_ids.empty() ? original_ids[node] + 1LL : program_ids[node];
  }
  /// Returns whether enrich() added the node.
  bool is_added(std::size_t node) const { return plain_nodes >= 0 && original_ids[node] >= plain_nodes; }
  /// Returns whether raise_order() or enrich() added the node.
  bool is_of_ixos(std::size_t node) const {
    return is_added(node) || (linear_nodes >= 0 && original_ids[node] >= linear_nodes);
  }
  /// Returns the index of the set of that name. Throws InputError that names the nearest name if no set has it.
  std::size_t side_set(const std::string& name) const;
  std::size_t node_set(const std::string& name) const;
  /// Returns the indices of the blocks of that name, several if some cells are enriched. Throws InputError likewise.
  std::vector<std::size_t> blocks_named(const std::string& name) const;
};

/// Returns this rank's part of a whole mesh that is the same on all ranks. Ixos partitions the nodes, or `node_owner`
/// has each node's rank. Throws InputError, on all ranks, if they pass different meshes or owners, if the mesh does not
/// pass check_arrays(), refuse_repeated_cells(), require_one_order(), require_shared_middles() and check_cells(), or if
/// an owner is no rank. A mesh that enrich() has changed must have passed the first two before. `whole`: as localize().
/// Collective.
LocalMesh local_part(const Mesh& mesh, const Comm& comm, const std::vector<std::string>& whole = {});
LocalMesh local_part(const Mesh& mesh, const std::vector<int>& node_owner, const Comm& comm,
                     const std::vector<std::string>& whole = {});

/// Extracts rank `rank`'s part of the mesh. `whole`: side sets of which every rank gets all sides, with their nodes as
/// ghosts: the surfaces of pairs, see SurfacePair. Throws InputError if one does not exist.
/// A tied node's owner plays no part.
LocalMesh localize(const Mesh& mesh, const std::vector<int>& node_owner, int rank, int ranks,
                   const std::vector<std::string>& whole = {});

}  // namespace ixos

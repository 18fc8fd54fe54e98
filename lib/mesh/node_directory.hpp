/// Nodes of a distributed mesh by their ids.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos {

/// A node of a distributed mesh.
struct NodeEntry {
  long long id = -1;
  long long number = -1;      ///< position in the ascending order of all ids: the same for every distribution
  int owner = -1;             ///< rank; -1: no rank owns a node of that id
  int place = -1;             ///< position among the owner's nodes
  std::array<double, 3> x{};  ///< [L0]; the third is 0 in two dimensions
};

/// A node set, by its number, and the id of one of its nodes.
struct SetMember {
  long long id;
  int set;
};

/// The nodes of all ranks. Each rank keeps the entries of an interval of ids, so that no rank keeps all; few ids per
/// interval, or many, cost balance only.
class NodeDirectory {
 public:
  /// `ids` are those of the nodes that this rank owns, at least 0; `coordinates` are theirs, row by row. Throws
  /// InputError, on all ranks, if two nodes have one id or if there are no nodes. Collective.
  NodeDirectory(const std::vector<long long>& ids, const std::vector<double>& coordinates, int dimension,
                const Comm& comm);

  /// Returns the number of nodes of all ranks.
  long long size() const { return size_; }
  /// Returns the entries of the ids, in their order. Collective.
  std::vector<NodeEntry> find(const std::vector<long long>& ids) const;
  /// Returns, for each set, the positions in `ids` of its members, in ascending order. `members` are those that this
  /// rank contributes: a node is a member if any rank contributes it. Collective.
  std::vector<std::vector<int>> find_members(const std::vector<SetMember>& members, std::size_t sets,
                                             const std::vector<long long>& ids) const;

 private:
  std::size_t keeper(long long id) const;
  /// Sends each id to its keeper.
  std::vector<std::vector<long long>> ask(const std::vector<long long>& ids) const;

  Comm comm_;
  long long size_ = 0;
  long long first_ = 0;           ///< least id
  unsigned long long width_ = 1;  ///< of each rank's interval
  std::vector<NodeEntry> kept_;   ///< in ascending order of ids
};

}  // namespace ixos

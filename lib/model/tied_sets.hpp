/// Conditions on tied nodes.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// A tied node moves as its masters do, so conditions hold these alone. All of them must be held in the same way, by
/// whichever condition: otherwise the motion of the tied node is not the one that its own condition asks for.
class TiedConditions {
 public:
  /// Returns whether a condition holds a master as that of the tied node would.
  using IsHeld = std::function<bool(int master)>;

  /// Adds a tied node of a set that a condition names; local number.
  void add(const std::string& node_set, int node, IsHeld is_held);
  /// Throws InputError, on all ranks, if a master is not held. Collective if the mesh has ties.
  void check(const LocalMesh& mesh, const Comm& comm) const;

 private:
  struct Condition {
    std::string node_set;
    int node;
    IsHeld is_held;
  };
  std::vector<Condition> conditions_;
};

}  // namespace ixos

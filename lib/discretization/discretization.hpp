/// Where the unknowns are, and which of them are coupled.
#pragma once
#include <vector>

#include "discretization/dof_space.hpp"
#include "discretization/pattern.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// A rank's mesh, its degrees of freedom, and the sparsity of matrices. Nodes that share a cell are coupled; terms may
/// couple more. References to its parts stay valid; what was derived from the pattern (offsets, matrices,
/// factorisations) is of one version and must be renewed when the version has changed.
class Discretization {
 public:
  Discretization(LocalMesh mesh, const Comm& comm, GlobalUnknowns globals = {});
  Discretization(const Discretization&) = delete;
  Discretization& operator=(const Discretization&) = delete;

  const LocalMesh& mesh() const { return mesh_; }
  const DofSpace& space() const { return space_; }
  const Pattern& pattern() const { return pattern_; }
  /// Returns the number of changes of the pattern, equal on all ranks.
  long version() const { return version_; }

  /// Couples all nodes of each stencil with each other, besides those that are coupled already. Local node numbers; the
  /// rank that owns a node must name all stencils of the node. Throws std::out_of_range if a node is not local.
  /// Collective: all ranks call it.
  void couple(const std::vector<std::vector<int>>& stencils);
  /// Couples all nodes of each stencil likewise, in place of those of the last call of this function.
  void couple_for_now(std::vector<std::vector<int>> stencils);

 private:
  void check_local(const std::vector<std::vector<int>>& stencils) const;
  void renew_pattern();

  LocalMesh mesh_;
  DofSpace space_;
  std::vector<std::vector<int>> stencils_, stencils_for_now_;
  Pattern pattern_;
  long version_ = 0;
};

}  // namespace ixos

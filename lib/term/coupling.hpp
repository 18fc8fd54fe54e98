/// Nodes that the tangent of an interaction couples as bodies move.
#pragma once
#include <vector>

namespace ixos {

class Coupling {
 public:
  virtual ~Coupling() = default;
  /// Finds the nodes that the tangent couples near the displacement u. Returns whether they have changed on this rank.
  virtual bool update_stencils(const double* u) = 0;
  /// Returns the nodes that it found last: stencils as of Discretization::couple(). Entries of nodes that the pattern
  /// does not couple are left out of matrices.
  virtual std::vector<std::vector<int>> stencils() const = 0;
};

}  // namespace ixos

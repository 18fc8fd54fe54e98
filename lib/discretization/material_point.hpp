/// A named point of the body.
#pragma once
#include <vector>

#include "discretization/dof_space.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// A point fixed to the material: its displacement is the weighted sum of its nodes'. Nodes and weights are empty on
/// all ranks but one.
struct MaterialPoint {
  std::vector<int> nodes;  ///< local numbers
  std::vector<double> weights;

  /// Returns the interpolated value of a local array. Collective.
  std::vector<double> value(const DofSpace& space, const std::vector<double>& local) const;
};

/// Returns the point at reference coordinates x (D of them) [L0]. Throws InputError if it lies in no cell. Collective.
MaterialPoint locate(const LocalMesh& mesh, const DofSpace& space, const std::vector<double>& x);

}  // namespace ixos

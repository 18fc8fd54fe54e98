/// Moments of nodal forces.
#pragma once
#include <array>

#include "base/vector3.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Adds the moment x cross f of the force f at a local node about a point, with the node's place x at the displacement
/// u, a local array. The force of a derivative node is a moment: its arm is the derivative dx/ds. Components of the
/// force beyond the dimension are 0.
inline void add_nodal_moment(const LocalMesh& mesh, std::size_t node, const double* u,
                             const std::array<double, 3>& force, const std::array<double, 3>& point, double* moment) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::array<double, 3> arm{};
  for (std::size_t i = 0; i < d; ++i)
    arm[i] = mesh.coordinates[node * d + i] + u[node * d + i] - (mesh.is_derivative(node) ? 0.0 : point[i]);
  const std::array<double, 3> own = cross(arm, force);
  for (std::size_t i = 0; i < 3; ++i) moment[i] += own[i];
}

}  // namespace ixos

#include "model/axis.hpp"

#include "mesh/meridian.hpp"

namespace ixos {

void hold_axis(const LocalMesh& mesh, Constraints& constraints) {
  if (!mesh.axisymmetric) return;
  const std::vector<bool> on_axis = nodes_on_axis(mesh);
  for (int node = 0; node < mesh.nodes(); ++node)
    if (on_axis[static_cast<std::size_t>(node)] && !mesh.is_tied(node)) constraints.add(2 * node, 1.0, nullptr);
}

}  // namespace ixos

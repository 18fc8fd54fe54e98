#include "model/axis.hpp"

#include "mesh/meridian.hpp"

namespace ixos {

void hold_axis(const LocalMesh& mesh, const DofSpace& space, Constraints& constraints) {
  if (!mesh.axisymmetric) return;
  const double on_axis = axis_tolerance * space.maximum(largest_radius(mesh));
  for (int node = 0; node < mesh.nodes(); ++node) {
    const auto place = static_cast<std::size_t>(node);
    if (!mesh.is_derivative(place) && mesh.coordinates[2 * place] <= on_axis) constraints.add(2 * node, 1.0, nullptr);
  }
}

}  // namespace ixos

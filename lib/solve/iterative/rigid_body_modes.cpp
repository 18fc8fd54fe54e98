#include "solve/iterative/rigid_body_modes.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <array>

namespace ixos {

Teuchos::RCP<MultiVector> rigid_body_modes(const Model& model) {
  const auto modes = rigid_body_modes(model.mesh(), model.space(), model.constraints().dofs());
  const auto view = modes->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t m = 0; m < modes->getNumVectors() && model.mesh().owned_nodes > 0; ++m)
    model.constraints().planes().project(&view(0, m), model.mesh().owned_nodes);
  return modes;
}

Teuchos::RCP<MultiVector> rigid_body_modes(const LocalMesh& mesh, const DofSpace& space,
                                           const std::vector<int>& constrained) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto nodes = static_cast<std::size_t>(mesh.owned_nodes);
  std::array<double, 4> sums{};
  for (std::size_t n = 0; n < nodes; ++n)
    if (!mesh.is_derivative(n)) {
      for (std::size_t i = 0; i < d; ++i) sums[i] += mesh.coordinates[n * d + i];
      sums[3] += 1;
    }
  space.sum(sums.data(), 4);

  const std::size_t modes = d == 2 ? 3 : 6;
  auto result = Teuchos::rcp(new MultiVector(space.owned_map(), modes));
  const auto view = result->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t n = 0; n < nodes; ++n) {
    // A derivative node does not take part in translations, and its "place" is a direction.
    const double place = mesh.is_derivative(n) ? 0.0 : 1.0;
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < d; ++i) {
      x[i] = mesh.coordinates[n * d + i] - place * sums[i] / sums[3];
      for (std::size_t m = 0; m < modes; ++m) view(n * d + i, m) = m == i ? place : 0.0;
    }
    // Rotation in the plane of axes i and j: (-x_j, x_i).
    for (std::size_t r = 0; r < modes - d; ++r) {
      const std::size_t i = d == 2 ? 0 : r, j = (i + 1) % d;
      view(n * d + i, d + r) = -x[j];
      view(n * d + j, d + r) = x[i];
    }
  }
  for (int dof : constrained)
    if (dof < space.owned())
      for (std::size_t m = 0; m < modes; ++m) view(static_cast<std::size_t>(dof), m) = 0;
  return result;
}

Teuchos::RCP<MultiVector> node_coordinates(const Model& model) {
  return node_coordinates(model.mesh(), model.space().comm());
}

Teuchos::RCP<MultiVector> node_coordinates(const LocalMesh& mesh, const Comm& comm) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(mesh.global_nodes),
                                        static_cast<std::size_t>(mesh.owned_nodes), 0, comm));
  auto result = Teuchos::rcp(new MultiVector(map, d));
  const auto view = result->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.owned_nodes); ++n)
    for (std::size_t i = 0; i < d; ++i) view(n, i) = mesh.coordinates[n * d + i];
  return result;
}

}  // namespace ixos
